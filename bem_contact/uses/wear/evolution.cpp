#include "bem_contact/uses/wear/evolution.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/influence/influence_file.hpp"
#include "bem_contact/influence/requirements.hpp"
#include "bem_contact/profile/messages.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "bem_contact/scene/derivative_inputs.hpp"
#include "bem_contact/sequence/models.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "bem_contact/sequence/shared_files.hpp"

#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>
#include <utility>

namespace bem_contact::wear {

namespace {

constexpr const char* as_given = "Correct it.";
constexpr double mm_per_km = 1e6;

void use_profile(SceneFile::Side& side, const std::filesystem::path& file,
                 const std::filesystem::path& influence) {
  side.influence = influence.empty() ? "" : std::filesystem::absolute(influence).string();
  side.profile = std::filesystem::absolute(file).string();
  side.reading = {};
  side.reading.profile_z = ProfileZ::down;
  side.reading.keep_origin = true; // these are the section's own coordinates already
}

WornBody body_of(const SceneFile::Side& side, ProfileKind kind, const std::filesystem::path& folder) {
  WornBody body;
  body.points = points_of(named_profile(side.profile, kind, folder, side.reading));
  body.depth.assign(body.points.size(), 0.0);
  return body;
}

/// In the order of wear_columns().
constexpr double WearRow::*members[] = {&WearRow::step,       &WearRow::revolutions, &WearRow::mileage,
                                        &WearRow::rail_depth, &WearRow::wheel_depth, &WearRow::rail_area,
                                        &WearRow::wheel_area, &WearRow::smoothing,   &WearRow::smoothed_off};
template <std::size_t which> double of_row(const WearRow& row) {
  return row.*members[which];
}

} // namespace

double WornPair::rail_depth() const {
  double depth = rail.largest();
  for (const WornSection& section : sections)
    depth = std::max(depth, section.worn.largest());
  return depth;
}

std::vector<CollectiveCase> collective_of(const SweepFile& sweep, CaseRange cases, const std::string& model) {
  std::vector<CollectiveCase> out;
  const std::vector<std::size_t> passages = passages_of(sweep);
  for (std::size_t i = cases.first; i < cases.last; ++i)
    out.push_back({with_model(sweep.scene(i), model), sweep.weight(i), passages[i]});
  return out;
}

std::vector<CaseOnTrack> on_track(const std::vector<CollectiveCase>& cases) {
  std::vector<CaseOnTrack> out;
  out.reserve(cases.size());
  for (const CollectiveCase& one : cases)
    out.push_back({one.scene.position.uneven.along, one.weight, one.passage});
  return out;
}

WornPair unworn(const SceneFile& scene) {
  WornPair out{{}, body_of(scene.wheel, ProfileKind::wheel, scene.folder), 0};
  if (scene.rail.has_sections())
    out.sections = unworn_sections(scene);
  else
    out.rail = body_of(scene.rail, ProfileKind::rail, scene.folder);
  return out;
}

KeptPair unworn_influence(const SceneFile& scene, const WornPair& unworn) {
  const auto kept = [&](const SceneFile::Side& side, ProfileKind kind, const WornBody& body) {
    if (side.influence.empty())
      return KeptInfluence{}; // the solution says what is missing
    KeptInfluence out{scene.folder / side.influence, body.points};
    const ProfileCurve curve = named_profile(side.profile, kind, scene.folder, side.reading);
    require_profile(InfluenceFile(out.file).strip(), curve.name(), curve.digest());
    return out;
  };
  return {kept(scene.rail, ProfileKind::rail, unworn.rail),
          kept(scene.wheel, ProfileKind::wheel, unworn.wheel)};
}

void write_profiles(const WornPair& now, const std::filesystem::path& folder) {
  if (now.sections.empty())
    write_profile(folder / "rail.txt", now.rail.points);
  write_sections(now.sections, folder);
  write_profile(folder / "wheel.txt", now.wheel.points);
}

SceneFile with_profiles(SceneFile scene, const WornPair& now, const std::filesystem::path& folder,
                        const KeptPair& influence) {
  use_profile(scene.rail, folder / "rail.txt", influence.rail.file);
  use_profile(scene.wheel, folder / "wheel.txt", influence.wheel.file);
  if (!now.sections.empty())
    use_sections(scene.rail, now.sections, folder);
  return scene;
}

std::shared_ptr<SequenceFiles> read_profiles_of_step(const SceneFile& scene, const WornPair& now,
                                                     const std::filesystem::path& folder) {
  const CollectedMessages unsaid; // nobody can smooth what wear itself has smoothed and written
  auto files = shared_files();
  read_profiles(with_profiles(scene, now, folder), *files);
  return files;
}

std::vector<CaseWear> wear_of_cases(const WornPair& now, std::span<const CollectiveCase> cases,
                                    const EvolutionOptions& options, const std::filesystem::path& folder,
                                    const KeptPair& influence, std::shared_ptr<SequenceFiles> files) {
  if (!files && !cases.empty())
    files = read_profiles_of_step(cases.front().scene, now, folder);
  Sequence sequence({.displacements = false, .own_shape = false}, std::move(files));
  std::vector<CaseWear> out;
  for (const CollectiveCase& one : cases) {
    const SceneFile scene =
        with_profiles(one.scene, now, folder, needs_influence(one.scene) ? influence : KeptPair{});
    const SceneResult result = sequence.solve(scene, options.stop);
    if (!certified(result))
      throw ConvergenceError("A case of the load collective has no certified result",
                             fmt::format("lateral displacement {:g} mm, {:g} revolutions so far",
                                         scene.position.lateral, now.revolutions),
                             "Solve it alone with these profiles to see why.");
    Wear wear = wear_of(result, options.law);
    out.push_back({std::move(wear.rail), std::move(wear.wheel), std::move(wear.on_sections)});
  }
  return out;
}

bool needs_influence(const SceneFile& scene) {
  const bool files = scene.rail.has_influence() && scene.wheel.has_influence();
  return scene.solver.model ? has_files(*scene.solver.model) : files;
}

std::optional<WearMap> wear_map_of(const SceneFile& scene) {
  const SceneFile::Wear& w = scene.wear;
  if (w == SceneFile::Wear{})
    return std::nullopt;
  return WearMap{w.speeds, w.pressures, w.coefficients};
}

void validate(const std::vector<CollectiveCase>& cases, const EvolutionOptions& o, double depth) {
  validate(o.law);
  const auto positive = [](double value) { return std::isfinite(value) && value > 0; };
  if (!positive(depth))
    throw InputError(fmt::format("Wear cannot end at a depth of {} mm", depth),
                     "depths are positive and finite",
                     "Give the depth at the deepest place at which to end.");
  if (!positive(o.cap) || !positive(o.passages) || !positive(o.kept_turn) || !std::isfinite(o.smoothing) ||
      o.smoothing < 0 || !(o.rail || o.wheel))
    throw InputError("Wear cannot be computed with these options",
                     "depth of a step, passages and kept turn must be positive, smoothing not negative, and "
                     "one body must wear",
                     as_given);
  if (cases.empty())
    throw InputError("The load collective is empty", "there is nothing to solve", "Give at least one case.");
  for (const CollectiveCase& one : cases) {
    if (!positive(one.weight))
      throw InputError(fmt::format("A case of the load collective has the weight {}", one.weight),
                       "weights must be positive", as_given);
    const SceneFile &scene = one.scene, &first = cases.front().scene;
    refuse_derivatives(scene, "a profile that wears");
    if (scene.kind != SceneKind::wheel_rail)
      throw InputError("This scene cannot wear", "it has no profiles", "Give kind = \"wheel_rail\".");
    if (scene.wheelset.force)
      throw InputError(
          "The cases of [sweep] are wheelsets, of which [wear] has no collective",
          "one pair of profiles wears under the loads of one wheel, and [wheelset] is given",
          "Leave out [sweep] for what one wheelset wears away, or give load.force instead of [wheelset].");
    if (scene.changes_along() && (scene.position.uneven.given() || scene.wheel.has_sections()))
      refuse_uneven("An uneven wheel or rail cannot wear",
                    "profiles that wear are the same all round the wheel, and along the rail unless it is "
                    "given by its sections");
    if (!(scene.rail == first.rail) || !(scene.wheel == first.wheel))
      throw InputError("The cases of the load collective have different bodies",
                       "one pair of profiles wears under all of them", "Sweep over other keys.");
    if (!(scene.wear == first.wear))
      throw InputError("The cases of the load collective have different wear maps",
                       "one law holds for all of them", "Sweep over other keys.");
  }
  if (cases.front().scene.rail.has_sections())
    passage_places(on_track(cases));
}

std::span<const ColumnOf<WearRow>> wear_columns() {
  static constexpr ColumnOf<WearRow> columns[] = {
      {"step", "1", "of the study, 0: unworn", of_row<0>},
      {"revolutions", "1", "of the wheel so far", of_row<1>},
      {"mileage", "km", "that the wheel has run so far", of_row<2>},
      {"rail_depth", "mm", "largest depth gone from the rail", of_row<3>},
      {"wheel_depth", "mm", "largest depth gone from the wheel", of_row<4>},
      {"rail_area", "mm2", "gone from the rail's section", of_row<5>},
      {"wheel_area", "mm2", "gone from the wheel's section", of_row<6>},
      {"smoothing", "mm", "shortest wavelength of the wear of this step", of_row<7>},
      {"smoothed_off", "1", "what smoothing took of the deepest place of this step", of_row<8>}};
  return columns;
}

WearRow wear_row(std::span<const double> values) {
  WearRow row;
  for (std::size_t i = 0; i < std::size(members); ++i)
    row.*members[i] = values[i];
  return row;
}

WearRow history_row(int step, const WornPair& pair, double wheel_radius) {
  return {.step = double(step),
          .revolutions = pair.revolutions,
          .mileage = pair.revolutions * 2 * std::numbers::pi * wheel_radius / mm_per_km,
          .rail_depth = pair.rail_depth(),
          .wheel_depth = pair.wheel.largest(),
          .rail_area = pair.rail.area,
          .wheel_area = pair.wheel.area,
          .smoothing = pair.smoothing,
          .smoothed_off = pair.smoothed_off};
}

} // namespace bem_contact::wear
