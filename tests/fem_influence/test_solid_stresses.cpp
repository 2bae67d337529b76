#include "bem_contact/base/lagrange.hpp"
#include "bem_contact/inside/stresses_inside.hpp"
#include "bem_contact/profile/standard_profiles.hpp"
#include "fem_influence/harmonic/body_stresses.hpp"
#include "fem_influence/solid/patch_functionals.hpp"
#include "fem_influence/solid/solid_body.hpp"
#include "fem_influence/solid/solid_solver.hpp"
#include "section_meshes.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

/// Stresses inside a body of the demo, by the two methods that share nothing but the profile.
namespace bem_contact::fem::test {
namespace {

using halfspace::Stress;

/// A point of integration: where it is below the surface, along x, and its part of a cell's volume.
struct InsideCell {
  inside::BelowSurface below;
  double x = 0, share = 0;
};

/// A cell near the load: its mean stress in the frames of the surface above its points.
struct Cell {
  double depth = 0; ///< of its middle, mm
  Stress mean;
  std::vector<InsideCell> points;
};

/// The gradient of the displacement at a point of a cell, of component c along d.
std::array<Vector3, 3> gradient_at(const SolidCellView& cell, std::size_t q, std::span<const double> u) {
  std::array<Vector3, 3> out{};
  const std::size_t n = cell.nodes.size();
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t d = 0; d < 3; ++d)
        out[c][d] += cell.gradient[3 * (q * n + a) + d] * u[3 * std::size_t(cell.nodes[a]) + c];
  return out;
}

/// Stress in the frame (x, s, n) of the surface.
Stress stress_of(const std::array<Vector3, 3>& gradient, const std::array<Vector3, 3>& frame,
                 const Material& material) {
  const double mu = material.shear_modulus, lambda = 2 * mu * material.poisson / (1 - 2 * material.poisson);
  const auto strain = [&](std::size_t i, std::size_t j) {
    double sum = 0;
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t d = 0; d < 3; ++d)
        sum += 0.5 * frame[i][c] * (gradient[c][d] + gradient[d][c]) * frame[j][d];
    return sum;
  };
  const double trace = lambda * (strain(0, 0) + strain(1, 1) + strain(2, 2));
  return {trace + 2 * mu * strain(0, 0), trace + 2 * mu * strain(1, 1), trace + 2 * mu * strain(2, 2),
          2 * mu * strain(0, 1),         2 * mu * strain(0, 2),         2 * mu * strain(1, 2)};
}

/// Cells from 0.5 to 6 mm below the load.
std::vector<Cell> cells_below(const SolidBody& body, const ContactSurface& surface, const Material& material,
                              std::span<const double> u) {
  std::vector<Cell> out;
  body.for_each_cell([&](const SolidCellView& cell) {
    const SurfacePoint above = surface.nearest(cell.centre);
    if (std::abs(above.s) > 1.5 || cell.centre[0] > 0.5 || cell.centre[2] > 7)
      return;
    double volume = 0;
    for (const double weight : cell.weight)
      volume += weight;
    Cell one;
    for (std::size_t q = 0; q < cell.weight.size(); ++q) {
      const Vector3& p = cell.point[q];
      const SurfacePoint place = surface.nearest(p);
      const auto frame = surface.frame(place);
      const Vector3 top = surface.position(place);
      double depth = 0;
      for (std::size_t c = 0; c < 3; ++c)
        depth += (p[c] - top[c]) * frame[component_n][c];
      const double share = cell.weight[q] / volume;
      one.depth += share * depth;
      one.mean.add(share, stress_of(gradient_at(cell, q, u), frame, material));
      one.points.push_back({{place.s, depth}, p[0], share});
    }
    if (one.depth > 0.5 && one.depth < 6)
      out.push_back(std::move(one));
  });
  return out;
}

/// The other method's mean over the same points.
Stress mean_of(const Cell& cell, std::span<const inside::Passage> passages, const std::vector<double>& x) {
  Stress out;
  for (std::size_t q = 0; q < cell.points.size(); ++q) {
    const double at = cell.points[q].x;
    const auto first =
        std::clamp<std::ptrdiff_t>(std::ranges::upper_bound(x, at) - x.begin() - 2, 0, std::ssize(x) - 4);
    std::array<double, 4> weights{};
    lagrange_weights(std::span(x).subspan(std::size_t(first), 4), at, weights);
    for (std::size_t k = 0; k < 4; ++k)
      out.add(cell.points[q].share * weights[k], passages[q][std::size_t(first) + k]);
  }
  return out;
}

/// Away from the load by more than its width, in the blade of 10 mm.
TEST(SolidStresses, below_one_element_of_the_blade_are_those_of_the_section) {
  const Folder folder;
  std::ifstream in(DATA_FOLDER "/bodies/blade.toml");
  std::stringstream text;
  text << in.rdbuf();
  std::string toml = text.str();
  const auto set = [&](const std::string& from, const std::string& to) {
    ASSERT_NE(toml.find(from), std::string::npos) << from;
    toml.replace(toml.find(from), from.size(), to);
  };
  set("tolerance = 1e-2", "tolerance = 1e-3");
  set("[harmonic]", "[solid]\nsize = 1.0\n[harmonic]\nhalf_period = 120");
  write_text(folder / "blade.toml", toml);
  const std::string mesh = MESH_BODY_PROGRAM " " + (folder / "blade.toml").string() + " -o ";
  ASSERT_EQ(std::system((mesh + (folder / "section.msh").string() + " > /dev/null 2>&1").c_str()), 0);
  ASSERT_EQ(std::system((mesh + (folder / "solid.msh").string() + " --solid > /dev/null 2>&1").c_str()), 0);
  const BodyFile body = read_body_file(folder / "blade.toml");
  const ProfileCurve curve = body_profile(body);
  const ContactSurface surface(curve, 0);

  const SolidMesh solid_mesh(folder / "solid.msh", surface);
  const SurfacePoint middle{0, 0};
  const SolidBody solid(
      solid_mesh, 2,
      {.loads = {&middle, 1}, .load_radius = 0.7, .smallest = 0.25, .grading = 0.25, .reach = 8});
  const SurfacePatch element{
      .s_from = -0.5, .s_to = 0.5, .x_from = 0, .x_to = 0.5}; // x < 0 is its mirror image
  const std::size_t pressure = component_n;
  const SparseColumns load = select_columns(patch_functionals(solid, surface, {&element, 1}), {&pressure, 1});
  std::vector<Cell> cells;
  SolidSolver(solid, body.material)
      .solve(MirrorSymmetry::even, load, load,
             [&](std::size_t, std::span<const double>, std::span<const double> u) {
               cells = cells_below(solid, surface, body.material, u);
             });

  inside::SurfaceTractions tractions{.dx = 0.125, .ds = 0.5, .x0 = -1.4375, .columns = 24};
  tractions.poisson = body.material.poisson;
  tractions.s = {-0.25, 0.25};
  for (int i = 0; i < 2 * tractions.columns; ++i)
    tractions.pn.push_back(std::abs(tractions.x(i % tractions.columns)) < 0.5 ? 1 : 0);
  tractions.px.assign(tractions.pn.size(), 0), tractions.ps = tractions.px;
  std::vector<inside::BelowSurface> points;
  for (const Cell& cell : cells)
    for (const InsideCell& p : cell.points)
      points.push_back(p.below);
  std::vector<inside::LoadedInside> loads{
      {tractions, inside::halfspace_inside(tractions, inside::Side::rail, points)}};
  add_body_stresses(loads, body, curve, folder / "section.msh", [](std::size_t, std::size_t) {});
  const inside::AreaStresses& area = loads[0].stresses.areas.at(0);

  double worst = 0, halfspace_off = 0;
  std::size_t deep = 0, within = 0, first = 0;
  for (const Cell& cell : cells) {
    const std::size_t count = cell.points.size();
    const auto off = [&](const std::vector<inside::Passage>& all) {
      Stress difference = mean_of(cell, std::span(all).subspan(first, count), area.x);
      return von_mises(difference.add(-1, cell.mean));
    };
    const double largest = von_mises(cell.mean);
    if (cell.depth > 1.5) { // the load is a millimetre wide
      worst = std::max(worst, off(area.body) / largest);
      halfspace_off = std::max(halfspace_off, off(area.flat) / largest);
      ++deep;
    }
    const double stated = std::ranges::max(std::span(area.error).subspan(first, count));
    within += off(area.body) < stated + 0.003 * largest; // that of the hexahedra
    first += count;
  }
  fmt::print("{} cells, {} unknowns: at most {:.2f} % off, a half-space {:.0f} %\n", deep,
             3 * solid.node_count(), 100 * worst, 100 * halfspace_off);
  EXPECT_GE(deep, 40u);
  EXPECT_LT(worst, 0.005);
  EXPECT_GT(halfspace_off, 0.1);
  EXPECT_EQ(within, cells.size());
}

} // namespace
} // namespace bem_contact::fem::test
