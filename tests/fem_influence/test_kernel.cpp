#include "assemble.hpp"
#include "bem_contact/base/error.hpp"
#include "fem_influence/harmonic/harmonic_solver.hpp"
#include "fem_influence/shared/body_description.hpp"
#include "section_meshes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace bem_contact::fem::test {
namespace {

using std::numbers::pi;

/// Kernel of the half-space for two stations `width` wide, s = s_I - s_J: the transforms of
/// Boussinesq-Cerruti (Kalker 1990, app. E) in (x, s), one wavenumber k in x, integrated over those in s.
std::array<std::array<double, 3>, 3> halfspace_kernel(const Material& m, double k, double s, double width) {
  const double nu = m.poisson, G = m.shear_modulus;
  std::array<std::array<double, 3>, 3> g{};
  const double step = 2e-3 / width, largest = 600 / width;
  for (double q = 0.5 * step; q < largest; q += step) {
    const double kappa = std::hypot(k, q), sine = 2 * std::sin(0.5 * q * width) / q;
    const double w = sine * sine / width * step / pi, c = w * std::cos(q * s), d = w * std::sin(q * s);
    g[0][0] += c * (1 - nu * k * k / (kappa * kappa)) / (G * kappa);
    g[1][1] += c * (1 - nu * q * q / (kappa * kappa)) / (G * kappa);
    g[2][2] += c * (1 - nu) / (G * kappa);
    g[0][1] += d * nu * k * q / (G * kappa * kappa * kappa);
    g[0][2] -= c * (1 - 2 * nu) * k / (2 * G * kappa * kappa);
    g[1][2] -= d * (1 - 2 * nu) * q / (2 * G * kappa * kappa);
  }
  // Maxwell-Betti with s -> -s.
  g[1][0] = -g[0][1];
  g[2][0] = g[0][2];
  g[2][1] = -g[1][2];
  return g;
}

BodyFile strip_body(BodyKind kind, double half, double width, int degree) {
  BodyFile body;
  body.body.kind = kind;
  body.strip = {-half, half, width};
  body.harmonic.degree = degree;
  return body;
}

/// Largest deviation from the half-space's kernel, relative to its self number, from station 0.
double worst_against_halfspace(bool wheel, double k, double h, int degree, int borders = 0) {
  const Folder folder;
  const double width = 0.5, half = 3.0;
  write_block_mesh(folder / "block.msh", h, half, 60, wheel);
  const BodyFile body = strip_body(wheel ? BodyKind::wheel : BodyKind::block, half, width, degree);
  const ProfileCurve curve = straight_line(60, wheel);
  const Section section(folder / "block.msh", degree, curve, body.strip, {.borders = borders});
  HarmonicSolver solver(assemble_system(section, body, curve));
  const auto result = solver.at(k);
  EXPECT_LT(result.betti_error, 1e-10);
  const auto all = make_stations(body.strip, curve);
  const std::size_t stations = all.size(), n = 3 * stations;
  EXPECT_EQ(stations, 12u);
  double worst = 0;
  for (std::size_t I = 0; I < stations; ++I) {
    const auto exact = halfspace_kernel(body.material, k, static_cast<double>(I) * width, width);
    const auto self = halfspace_kernel(body.material, k, 0, width);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        const double error = std::abs(result.kernel[(3 * I + i) * n + j] - exact[i][j]) / self[i][i];
        EXPECT_LT(error, 0.01) << "component " << i << j << " at station " << I << ", k = " << k;
        worst = std::max(worst, error);
      }
  }
  return worst;
}

// The error is that of the logarithm at a station's edge, the same for all k, while the self number falls as
// 1/k: so the bounds rise with k.
TEST(Kernel, flat_block_is_the_halfspace_in_all_nine_components) {
  EXPECT_LT(worst_against_halfspace(false, 0.5, 0.125, 3), 1e-3);
  EXPECT_LT(worst_against_halfspace(false, 2.0, 0.125, 3), 1e-3);
  EXPECT_LT(worst_against_halfspace(false, 10.0, 0.125, 3), 6e-3);
}

TEST(Kernel, flat_tread_of_a_wheel_is_the_halfspace_in_its_own_frame) {
  for (const double k : {0.5, 5.0})
    EXPECT_LT(worst_against_halfspace(true, k, 0.125, 3), 2e-3 + 1 / (k * wheel_reference_radius));
}

TEST(Kernel, error_falls_as_the_square_of_the_element) {
  const double coarse = worst_against_halfspace(false, 2.0, 0.25, 3);
  const double fine = worst_against_halfspace(false, 2.0, 0.125, 3);
  EXPECT_GT(std::log2(coarse / fine), 1.7);
}

// From station 0 at the strip's end: cells off the strip feel its border too. Degree 4, as at degree 3 the
// cells between the borders leave 3e-5.
TEST(Kernel, each_further_level_at_the_borders_takes_the_error_to_about_a_quarter) {
  double last = worst_against_halfspace(false, 2.0, 0.25, 4, 1);
  for (int level = 2; level <= 4; ++level) {
    const double now = worst_against_halfspace(false, 2.0, 0.25, 4, level);
    EXPECT_GT(std::log2(last / now), 1.9) << "level " << level;
    last = now;
  }
  EXPECT_LT(last, 4e-6);
}

/// Michell's modes of a disc or a bore under pressure p cos(n phi) (bem_contact/theory/estimates_and_heat.md
/// 4), with k = 0.
void check_michell(bool hole) {
  const Folder folder;
  const double radius = 10;
  const int count = 84;
  write_ring_mesh(folder / "ring.msh", radius, hole ? 200 * radius : 0.004 * radius, count);
  BodyFile body = strip_body(hole ? BodyKind::bore : BodyKind::disc, 0, 2 * pi * radius / count, 3);
  const ProfileCurve circle = full_circle(radius, hole);
  body.strip = {circle.s_begin(), circle.s_end(), (circle.s_end() - circle.s_begin()) / count};
  body.harmonic.remote_distance = 0.5 * radius;
  const Section section(folder / "ring.msh", 3, circle, body.strip, {.borders = 3});
  HarmonicSolver solver(assemble_system(section, body, circle));
  const auto result = solver.at(0);
  EXPECT_LT(result.betti_error, 1e-10);
  EXPECT_LT(result.reaction_error, 1e-8);
  const std::size_t size = 3 * count;
  const auto stations = make_stations(body.strip, circle);
  const double mu = body.material.shear_modulus, nu = body.material.poisson, kappa = 3 - 4 * nu;
  const auto exact = [&](int n) -> std::array<double, 2> { // normal, tangential
    const double unit = radius / (4 * mu);
    if (hole)
      return {unit * (kappa / (n - 1) + 1.0 / (n + 1)), unit * (-kappa / (n - 1) + 1.0 / (n + 1))};
    return {unit * (kappa / (n + 1) + 1.0 / (n - 1)), -unit * (kappa / (n + 1) - 1.0 / (n - 1))};
  };
  for (int n = 2; n <= 40; ++n) {
    double normal = 0, tangential = 0;
    for (std::size_t I = 0; I < count; ++I)
      for (std::size_t J = 0; J < count; ++J) {
        const double at = stations[I].s / radius, p = std::cos(n * stations[J].s / radius);
        normal += 2.0 / count * result.kernel[(3 * I + 2) * size + 3 * J + 2] * p * std::cos(n * at);
        tangential += 2.0 / count * result.kernel[(3 * I + 1) * size + 3 * J + 2] * p * std::sin(n * at);
      }
    // A pressure that is constant on each station has the modes n + m count too, which the stations do not
    // tell from n; load and mean count by sin(x)/x each.
    double exact_normal = 0, exact_tangential = 0;
    for (int m = -400; m <= 400; ++m) {
      const int mode = n + m * count;
      const double x = mode * pi / count, sinc = std::sin(x) / x;
      const auto [normal_mode, tangential_mode] = exact(std::abs(mode));
      exact_normal += sinc * sinc * normal_mode;
      exact_tangential += sinc * sinc * (mode > 0 ? tangential_mode : -tangential_mode);
    }
    EXPECT_NEAR(normal, exact_normal, 1e-3 * exact_normal) << "n = " << n;
    EXPECT_NEAR(tangential, exact_tangential, 1e-3 * exact_normal) << "n = " << n;
  }
  double uniform = 0;
  for (std::size_t J = 0; J < count; ++J)
    uniform += result.kernel[2 * size + 3 * J + 2];
  const double exact_uniform = radius / (2 * mu) * (hole ? 1 : 1 - 2 * nu);
  EXPECT_NEAR(uniform, exact_uniform, 1e-3 * exact_uniform);
}

TEST(Kernel, schur_complement_is_what_solving_gives) {
  // A chain of springs, held at one end; borders with repeated and single entries.
  const int size = 50;
  Elements springs;
  std::vector<double> value;
  for (int i = 0; i < size; ++i) {
    springs.add(std::array{i});
    value.push_back(i > 0 ? 2.0 + 0.01 * i : 2.5);
    if (i > 0) { // lower triangle column by column, whatever the order of the two
      springs.add(i % 2 ? std::array{i, i - 1} : std::array{i - 1, i});
      value.insert(value.end(), {0.0, -1.0, 0.0});
    }
  }
  SparseColumns border;
  for (const int at : {0, 7, 7, 49}) {
    border.row.insert(border.row.end(), {at, (at + 5) % size});
    border.value.insert(border.value.end(), {1.0, 0.25 * at});
    border.column_begin.push_back(border.row.size());
  }
  MumpsSolver bordered(size, springs, border), plain(size, springs);
  bordered.factorize(value);
  plain.factorize(value);
  const std::vector<double>& schur = bordered.schur();
  plain.solve(border, [&](std::size_t c, std::span<const double> x) {
    for (std::size_t a = 0; a < border.columns(); ++a) {
      double expected = 0;
      for (std::size_t e = border.column_begin[a]; e < border.column_begin[a + 1]; ++e)
        expected += border.value[e] * x[static_cast<std::size_t>(border.row[e])];
      EXPECT_NEAR(schur[a * border.columns() + c], expected, 1e-12 * schur[a * border.columns() + a]);
      EXPECT_EQ(schur[a * border.columns() + c], schur[c * border.columns() + a]);
    }
  });
}

TEST(Kernel, elimination_numbers_nodes_of_elements_first) {
  // A strip of squares, every second node of its lower edge in none of them.
  Elements squares;
  for (int i = 0; i < 20; ++i)
    squares.add(std::array{4 * i, 4 * i + 2, 4 * i + 4, 4 * i + 6});
  const std::size_t nodes = 87;
  const std::vector<int> place = nested_dissection(nodes, squares);
  std::vector<int> sorted(place);
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t a = 0; a < nodes; ++a)
    EXPECT_EQ(sorted[a], static_cast<int>(a));
  for (std::size_t a = 0; a < nodes; ++a)
    EXPECT_EQ(place[a] < 42, a % 2 == 0 && a < 84) << "node " << a;
  EXPECT_EQ(place, nested_dissection(nodes, squares)); // processes may find it each for themselves
}

TEST(Kernel, order_of_elimination_does_not_matter) {
  const Folder folder;
  write_block_mesh(folder / "block.msh", 0.5, 2, 50, true);
  const BodyFile body = strip_body(BodyKind::wheel, 2, 0.5, 2);
  const ProfileCurve curve = straight_line(50, true);
  const Section section(folder / "block.msh", 2, curve, body.strip, {.borders = 1});
  const HarmonicSystem system = assemble_system(section, body, curve);
  std::vector<int> place = elimination_order(system);
  const auto held = std::count(section.held().begin(), section.held().end(), 1);
  EXPECT_GT(held, 0);
  for (int& p : place) // the held nodes stay last
    if (const int free = static_cast<int>(place.size()) - static_cast<int>(held); p < free)
      p = free - 1 - p;
  HarmonicSolver found(system), backwards(system, place);
  const auto a = found.at(0.3), b = backwards.at(0.3);
  const double largest = *std::max_element(a.kernel.begin(), a.kernel.end());
  for (std::size_t i = 0; i < a.kernel.size(); ++i)
    EXPECT_NEAR(a.kernel[i], b.kernel[i], 1e-11 * largest);
  EXPECT_NE(a.kernel, b.kernel); // another order it was
}

TEST(Kernel, chosen_stations_have_the_numbers_that_all_have) {
  const Folder folder;
  write_block_mesh(folder / "block.msh", 0.5, 2, 50);
  const BodyFile body = strip_body(BodyKind::block, 2, 0.5, 2);
  const ProfileCurve curve = straight_line(50);
  const Section section(folder / "block.msh", 2, curve, body.strip, {.borders = 1});
  const std::vector<std::size_t> chosen = {1, 2, 6};
  HarmonicSystem system = lay_out_system(section, body, curve, chosen);
  fill(system.op, section, 0);
  HarmonicSolver some(std::move(system)), all(assemble_system(section, body, curve));
  const WavenumberResult a = some.at(0), b = all.at(0);
  const std::size_t n = 9, whole = b.remote.size() / 6;
  ASSERT_EQ(a.remote.size(), 6 * n);
  ASSERT_GT(whole, n);
  const auto row = [&](std::size_t i) { return 3 * chosen[i / 3] + i % 3; };
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j)
      EXPECT_NEAR(a.kernel[i * n + j], b.kernel[row(i) * whole + row(j)], 1e-11 * b.kernel[0]);
    for (std::size_t m = 0; m < 6; ++m)
      EXPECT_NEAR(a.remote[m * n + i], b.remote[m * whole + row(i)],
                  1e-11 * std::abs(b.remote[2 * whole + 2]));
  }
  EXPECT_LT(a.reaction_error, 1e-8);
}

TEST(Kernel, disc_has_michells_modes) {
  check_michell(false);
}
TEST(Kernel, bore_has_michells_modes) {
  check_michell(true);
}

TEST(Kernel, reactions_balance_the_load_of_prism_and_wheel) {
  for (const bool wheel : {false, true}) {
    const Folder folder;
    write_block_mesh(folder / "block.msh", 0.5, 2, 50, wheel);
    const BodyFile body = strip_body(wheel ? BodyKind::wheel : BodyKind::block, 2, 0.5, 2);
    const ProfileCurve curve = straight_line(50, wheel);
    const Section section(folder / "block.msh", 2, curve, body.strip, {.borders = 1});
    HarmonicSolver solver(assemble_system(section, body, curve));
    const auto result = solver.at(0);
    EXPECT_LT(result.reaction_error, 1e-8);
    EXPECT_LT(result.betti_error, 1e-10);
  }
}

TEST(Kernel, a_body_held_at_all_nodes_is_refused) {
  const Folder folder;
  write_text(folder / "one.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n"
                                 "1 -1 0 0\n2 1 0 0\n3 1 10 0\n4 -1 10 0\n$EndNodes\n$Elements\n5\n"
                                 "1 1 2 1 1 1 2\n2 1 2 2 2 2 3\n3 1 2 2 2 3 4\n4 1 2 2 2 4 1\n"
                                 "5 3 2 10 10 1 2 3 4\n$EndElements\n");
  BodyFile body = strip_body(BodyKind::block, 1, 2, 1);
  body.harmonic.remote_distance = 4;
  const ProfileCurve curve = straight_line(10);
  const Section section(folder / "one.msh", 1, curve, body.strip);
  try {
    assemble_system(section, body, curve);
    ADD_FAILURE() << "taken";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("nothing that can move"), std::string::npos) << error.what();
  }
}

TEST(Kernel, removing_the_remote_motion_takes_most_of_the_support_out) {
  // The same strip on blocks 40 and 80 wide and deep; the remote section lies 20 to 40 mm away.
  std::array<WavenumberResult, 2> results;
  std::array<double, 2> removed{};
  std::size_t n = 0;
  for (std::size_t b = 0; b < 2; ++b) {
    const Folder folder;
    const double size = b == 0 ? 40 : 80;
    write_block_mesh(folder / "block.msh", 0.5, 2, size);
    BodyFile body = strip_body(BodyKind::block, 2, 0.5, 2);
    body.harmonic.remote_distance = 20;
    const Section section(folder / "block.msh", 2, straight_line(size), body.strip);
    HarmonicSolver solver(assemble_system(section, body, straight_line(size)));
    results[b] = solver.at(0);
    n = 3 * make_stations(body.strip, straight_line(size)).size();
    auto s = results[b].remote_self;
    std::array<double, 6> rhs{}, x{};
    for (std::size_t m = 0; m < 6; ++m)
      x[m] = rhs[m] = results[b].remote[m * n + 2];
    for (std::size_t p = 0; p < 6; ++p)
      for (std::size_t r = p + 1; r < 6; ++r) {
        ASSERT_GT(s[p * 6 + p], 0);
        const double f = s[r * 6 + p] / s[p * 6 + p];
        for (std::size_t c = p; c < 6; ++c)
          s[r * 6 + c] -= f * s[p * 6 + c];
        x[r] -= f * x[p];
      }
    for (std::size_t p = 6; p-- > 0;) {
      for (std::size_t c = p + 1; c < 6; ++c)
        x[p] -= s[p * 6 + c] * x[c];
      x[p] /= s[p * 6 + p];
    }
    double rigid = 0;
    for (std::size_t m = 0; m < 6; ++m)
      rigid += rhs[m] * x[m];
    removed[b] = results[b].kernel[2 * n + 2] - rigid;
  }
  const double included = results[1].kernel[2 * n + 2] - results[0].kernel[2 * n + 2];
  EXPECT_GT(included, 0);
  EXPECT_GT(removed[0], 0);
  EXPECT_LT(removed[0], results[0].kernel[2 * n + 2]);
  EXPECT_LT(std::abs(removed[1] - removed[0]), 0.2 * included);
}

} // namespace
} // namespace bem_contact::fem::test
