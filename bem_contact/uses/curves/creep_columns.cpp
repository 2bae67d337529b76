#include "bem_contact/uses/curves/creep_columns.hpp"

namespace bem_contact {

namespace {

template <CreepForce which> double force(const CreepPoint& p) {
  return p.forces[static_cast<std::size_t>(which)];
}
template <CreepForce which> double error(const CreepPoint& p) {
  return p.errors[static_cast<std::size_t>(which)];
}

constexpr const char* by_elements = "estimated error by the size of the elements";
constexpr const char* by_step = "by the step of the differences";

} // namespace

std::span<const CreepColumn> creep_columns() {
  static constexpr CreepColumn columns[] = {{{"Fx", "N", "on the rail", force<CreepForce::Fx>}, 9},
                                            {{"Fx_error", "N", by_elements, error<CreepForce::Fx>}, 3},
                                            {{"Fs", "N", "on the rail", force<CreepForce::Fs>}, 9},
                                            {{"Fs_error", "N", by_elements, error<CreepForce::Fs>}, 3},
                                            {{"Mz", "N mm", "on the rail", force<CreepForce::Mz>}, 9},
                                            {{"Mz_error", "N mm", by_elements, error<CreepForce::Mz>}, 3},
                                            {{"adhesion_share", "1", "of the area in contact that adheres",
                                              [](const CreepPoint& p) { return p.adhesion_share; }},
                                             6},
                                            {{"certified", "1", "1: the certificate holds",
                                              [](const CreepPoint& p) { return p.certified ? 1.0 : 0.0; }},
                                             1}};
  return columns;
}

std::vector<double> creepages_of(const CreepCurve& curve) {
  std::vector<double> out;
  for (const CreepPoint& p : curve.points)
    out.push_back(p.creepage);
  return out;
}

const char* unit_of(CreepKind kind) {
  return kind == CreepKind::phi ? "1/mm" : "1";
}

std::span<const CreepMatrixEntry> creep_matrices() {
  using C = CreepCurves;
  static constexpr CreepMatrixEntry matrices[] = {
      {"slopes", "[Fx, Fs, Mz][xi, eta, phi] where nothing moves over the other",
       [](const C& c) { return &c.slopes.values; }},
      {"slopes_error", by_step, [](const C& c) { return &c.slopes.errors; }},
      {"sensitivities", "[Fx, Fs, Mz][xi, eta, phi] at the scene's creepages",
       [](const C& c) { return &c.sensitivities.values; }},
      {"sensitivities_error", by_step, [](const C& c) { return &c.sensitivities.errors; }},
      {"linearised", "the sensitivities from one linear system, with the pressure held",
       [](const C& c) { return c.linearised ? &*c.linearised : nullptr; }},
      {"kalker", "[Fx, Fs, Mz][xi, eta, phi] by linear theory for the nearest ellipse",
       [](const C& c) { return c.linear ? &c.linear->slopes : nullptr; }}};
  return matrices;
}

} // namespace bem_contact
