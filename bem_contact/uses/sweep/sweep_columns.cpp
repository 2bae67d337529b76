#include "bem_contact/uses/sweep/sweep_columns.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/scene/derivative_inputs.hpp"
#include "bem_contact/sequence/derivative_record.hpp"
#include "bem_contact/sequence/quantities.hpp"
#include "bem_contact/uses/sweep/replay_steps.hpp"
#include "bem_contact/uses/wheelset/quantities.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <iterator>
#include <utility>

namespace bem_contact {

namespace {

constexpr const char* model_column = "model";

/// "0 hertz, 1 halfspace ...; CSV: its name"
std::string model_numbers() {
  std::string out;
  for (std::size_t k = 0; k < model_words.size(); ++k)
    out += fmt::format("{}{} {}", k > 0 ? ", " : "", k, model_words[k].name);
  return out + "; CSV: its name";
}

/// Of a table of sequence/quantities.hpp.
template <class Table> std::vector<SweepColumn> columns_of_table(const Table& table) {
  std::vector<SweepColumn> all;
  with_errors(table, [&](const std::string& name, const Unit& unit, auto, const char* description,
                         const std::string& error_of) {
    all.push_back({name, unit.text(), description,
                   error_of.empty() ? record::Role::other : record::Role::error, error_of});
  });
  return all;
}

std::vector<SweepColumn> columns_of_a_contact() {
  std::vector<SweepColumn> all = columns_of_table(quantities());
  all.push_back({model_column, "1", model_numbers()});
  return all;
}

std::vector<SweepColumn> columns_of_wheelsets() {
  std::vector<SweepColumn> all = columns_of_table(wheelset_quantities());
  for (const WheelSide side : both_sides) {
    const auto add = [&](const char* name, const std::string& unit, const std::string& description) {
      all.push_back({fmt::format("{}_{}", name_of(side), name), unit,
                     fmt::format("{} wheel: {}", name_of(side), description),
                     side == WheelSide::right ? record::Role::right : record::Role::left, name});
    };
    for (const WheelQuantity& q : wheel_quantities())
      add(q.name, q.unit.rolling, q.meaning);
    add(model_column, "1", model_numbers());
  }
  all.push_back({"warning_count", "1", "warnings of both wheels"});
  return all;
}

/// Of derivatives with respect to one number.
void add_columns(std::vector<SweepColumn>& all, const SceneNumber& input) {
  for (const std::string_view name : derived_totals())
    all.push_back({fmt::format("{}_by_{}", name, input.name),
                   unit_per(quantity(name).unit.of(false), input.unit),
                   fmt::format("what {} changes by per unit of {}, on these elements", name, input.key)});
  for (const auto& [side, word] : {std::pair{"below", "smaller"}, std::pair{"above", "larger"}})
    all.push_back(
        {fmt::format("{}_{}", input.name, side), input.unit,
         fmt::format("{} may be so much {} until an element changes its state; nan: any", input.key, word)});
}

/// In the order of the scene's columns. Those of a run lie on lines between steps that were solved, which
/// stated errors judge; derivatives have none.
std::vector<SceneNumber> derived_by(const SweepFile& sweep) {
  SceneFile scene = sweep.first_scene();
  if (scene.derivatives.empty())
    return {};
  const auto refuse = [](const char* why, const char* what_to_do) {
    throw InputError("There are no derivatives here", why, what_to_do);
  };
  if (sweep.replay)
    refuse(
        "replay does not solve every step, and nothing says how well they lie between those that it solves",
        "Leave out derivatives, or give the steps that you ask about as a sweep.");
  if (!profile_inputs(scene).empty())
    refuse("the points of a profile are a table of each case, and a sweep has a line for each",
           "Leave rail_profile and wheel_profile out of derivatives, or solve such cases one by one.");
  return derivative_inputs(scene);
}

void add_derivatives(const InputDerivatives* found, std::vector<double>& values) {
  if (!found) {
    values.resize(values.size() + derived_totals().size() + 2, std::nan(""));
    return;
  }
  std::ranges::copy(found->totals, std::back_inserter(values));
  for (const double reach : {found->below, found->above})
    values.push_back(std::isfinite(reach) ? reach : std::nan(""));
}

std::vector<SweepColumn> columns_of_wheelset_patches() {
  std::vector<SweepColumn> all = columns_of_table(patch_quantities());
  all.push_back(
      {"left", "1", "1: of the left wheel, which counts y, s, Fy, Mz, eta and phi to the left; 0: right"});
  return all;
}

} // namespace

SweepColumns columns_of_contacts(const SweepFile& sweep) {
  if (sweep.first_scene().wheelset.force)
    return {columns_of_wheelsets(), columns_of_wheelset_patches(), {}};
  SweepColumns out{columns_of_a_contact(), columns_of_table(patch_quantities()), {}};
  for (const SceneNumber& input : derived_by(sweep)) {
    add_columns(out.cases, input);
    out.inputs.push_back(input.name);
  }
  return out;
}

SweepColumns columns_of(const SweepFile& sweep) {
  SweepColumns out = columns_of_contacts(sweep);
  if (sweep.replay)
    std::ranges::move(replay_columns(*sweep.replay), std::back_inserter(out.cases));
  return out;
}

bool is_model(const SweepColumn& column) {
  return column.name == model_column || column.of == model_column;
}

std::vector<double> summary_of(const SceneResult& result, std::span<const std::string> inputs) {
  std::vector<double> values = values_of(quantities(), result);
  values.push_back(static_cast<double>(result.choice.model));
  for (const std::string& input : inputs) {
    const auto found = std::ranges::find(result.derivatives, input, &InputDerivatives::name);
    add_derivatives(found == result.derivatives.end() ? nullptr : &*found, values);
  }
  return values;
}

std::vector<double> summary_of(const WheelsetResult& result) {
  std::vector<double> values = values_of(wheelset_quantities(), result);
  for (const WheelSide side : both_sides) {
    for (const WheelQuantity& q : wheel_quantities())
      values.push_back(q.value(result.state, side));
    values.push_back(static_cast<double>(result.state.solved(side).choice.model));
  }
  values.push_back(static_cast<double>(result.warnings.size()));
  return values;
}

std::vector<std::vector<double>> patch_rows(const SceneResult& result) {
  std::vector<std::vector<double>> out;
  for (std::size_t i = 0; i < result.result.patches.size(); ++i)
    out.push_back(values_of(patch_quantities(), result, i));
  return out;
}

std::vector<std::vector<double>> patch_rows(const WheelsetResult& result) {
  std::vector<std::pair<double, std::vector<double>>> all; // with its force
  for (const WheelSide side : both_sides) {
    const SceneResult& wheel = result.state.solved(side);
    std::vector<std::vector<double>> own = patch_rows(wheel);
    for (std::size_t i = 0; i < own.size(); ++i) {
      own[i].push_back(side == WheelSide::left);
      all.emplace_back(wheel.result.patches[i].fn, std::move(own[i]));
    }
  }
  std::ranges::stable_sort(all, std::greater<>(), &decltype(all)::value_type::first);
  std::vector<std::vector<double>> out;
  for (auto& [force, values] : all)
    out.push_back(std::move(values));
  return out;
}

SweepNumbers numbers_of(std::span<const SweepCase> cases, const SweepColumns& columns) {
  SweepNumbers out;
  out.cases.resize(columns.cases.size());
  out.patches.resize(columns.patches.size());
  for (const SweepCase& one : cases) {
    for (std::size_t k = 0; k < out.cases.size(); ++k)
      out.cases[k].push_back(one.summary.empty() ? std::nan("") : one.summary.at(k));
    for (std::size_t patch = 0; patch < one.patches.size(); ++patch) {
      out.patch_case.push_back(one.index);
      out.patch_rank.push_back(patch + 1);
      for (std::size_t k = 0; k < out.patches.size(); ++k)
        out.patches[k].push_back(one.patches[patch].at(k));
    }
  }
  return out;
}

} // namespace bem_contact
