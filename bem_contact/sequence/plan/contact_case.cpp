#include "bem_contact/sequence/plan/contact_case.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/influence/requirements.hpp"
#include "bem_contact/sequence/models.hpp"
#include "bem_contact/sequence/plan/model_choice.hpp"
#include "bem_contact/sequence/plan/plan_grid.hpp"
#include "bem_contact/sequence/plan/settings.hpp"

#include <cmath>
#include <fmt/format.h>

namespace bem_contact {

namespace {

/// 1. Share of the wheel's or roller's radius by which that of an influence file may differ.
constexpr double radius_tolerance = 0.01;
/// rad. An influence file's roller has its axis parallel to y of its own section, and so it cannot be
/// inclined. Inclined by as much, its radius differs over a head 70 mm wide by 0.7 % of 500 mm, within the
/// tolerance of radii. An inclination of 1:20 is less.
constexpr double largest_roller_inclination = 0.051;

void require_radius(const InfluenceStrip& wheel, double wheel_radius) {
  if (wheel.invariance == Invariance::revolution &&
      std::abs(wheel.reference_radius - wheel_radius) > radius_tolerance * wheel_radius)
    throw InputError(fmt::format("The influence functions of '{}' do not belong to this wheel", wheel.body),
                     fmt::format("they are for a nominal radius of {:g} mm, position.wheel_radius is {:g} mm",
                                 wheel.reference_radius, wheel_radius),
                     "Compute influence functions of this wheel, or correct the radius.");
}

/// How far the axis of a rail lies below the origin of its section, in words.
std::string axis_in_words(double below) {
  if (below == 0)
    return "a straight rail";
  return fmt::format("a body whose axis lies {:.6g} mm {} the origin of its profile", std::abs(below),
                     below > 0 ? "below" : "above");
}

/// The file and the scene have the same roller, or both a straight rail.
void require_roller(const InfluenceStrip& rail, const WheelOnRail& pair) {
  const double of_file = rail.invariance == Invariance::revolution ? -rail.reference_radius : 0;
  const double asked = pair.roller ? pair.roller->radius(pair.rail_pose.origin) : 0;
  if (std::abs(of_file - asked) > radius_tolerance * asked)
    throw InputError(
        fmt::format("The influence functions of '{}' do not belong to this rail", rail.body),
        fmt::format("they are for {}, and the scene has {}", axis_in_words(of_file), axis_in_words(asked)),
        "Compute influence functions with this body.roller_radius, or correct rail.roller_radius.");
  if (asked > 0 && std::abs(pair.rail_pose.angle) > largest_roller_inclination)
    throw InputError(fmt::format("The influence functions of '{}' do not belong to this roller", rail.body),
                     fmt::format("the roller's axis is parallel to y of its section, and the scene turns the "
                                 "section by {:.3g} rad against its axis, at most {:g} are taken",
                                 pair.rail_pose.angle, largest_roller_inclination),
                     "Give the profile as it stands on its roller, without an inclination.");
}

/// Throws InputError where influence files (null: none) are of other bodies than those that are placed.
void require_bodies(const InfluenceStrip* rail, const InfluenceStrip* wheel, const WheelOnRail& pair,
                    bool own_shape) {
  if (rail && own_shape)
    require_profile(*rail, pair.rail.name(), pair.rail.digest());
  if (wheel && own_shape)
    require_profile(*wheel, pair.wheel.name(), pair.wheel.digest());
  if (rail)
    require_roller(*rail, pair);
  if (wheel)
    require_radius(*wheel, pair.wheel_radius);
}

/// The stresses of the bodies that have a file. Before anything is solved: who asks for them waits for them.
void add_files_of_stresses(ContactCase& asked, SequenceFiles& files) {
  const auto read = [&](const Body& body) {
    std::shared_ptr<const inside::FileOfStresses> out;
    if (!body.influence.empty()) {
      out = files.stresses(body.influence);
      require_material(out->strip, body.material);
    }
    return out;
  };
  asked.rail_inside = read(asked.setup.rail);
  asked.wheel_inside = read(asked.setup.wheel);
  if (const WheelRailGeometry* placed = asked.setup.wheel_rail())
    require_bodies(asked.rail_inside ? &asked.rail_inside->strip : nullptr,
                   asked.wheel_inside ? &asked.wheel_inside->strip : nullptr, placed->pair, asked.own_shape);
}

/// Throws InputError where more elements are asked for than the model serves.
void require_elements(const SceneFile& scene) {
  const std::optional<Model> model = scene.solver.model;
  if (depends_on_both_rows(model) && scene.grid.elements.value_or(0) > most_elements_full)
    throw InputError(
        fmt::format("grid.elements = {} is too large for the model {}", *scene.grid.elements, name_of(model)),
        fmt::format("at most {} elements in contact are allowed, since its influence numbers {} on "
                    "both rows",
                    int(most_elements_full), model ? "depend" : "may depend"),
        "Give fewer elements, or solver.model = \"halfspace\".");
}

/// The size of elements that are chosen must be one that the influence files of the chosen model have
/// numbers for.
bool foresees_fem(const ContactCase& asked) {
  const SceneFile& scene = asked.scene;
  return !scene.solver.model && asked.estimate && (scene.grid.elements || scene.grid.accuracy) &&
         choose_model(traits_of(asked, *asked.estimate), request_of(asked)).model == model_of_files();
}

/// One for each area that the estimate has; where nothing touches, at the reference point.
std::vector<TangentPlane> estimated_planes(const ContactCase& contact) {
  const WheelRailGeometry& placed = *contact.setup.wheel_rail();
  std::vector<TangentPlane> out;
  for (const EstimatedArea& area : estimated_areas(*contact.estimate, pair_compliance(contact.setup))) {
    const CurvePoint p = placed.pair.rail_at(area.s);
    if (!out.empty())
      out.back().s_to = 0.5 * (out.back().at.s + p.s);
    out.push_back({{p.position, p.s, p.delta, area.x}});
  }
  if (out.empty())
    out.push_back({placed.reference});
  return out;
}

/// The arc length on the rail of a station of its influence file, mm; of a rail of sections that of the file
/// before the contact. Nothing without a file.
std::optional<double> origin_of_rows(const ContactCase& contact) {
  const PairFiles& files = contact.files;
  if (files.rail)
    return files.rail->strip().stations.front().s;
  if (files.sections.empty())
    return std::nullopt;
  try {
    const ReferencePoint& at = contact.setup.reference();
    const std::vector<RowsOnStrip> strips = rows_on_files(
        contact.setup, files, {{{at.s, at.position, at.delta}}, {at.s}, {}}, contact.scene.grid.ds);
    if (strips.empty())
      return std::nullopt;
    return strips.front().file->strip().stations.front().s + at.s - strips.front().s.front();
  } catch (const OffStripError&) { // the contact is beyond the files, and other models may serve it
    return std::nullopt;
  }
}

/// Files cannot leave these lists empty; a program can.
void require_quantities(const char* key, std::size_t named) {
  if (named == 0)
    throw InputError(fmt::format("{} is empty", key), "an accuracy is of something",
                     "Name one quantity or more, for instance forces.");
}

} // namespace

ContactCase prepare_case(const SceneFile& scene, SequenceFiles& files, PrepareOptions options) {
  require_quantities("grid.accuracy_of", scene.grid.accuracy_of.size());
  require_quantities("solver.model_tolerance_of", scene.solver.model_tolerance_of.size());
  if (scene.wheelset.force)
    throw InputError("This scene is one of both wheels of a wheelset", "wheelset.force is given",
                     "Solve it with bem_contact wheelset (Python: wheelset), or give load.force instead.");
  require_elements(scene);
  const bool patch = scene.kind == SceneKind::patch;
  ContactCase out{scene,
                  patch ? set_up_patch(scene) : set_up_contact(scene, files.profiles(scene)),
                  {},
                  nullptr,
                  options.own_shape,
                  options.lateral_force};
  if (scene.stresses.asks_for_bodies())
    add_files_of_stresses(out, files);
  if (!patch)
    out.estimate =
        std::make_shared<const ContactEstimate>(estimate_contact(out.setup, options.foresee_shear));
  if (options.read_influence || (scene.solver.model && has_files(*scene.solver.model)) || foresees_fem(out))
    return with_influence(std::move(out), files);
  return out;
}

ContactCase with_influence(ContactCase asked, SequenceFiles& files) {
  if (asked.files.of_rail() || asked.files.wheel) // read and checked before
    return asked;
  asked.files = files.influence(asked.setup.rail, asked.setup.wheel);
  if (const WheelRailGeometry* placed = asked.setup.wheel_rail())
    require_bodies(asked.files.rail ? &asked.files.rail->strip() : nullptr,
                   asked.files.wheel ? &asked.files.wheel->strip() : nullptr, placed->pair, asked.own_shape);
  return asked;
}

std::pair<int, int> rows_on_strips(const ContactCase& contact, const GridPlan& plan) {
  return covered_rows(rows_on_files(contact.setup, contact.files, contact.setup.rows_on(plan), plan.ds),
                      plan.ds, plan.rows);
}

void require_strips(const ContactCase& contact, const GridPlan& plan) {
  require_strips(rows_on_files(contact.setup, contact.files, contact.setup.rows_on(plan), plan.ds), plan.ds);
}

GridPlan first_plan(const ContactCase& contact, const SceneFile::Grid& asked, bool on_strips) {
  GridPlan plan;
  if (const PatchGeometry* patch = contact.setup.patch()) {
    plan = patch->plan();
  } else {
    plan = plan_grid(*contact.estimate, asked, origin_of_rows(contact).value_or(0.5 * asked.ds));
    if (contact.scene.grid.planar)
      plan.planes = estimated_planes(contact);
    // The estimate is generous: give up rows off the strips, as long as the contact does not need them.
    if (on_strips && !asked.rows && !asked.ms) {
      const auto [first, last] = rows_on_strips(contact, plan);
      const double deepest_s = contact.setup.wheel_rail()->touch.front().rail_s;
      const int deepest = static_cast<int>(std::lround((deepest_s - plan.s(0)) / plan.ds));
      if (first <= deepest && deepest <= last) {
        plan.first += first;
        plan.rows = last - first + 1;
      }
    }
  }
  if (on_strips)
    require_strips(contact, plan);
  return plan;
}

} // namespace bem_contact
