#include "bem_contact/sequence/solution/case_stresses.hpp"

#include "bem_contact/sequence/plan/model_choice.hpp"
#include "bem_contact/sequence/result_warnings.hpp"

#include <cmath>
#include <fmt/format.h>
#include <utility>
#include <vector>

namespace bem_contact {

namespace {

/// The arc length on a body of each row of a problem tells that of any place: as on a line between two rows,
/// and beyond the last ones. Rows that have none (nan) do not count.
std::vector<double> places_on_body(const std::vector<ContactRow>& rows, const std::vector<double>& of_rows,
                                   std::vector<double> s) {
  std::vector<std::pair<double, double>> known;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (std::isfinite(of_rows[i]))
      known.emplace_back(rows[i].s, of_rows[i]);
  for (double& at : s) {
    if (known.size() < 2) {
      at = known.empty() ? of_rows.front() : known.front().second;
      continue;
    }
    std::size_t i = 1;
    while (i + 1 < known.size() && known[i].first < at)
      ++i;
    const auto& [a, from] = known[i - 1];
    const auto& [b, to] = known[i];
    at = std::lerp(from, to, (at - a) / (b - a));
  }
  return s;
}

void add_bodies(const ContactCase& asked, const inside::SurfaceTractions& on_rail, SceneResult& out) {
  StressesBelow& below = *out.stresses;
  const SceneFile::Stresses& scene = asked.scene.stresses;
  const SceneBodies& bodies = out.bodies;
  if (asked.rail_inside) {
    inside::SurfaceTractions tractions = on_rail;
    std::vector<double> s = below.s;
    if (!bodies.rail_s.empty()) { // of a patch, on the file's arc length
      s = places_on_body(out.problem.rows, bodies.rail_s, std::move(s));
      tractions.s = bodies.rail_s;
    }
    below.bodies.push_back(
        stresses_in_body(scene, std::move(s), tractions, inside::Side::rail, *asked.rail_inside));
  }
  if (asked.wheel_inside)
    below.bodies.push_back(
        stresses_in_body(scene, places_on_body(out.problem.rows, bodies.wheel_s, below.s),
                         inside::on_upper_body(on_rail, bodies.wheel_s, bodies.wheel_poisson),
                         inside::Side::wheel, *asked.wheel_inside));
}

} // namespace

void add_stresses(const ContactCase& asked, SceneResult& out) {
  const SceneFile& scene = asked.scene;
  if (scene.stresses.depths.empty() || !out.result.certified())
    return;
  const inside::SurfaceTractions tractions =
      surface_tractions(out.problem, out.result, out.bodies.rail_poisson);
  out.stresses = stresses_below(scene.stresses, tractions, out.motion.reference.s);
  if (scene.stresses.asks_for_bodies())
    return add_bodies(asked, tractions, out);
  const double turn = turn_of_contact(out.problem, out.result);
  if (const double error = predicted_halfspace_error(turn); error > scene.solver.model_tolerance)
    out.warnings.add(
        WarningKind::rough_stresses,
        fmt::format(
            "the stresses below the surface are those of a half-space under these tractions: an "
            "approximation here, for the normal turns by {:.1f} degrees within the patch, and they may "
            "be off by up to {:.1f} % ([stresses] in = \"bodies\" takes those of the real bodies)",
            degrees(turn), 100 * error));
}

} // namespace bem_contact
