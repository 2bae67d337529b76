#include "bem_contact/sequence/result_record.hpp"

#include "bem_contact/sequence/compared_quantities.hpp"
#include "bem_contact/sequence/conformity_record.hpp"
#include "bem_contact/sequence/derivative_record.hpp"
#include "bem_contact/sequence/quantities.hpp"
#include "bem_contact/sequence/uncertified.hpp"

#include <cmath>

namespace bem_contact {

namespace {

using record::Field;
using record::field;
using record::Number;
using record::Record;
using Shape = std::vector<std::size_t>;

/// Nothing where it is empty.
void add_words(Record& out, const char* name, const std::string& words) {
  if (words.empty())
    out.add(name, Record::Nothing{});
  else
    out.add(name, words);
}

Field points(const std::vector<Point2>& all, const char* meaning) {
  std::vector<double> values;
  for (const Point2& p : all)
    values.insert(values.end(), {p.y, p.z});
  return field(std::move(values), "mm", meaning, {all.size(), 2});
}

Shape grid_shape(const SceneResult& r) {
  return {static_cast<std::size_t>(r.problem.grid.ms), static_cast<std::size_t>(r.problem.grid.mx)};
}

void add_coordinates(Record& out, const SceneResult& r) {
  out.add("x", field(r.problem.grid.columns(), "mm", "middle of the columns, rolling direction"));
  for (const RowQuantity& q : row_quantities()) {
    std::vector<double> values;
    for (std::size_t row = 0; row < r.problem.rows.size(); ++row)
      values.push_back(q.value(r, row));
    if (!std::isnan(values.front()))
      out.add(q.name, field(std::move(values), q.unit.of(is_shift(r)), q.meaning));
  }
  out.add("rail_profile", points(r.bodies.rail_profile, "rail, fine near the contact: y, z"));
  out.add("wheel_profile",
          points(r.bodies.wheel_profile, "wheel at approach 0, fine near the contact: y, z"));
}

void add_fields(Record& out, const SceneResult& r) {
  const Shape shape = grid_shape(r);
  for (const ElementQuantity& q : element_quantities()) {
    if (!q.is_in(r))
      continue;
    const std::span<const double> stored = q.stored ? q.stored(r) : std::span<const double>();
    const char* unit = q.unit.of(is_shift(r));
    if (stored.size() == static_cast<std::size_t>(r.problem.grid.size()))
      out.add(q.name, Field{unit, q.meaning, shape, stored});
    else // computed, or not there, as the slip without friction
      out.add(q.name, field(q.values(r), unit, q.meaning, shape));
  }
}

/// [step][ms][mx]
Record step_fields(const SceneResult& r) {
  Record out;
  const auto add = [&](const char* name, std::vector<double> ContactResult::*member, const Unit& unit) {
    Shape shape = grid_shape(r);
    shape.insert(shape.begin(), r.history.size());
    std::vector<double> values;
    for (const ContactResult& step : r.history) {
      std::vector<double> one = step.*member;
      one.resize(static_cast<std::size_t>(r.problem.grid.size()), 0.0); // without friction there is no slip
      values.insert(values.end(), one.begin(), one.end());
    }
    out.add(name, field(std::move(values), unit.of(is_shift(r)), "of every step", shape));
  };
  constexpr Unit slip{"1", "mm"};
  add("p_x", &ContactResult::px, "MPa");
  add("p_s", &ContactResult::ps, "MPa");
  add("p_n", &ContactResult::pn, "MPa");
  add("slip_x", &ContactResult::slip_x, slip);
  add("slip_s", &ContactResult::slip_s, slip);
  return out;
}

Record certificate_of(const Certificate& c) {
  const auto relative = [](double value, const char* meaning) { return Number{value, "1", meaning}; };
  return {
      {"pressure", relative(c.pressure, "largest tension, over pmax")},
      {"penetration", relative(c.penetration, "largest penetration, over the approach scale")},
      {"complementarity", relative(c.complementarity, "largest pressure times distance, over their scales")},
      {"friction_cone", relative(c.friction_cone, "largest shear traction beyond its bound, over the bound")},
      {"adhesion", relative(c.adhesion, "largest slip of an element that adheres, over the slip scale")},
      {"slip_direction",
       relative(c.slip_direction, "largest deviation from friction against the slip, over mu pmax")},
      {"force_balance", relative(c.force_balance, "largest miss of a prescribed force, over its scale")},
      {"tolerance", relative(c.tolerance, "a step is a solution if no violation is larger")}};
}

record::Content extrapolated(const SceneResult& r) {
  if (!r.result.trust.discretisation)
    return {};
  const ContactTotals& e = r.result.trust.discretisation->extrapolated;
  constexpr const char* meaning = "extrapolated to elements of vanishing size";
  return Record{{"Fx", Number{e.Fx, "N", meaning}},
                {"Fy", Number{e.Fy, "N", meaning}},
                {"Fz", Number{e.Fz, "N", meaning}},
                {"Mz", Number{e.Mz + r.motion.reference.position.y * e.Fx - r.motion.reference.x * e.Fy,
                              "N mm", meaning}},
                {"approach", Number{e.approach, "mm", meaning}}};
}

record::Content body_of(const std::optional<BodyMotion>& body) {
  if (!body)
    return {};
  const auto line = [](auto from, const char* unit, const char* meaning) {
    return field({from.begin(), from.end()}, unit, meaning);
  };
  const auto matrix = [](const SixBySix& m, const char* meaning) {
    std::vector<double> values;
    for (const auto& row : m)
      values.insert(values.end(), row.begin(), row.end());
    return field(std::move(values), "mm, N, rad", meaning, {6, 6});
  };
  Record out{{"before", field({body->before.y, body->before.z}, "mm",
                              "point of the body where the scene puts it: y, z")},
             {"after", field({body->after.y, body->after.z}, "mm",
                             "the same point where the contact was solved: y, z")},
             {"force",
              line(body->force, "N, N mm", "of the contact on the body, along and about x, y, z at `after`")},
             {"motion", line(body->motion, "mm, rad", "compliance times force: along and about x, y, z")},
             {"compliance", matrix(body->compliance, "motion under each unit force or moment")}};
  if (body->stiffness)
    out.add("stiffness", matrix(*body->stiffness, "inverse of compliance"));
  else
    out.add("stiffness", Record::Nothing{});
  return out;
}

} // namespace

record::Content structure_of(const std::optional<StructuralResult>& s) {
  if (!s)
    return {};
  Record out{{"rail", body_of(s->rail)}, {"wheel", body_of(s->wheel)}, {"placed", s->placed}};
  if (s->shift_y)
    out.add("shift_y",
            Number{*s->shift_y, "mm", "how far the wheel is moved along y, as the surfaces slide"});
  else
    out.add("shift_y", Record::Nothing{});
  out.add("solutions", Number{double(s->solutions), "1", "until the bodies stood still", {}, true});
  out.add("last_change", Number{s->change, "mm", "by how much the last solution moved the contact"});
  out.add("lowered",
          Number{s->lowered, "mm", "of the approach: what brings the moved bodies together again"});
  return out;
}

namespace {

Field stress_line(const std::vector<double>& values, const char* meaning) {
  return Field{"mm", meaning, {values.size()}, values};
}

/// `prefix`: of the names; `of`: what they are stresses of, in words.
void add_stress_field(Record& out, const StressField& f, const Shape& shape, const std::string& prefix,
                      const std::string& of) {
  std::vector<double> tensor;
  for (const halfspace::Stress& t : f.stress)
    tensor.insert(tensor.end(), {t.xx, t.ss, t.nn, t.xs, t.xn, t.sn});
  Shape of_tensor = shape;
  of_tensor.push_back(6);
  out.add(prefix + "stress",
          field(std::move(tensor), "MPa", "[x][s][depth][component]; tension positive; " + of, of_tensor))
      .add(prefix + "von_mises", Field{"MPa", "von Mises' stress [x][s][depth]", shape, f.von_mises})
      .add(prefix + "largest_shear", Field{"MPa", "largest shear stress", shape, f.largest_shear});
}

Record in_body_record(const StressesInBody& b, const Shape& shape) {
  Record out{{"body", record::Text{b.body}},
             {"s", stress_line(b.s, "arc length of the points along this body's profile")},
             {"error", Field{"MPa",
                             "what its stresses may be off by its finite elements, as von Mises' stress "
                             "[s][depth]",
                             {shape[1], shape[2]},
                             b.error}}};
  add_stress_field(out, b.in_body, shape, "", "of the real body");
  add_stress_field(out, b.halfspace, shape, "halfspace_", "half-space closed forms");
  return out;
}

} // namespace

record::Content stresses_of(const std::optional<StressesBelow>& b) {
  if (!b)
    return {};
  const Shape shape{b->x.size(), b->s.size(), b->depths.size()};
  Record out{
      {"x", stress_line(b->x, "x of the points")},
      {"s", stress_line(b->s, "arc length of the points along the rail")},
      {"depths", stress_line(b->depths, "depth of the points below the surface, along n")},
      {"components", record::Texts{{"xx", "ss", "nn", "xs", "xn", "sn"}, "of the stress, frame (x, s, n)"}}};
  add_stress_field(out, *b, shape, "", "half-space closed forms");
  for (const StressesInBody& body : b->bodies)
    out.add(std::string(name_of(body.side)), in_body_record(body, shape));
  return out;
}

namespace {

Record seconds_of(const PhaseSeconds& s) {
  const auto phase = [](double value, const char* meaning) { return Number{value, "s", meaning}; };
  return {{"geometry", phase(s.geometry, "files, profiles, contact search, undeformed distance")},
          {"numbers", phase(s.numbers, "influence numbers")},
          {"solve", phase(s.solve, "pressures and shear tractions")},
          {"check", phase(s.check, "certificate and displacements")},
          {"estimate", phase(s.estimate, "the same on elements twice as large, for the stated errors")},
          {"free_rolling", phase(s.free_rolling, "all that finds free rolling")},
          {"search", phase(s.search, "all that finds the lateral displacement for load.force_y")},
          {"total", phase(s.total, "all of the call")}};
}

Record solver_of(const ContactResult& c) {
  return {{"normal", record::Text{c.effort.normal_solver}},
          {"tangential", record::Text{c.effort.tangential_solver}},
          {"work", Number{c.effort.work, "1", "of the case's budget of work"}},
          {"outer_rate",
           Number{c.effort.outer_rate, "1", "mean factor by which an outer iteration changed the residual"}},
          {"creepage_iterations", Number{double(c.effort.creepage_iterations),
                                         "1",
                                         "tangential problems solved for prescribed forces",
                                         {},
                                         true}}};
}

/// What is said of the answer as a whole.
void add_words_of(Record& out, const SceneResult& r) {
  out.add("model", std::string(name_of(r.choice.model)));
  out.add("why_this_model", r.choice.why_this_model);
  out.add("certified", certified(r));
  add_words(out, "why_not_certified", why_not_certified(r));
  add_words(out, "solver_note", r.result.trust.solver_note);
  add_words(out, "why_no_errors", why_no_errors(r));
  if (r.result.trust.discretisation)
    out.add("converges_with_elements", r.result.trust.discretisation->converges);
  else
    out.add("converges_with_elements", Record::Nothing{});
  out.append(record_of(r.warnings));
  const std::string side = r.motion.left ? "left" : "right";
  out.add("side", side);
  out.add("frame", "x rolling direction, y to the " + side + ", z down; s along the rail, n into the rail");
  out.add("approach_datum", r.approach_datum);
  add_words(out, "track", r.track);
}

void add_found_lateral(Record& out, const SceneResult& r) {
  if (!r.motion.found_lateral)
    return;
  out.add("lateral_slope", Number{r.motion.found_lateral->slope, "N/mm", "dFy/dy at the displacement found"});
  const auto count = [](int number, const char* meaning) {
    return Number{double(number), "1", meaning, {}, true};
  };
  out.add("lateral_solutions", count(r.motion.found_lateral->solutions, "that found the displacement"));
  out.add("lateral_rough_solutions", count(r.motion.found_lateral->rough, "of half-spaces before them"));
  out.add("other_laterals", field(r.motion.found_lateral->others, "mm",
                                  "other displacements with the same load.force_y, to some hundredths"));
}

} // namespace

record::Table patches_of(const SceneResult& r) {
  return record::as_rows(record::table_of("patch", patch_quantities(), r.result.patches.size(), is_shift(r),
                                          [&](auto value, std::size_t i) { return value(r, i); }));
}

record::Table history_of(const SceneResult& r) {
  return record::as_rows(record::table_of("step", step_quantities(), r.history.size(), is_shift(r),
                                          [&](auto value, std::size_t i) { return value(r, r.history[i]); }));
}

Record record_of(const SceneResult& r, const RecordParts& parts) {
  Record out;
  add_words_of(out, r);
  if (parts.quantities)
    out.add("quantities", record::numbers_of(quantities(), is_shift(r), r));
  else
    out.add("quantities", record::numbers_of(std::array{quantity("dx"), quantity("ds")}, is_shift(r), r));
  out.add("patches", patches_of(r)).add("history", history_of(r));
  add_found_lateral(out, r);
  out.add("conformity", conformity_of(r.conformity));
  out.add("structure", structure_of(r.structure));
  out.add("stresses", stresses_of(r.stresses));
  if (Record derivatives = derivatives_of(r); !derivatives.empty())
    out.add("derivatives", std::move(derivatives));
  if (parts.quantities)
    out.add("extrapolated", extrapolated(r))
        .add("certificate", certificate_of(r.result.trust.certificate))
        .add("solver", solver_of(r.result))
        .add("seconds", seconds_of(r.seconds));
  out.add("friction", Number{r.problem.tangential ? r.problem.largest_friction() : 0.0, "1",
                             "largest coefficient of friction; 0: none"});
  if (parts.fields) {
    add_coordinates(out, r);
    add_fields(out, r);
    if (!r.history.empty())
      out.add("step_fields", step_fields(r));
  }
  return out;
}

const Record& ResultByPath::record_with(std::string_view path) {
  for (auto [kept, fields] : {std::pair(&numbers_, false), std::pair(&whole_, true)}) {
    if (!*kept)
      *kept = record_of(*result_, {.fields = fields});
    if (record::has(**kept, path))
      return **kept;
  }
  throw record::unknown_path(*whole_, path, "result");
}

double ResultByPath::number(std::string_view path) {
  const Record& all = record_with(path);
  if (const auto number = record::number_at(all, path))
    return *number;
  throw InputError("'" + std::string(path) + "' is no number",
                   record::values_at(all, path).empty() ? "a text or a group stands there"
                                                        : "several numbers stand there",
                   "Go on in the path, as patches/0/Fn.");
}

Record record_of(const Warnings& warnings) {
  std::vector<std::string> about;
  for (const Warning& one : warnings)
    about.push_back(one.about);
  return {{"warnings", record::Texts{warnings.texts(), "one line for each, the most important first"}},
          {"warning_kinds", record::Texts{warnings.kinds(), "what each is of"}},
          {"warning_about",
           record::Texts{std::move(about), "the key that each is about, if its kind has several"}}};
}

Record record_of(const Comparison& c, const RecordParts& parts) {
  record::Texts models{{}, "those compared"};
  for (const Model model : c.models)
    models.lines.emplace_back(name_of(model));
  const auto set_of = [&](const std::vector<SceneResult>& results) -> record::Content {
    if (results.empty())
      return {};
    Record set, differences;
    for (std::size_t i = 0; i < results.size(); ++i) {
      const std::string model(name_of(c.models[i]));
      set.add(model, record_of(results[i], parts));
      if (i != c.reference)
        differences.add(model, differences_of(results[i], results[c.reference]));
    }
    set.add("difference", std::move(differences));
    return set;
  };
  const auto by_model = [&](const std::vector<std::vector<double>>& all, const char* meaning) {
    Record out;
    for (std::size_t m = 0; m < c.models.size(); ++m)
      out.add(std::string(name_of(c.models[m])), Field{"N", meaning, {all[m].size()}, all[m]});
    return out;
  };
  Record out{{"models", std::move(models)},
             {"reference", record::Text{std::string(name_of(c.models[c.reference]))}},
             {"certified", certified(c)},
             {"at_equal_forces", set_of(c.at_forces)},
             {"at_equal_position", set_of(c.at_position)}};
  if (c.creep_forces.empty())
    return out.add("creep_forces", Record::Nothing{});
  const std::vector<double>& creepage = c.creep_forces.creepage;
  return out.add(
      "creep_forces",
      Record{
          {"xi_from_free_rolling",
           Field{"1",
                 "longitudinal creepage beyond free rolling; each model has its own creepage of free rolling",
                 {creepage.size()},
                 creepage}},
          {"Fx",
           by_model(c.creep_forces.Fx, "longitudinal force on the rail, at the place of at_equal_forces")},
          {"Fx_error", by_model(c.creep_forces.Fx_error, record::error_meaning)}});
}

} // namespace bem_contact
