#include "bem_contact/app/wear/one_contact.hpp"

#include "bem_contact/app/output/output_names.hpp"
#include "bem_contact/app/output/print_answer.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/record/file_kinds.hpp"
#include "bem_contact/record/hdf5.hpp"
#include "bem_contact/scene/derivative_inputs.hpp"
#include "bem_contact/sequence/scene_record.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "bem_contact/sequence/uncertified.hpp"
#include "bem_contact/uses/wear/rates.hpp"
#include "bem_contact/uses/wheelset/solve_wheelset.hpp"

#include <fmt/format.h>

namespace bem_contact::app {

namespace {

/// One wheel and what it wears away.
struct WornContact {
  std::string name; ///< "right" or "left" of a wheelset, else ""
  wear::Wear wear;
  wear::WearRates rates;
  std::vector<double> t_gamma; ///< of each patch, N
};

WornContact worn(std::string name, const SceneResult& result, double axle_force, const wear::Law& law) {
  require_certified(result);
  WornContact out{std::move(name), wear::wear_of(result, law), {}, {}};
  out.rates = wear::rates_of(result, out.wear, axle_force);
  for (const PatchSummary& patch : result.result.patches)
    out.t_gamma.push_back(patch.T_gamma);
  return out;
}

std::vector<WornContact> worn_contacts(const SceneFile& scene, const wear::Law& law) {
  refuse_derivatives(scene, "the wear of a contact");
  if (!scene.wheelset.force) {
    const SceneResult result = Sequence().solve(scene);
    warn(result.warnings);
    return {worn("", result, 2 * result.result.totals.Fz, law)};
  }
  const WheelsetResult both = solve_wheelset(scene);
  warn(both.warnings);
  std::vector<WornContact> out;
  for (const WheelSide side : both_sides)
    out.push_back(worn(std::string(name_of(side)), both.state.solved(side), both.state.sum().force[2], law));
  return out;
}

std::string text_of(const WornContact& w) {
  const auto amount = [](double value) { return fmt::format("{:.4g}", value); };
  std::string patches;
  for (const double t : w.t_gamma)
    patches += fmt::format("{}{:.4g}", patches.empty() ? "" : " + ", t);
  const wear::WearRates& r = w.rates;
  return fmt::format(
      "{}T-gamma {} N{}\n"
      "wheel: {} mm at the deepest row and {} mm2 of its section per km\n"
      "rail: {} mm and {} mm2 per million axles; {} mm and {} mm2 per MGT (axles of {:.4g} t)\n",
      w.name.empty() ? "" : w.name + " wheel: ", amount(r.t_gamma),
      w.t_gamma.size() > 1 ? fmt::format(" (by patch {})", patches) : "", amount(r.wheel_depth),
      amount(r.wheel_area), amount(r.rail_depth), amount(r.rail_area), amount(r.mgt_rail_depth),
      amount(r.mgt_rail_area), r.axle_load);
}

record::Record record_of_all(record::Record out, const std::vector<WornContact>& all) {
  for (const WornContact& w : all)
    if (w.name.empty())
      out.append(record_of(w.rates, w.wear));
    else
      out.add(w.name, record_of(w.rates, w.wear));
  return out;
}

} // namespace

ExitCode wear_of_one_contact(const OneContactWear& asked) {
  const GivenScene given =
      read_given_scene_for({{"--output", asked.output, OutputForm::whole_file}}, asked.file, asked.model);
  const wear::Law law =
      wear::law_named(asked.law.law, asked.law.hardness, asked.law.speed, wear::wear_map_of(given.scene));
  const std::vector<WornContact> all = worn_contacts(given.scene, law);
  if (!asked.output.empty())
    record::write_hdf5(asked.output, record_of_all(headed(contact_wear_format, given, asked.output), all));
  std::string text;
  for (const WornContact& w : all)
    text += text_of(w);
  print_answer(record_of_all(headed(contact_wear_format), all), asked.json, text);
  return success;
}

} // namespace bem_contact::app
