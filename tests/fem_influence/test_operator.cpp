#include "assemble.hpp"
#include "bem_contact/base/error.hpp"
#include "fem_influence/harmonic/section_operator.hpp"
#include "section_meshes.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>

namespace bem_contact::fem::test {
namespace {

constexpr double wheel_radius = 460;

double energy(const SectionOperator& op, double k, const std::vector<double>& u) {
  const auto f = op.apply(k, u);
  double sum = 0;
  for (std::size_t i = 0; i < u.size(); ++i)
    sum += u[i] * f[i];
  return sum;
}

/// A displacement of the same size that strains the body everywhere, to compare energies with.
std::vector<double> strained(const std::vector<Point2>& nodes, double size) {
  std::vector<double> u;
  for (const Point2 p : nodes)
    for (const double v : {p.z, p.y, p.y + 2 * p.z})
      u.push_back(size * v / 50);
  return u;
}

class Operator : public ::testing::Test {
protected:
  Operator() : mesh_(folder_ / "wheel.msh") { write_block_mesh(mesh_, 2, 4, 50, true, 1.6); }
  Folder folder_;
  std::filesystem::path mesh_;
};

TEST_F(Operator, curved_edges_off_the_profile_are_curved) {
  const double radius = 10, inner = 4;
  const int around = 24;
  const auto file = folder_ / "ring.msh";
  write_ring_mesh(file, radius, inner, around);
  const ProfileCurve circle = full_circle(radius, false);
  const auto error = [&] {
    const Section section(file, 3, circle, {-1, 1, 1});
    double area = 0;
    section.for_each_cell([&](const CellView& cell) {
      for (const CellPoint& point : cell.points)
        area += point.weight;
    });
    return std::abs(area / (std::numbers::pi * (radius * radius - inner * inner)) - 1);
  };
  EXPECT_GT(error(), 1e-3); // the inner circle is a polygon
  std::ofstream out(file, std::ios::app);
  out << "$Comments\ncurved edges, y z of an end, of a point between, of the other end\n";
  for (int i = 0; i < around; ++i) {
    for (const double part : {i + 0.0, i + 0.4, i + 1.0}) {
      const double angle = 2 * std::numbers::pi * part / around;
      out << fmt::format("{:.16g} {:.16g} ", inner * std::sin(angle), inner * std::cos(angle));
    }
    out << "\n";
  }
  out << "$EndComments\n" << std::flush;
  EXPECT_LT(error(), 1e-6);
}

TEST_F(Operator, rigid_motions_of_a_prism_carry_no_energy) {
  const Section section(mesh_, 2, straight_line(50, true), {-4, 4, 2});
  const auto op = assemble(section, Material{}, 0);
  const auto motions = rigid_motions(section.node_positions(), 0);
  ASSERT_EQ(motions.size(), 4u);
  for (const auto& u : motions)
    EXPECT_LT(std::abs(energy(op, 0, u)), 1e-10 * energy(op, 0, strained(section.node_positions(), 1)));
  // They do at another wavenumber: the test can fail.
  EXPECT_GT(energy(op, 0.02, motions[0]), 1e-4 * energy(op, 0.02, strained(section.node_positions(), 1)));
}

/// The rigid motions of a wheel that belong to wavenumber 1 / R_ref: across the axle (z) and tilting.
std::vector<std::vector<double>> across(std::span<const Point2> nodes) {
  std::vector<std::vector<double>> motions(2);
  for (const Point2 p : nodes) {
    motions[0].insert(motions[0].end(), {-1, 0, 1});
    motions[1].insert(motions[1].end(), {p.y, wheel_radius + p.z, -p.y});
  }
  return motions;
}

TEST_F(Operator, rigid_motions_of_a_wheel_carry_no_energy) {
  const Section section(mesh_, 2, straight_line(50, true), {-4, 4, 2});
  const auto op = assemble(section, Material{}, wheel_radius);
  for (const int n : {0, 1}) {
    const auto motions =
        n == 0 ? rigid_motions(section.node_positions(), wheel_radius) : across(section.node_positions());
    ASSERT_EQ(motions.size(), 2u);
    for (const auto& u : motions) {
      double size = 0;
      for (const double v : u)
        size = std::max(size, std::abs(v));
      const double reference = energy(op, n / wheel_radius, strained(section.node_positions(), size));
      EXPECT_LT(std::abs(energy(op, n / wheel_radius, u)), 1e-10 * reference) << "n = " << n;
      EXPECT_GT(energy(op, 2 / wheel_radius, u), 1e-7 * reference) << "n = " << n;
    }
  }
}

TEST_F(Operator, a_wheel_that_reaches_its_axle_is_refused) {
  const Section section(mesh_, 1, straight_line(50, true), {-4, 4, 2});
  double lowest = 0;
  for (const Point2 p : section.node_positions())
    lowest = std::min(lowest, p.z);
  ASSERT_LT(lowest, -10);
  for (const double radius : {-lowest, -0.5 * lowest}) // a node on the axle, nodes beyond it
    try {
      assemble(section, Material{}, radius);
      ADD_FAILURE() << "taken";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("reaches the axle"), std::string::npos) << error.what();
    }
  EXPECT_NO_THROW(assemble(section, Material{}, 1 - lowest));
}

TEST_F(Operator, wheel_of_huge_radius_is_a_prism) {
  const Section section(mesh_, 1, straight_line(50, true), {-4, 4, 2});
  const auto prism = assemble(section, Material{}, 0);
  double last = 0;
  for (const double radius : {1e5, 1e6}) {
    const auto wheel = assemble(section, Material{}, radius);
    double difference = 0, largest = 0;
    for (const double k : {0.0, 0.1, 1.0})
      for (std::size_t e = 0; e < prism.block.size(); ++e)
        for (std::size_t i = 0; i < 9; ++i) {
          difference = std::max(difference, std::abs(wheel.at(e, k)[i] - prism.at(e, k)[i]));
          largest = std::max(largest, std::abs(prism.at(e, k)[i]));
        }
    EXPECT_LT(difference / largest, 100 / radius);
    if (last > 0) {
      EXPECT_NEAR(last / difference, 10, 0.1); // falls as 1/R
    }
    last = difference;
  }
}

TEST_F(Operator, reversed_wavenumber_turns_the_longitudinal_component) {
  const Section section(mesh_, 2, straight_line(50, true), {-4, 4, 2});
  for (const double radius : {0.0, wheel_radius}) {
    const auto op = assemble(section, Material{}, radius);
    auto u = strained(section.node_positions(), 1);
    const double k = 0.3, forward = energy(op, k, u);
    for (std::size_t d = 0; d < u.size(); d += 3)
      u[d] = -u[d];
    EXPECT_NEAR(energy(op, -k, u), forward, 1e-11 * forward);
    EXPECT_GT(std::abs(energy(op, k, u) - forward), 1e-3 * forward);
  }
}

TEST_F(Operator, uniform_strains_have_their_energy) {
  // Plane strain: u_y = c y on a block of area A stores (lambda + 2 mu) c^2 A; antiplane u_x = c z: mu c^2 A.
  const Section section(mesh_, 2, straight_line(50, true), {-4, 4, 2});
  const Material material;
  const auto op = assemble(section, material, 0);
  const double mu = material.shear_modulus, lambda = 2 * mu * material.poisson / (1 - 2 * material.poisson);
  std::vector<double> stretch, shear;
  for (const Point2 p : section.node_positions()) {
    stretch.insert(stretch.end(), {0.0, 1e-3 * p.y, 0.0});
    shear.insert(shear.end(), {1e-3 * p.z, 0.0, 0.0});
  }
  const double area = 100 * 50;
  EXPECT_NEAR(energy(op, 0, stretch), (lambda + 2 * mu) * 1e-6 * area, 1e-9 * mu);
  EXPECT_NEAR(energy(op, 0, shear), mu * 1e-6 * area, 1e-9 * mu);
}

} // namespace
} // namespace bem_contact::fem::test
