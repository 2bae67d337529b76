#include "bem_contact/base/error.hpp"
#include "bem_contact/halfspace/flat_strip.hpp"
#include "fem_influence/solid/solid_body.hpp"
#include "fem_influence/solid/solid_check.hpp"
#include "fem_influence/solid/solid_surface.hpp"
#include "section_meshes.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>
#include <sstream>

namespace bem_contact::fem::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr double half = 48; // of the block along x and y, and its depth
const SolidRefinement as_it_was_read{.loads = {}, .smallest = 1e3, .reach = 1e3};

struct Box {
  int contact = 1;          ///< number of the top's group
  int sides = 3;            ///< and of the sides across y
  bool tetrahedron = false; ///< adds one
  double size = half;       ///< of y and z, mm
  double first = 3;         ///< edge of the first hexahedra, mm
};

/// x from 0 to half, y from -size to size, z from 0 to size in a few hexahedra.
void write_box(const std::filesystem::path& file, const Box& box = {}) {
  const auto [contact, sides, tetrahedron, size, first] = box;
  const std::vector<double> x = {0, first, 8, 20, half};
  std::vector<double> y, z;
  for (const double at : x)
    if (at <= size)
      z.push_back(at);
  for (std::size_t i = z.size() - 1; i > 0; --i)
    y.push_back(-z[i]);
  y.insert(y.end(), z.begin(), z.end());
  write_hexahedra(file,
                  {.x = x, .y = y, .z = z, .contact = contact, .sides = sides, .tetrahedron = tetrahedron});
}

/// Half of a tube between two radii, its section swept along x or (reference_radius > 0) about the axle over
/// half a turn; `curved`: with the comments that name the inner circle's arcs. MSH 2.2.
void write_tube(const std::filesystem::path& file, double outer, double inner, double length,
                double reference_radius, bool curved) {
  const int around = 24, layers = reference_radius > 0 ? 8 : 1;
  const auto at = [&](int layer, int ring, int i) { return 1 + (layer * 2 + ring) * around + i % around; };
  std::string nodes, elements, arcs;
  for (int layer = 0; layer <= layers; ++layer)
    for (int ring = 0; ring < 2; ++ring)
      for (int i = 0; i < around; ++i) {
        const double angle = 2 * std::numbers::pi * i / around, radius = ring == 0 ? outer : inner;
        const double x = length * layer / layers, y = radius * std::sin(angle), z = radius * std::cos(angle);
        const double turn = reference_radius > 0 ? x / reference_radius : 0, r = reference_radius + z;
        nodes += reference_radius > 0
                     ? fmt::format("{} {:.16g} {:.16g} {:.16g}\n", at(layer, ring, i), r * std::sin(turn), y,
                                   r * std::cos(turn) - reference_radius)
                     : fmt::format("{} {:.16g} {:.16g} {:.16g}\n", at(layer, ring, i), x, y, z);
      }
  int element = 0;
  const auto add = [&](int type, int group, const std::vector<int>& vertices) {
    elements += fmt::format("{} {} 2 {} {} {}\n", ++element, type, group, group, fmt::join(vertices, " "));
  };
  for (int i = 0; i < around; ++i) {
    for (int layer = 0; layer < layers; ++layer) {
      for (int ring = 0; ring < 2; ++ring)
        add(3, ring == 0 ? 1 : 2,
            {at(layer, ring, i), at(layer, ring, i + 1), at(layer + 1, ring, i + 1), at(layer + 1, ring, i)});
      std::vector<int> cell;
      for (const int l : {layer, layer + 1})
        for (const auto& [ring, j] : {std::pair{0, i}, {0, i + 1}, {1, i + 1}, {1, i}})
          cell.push_back(at(l, ring, j));
      add(5, 10, cell);
    }
    for (const int layer : {0, layers})
      add(3, 4, {at(layer, 0, i), at(layer, 0, i + 1), at(layer, 1, i + 1), at(layer, 1, i)});
    for (const double part : {i + 0.0, i + 0.4, i + 1.0}) {
      const double angle = 2 * std::numbers::pi * part / around;
      arcs += fmt::format("{:.16g} {:.16g} ", inner * std::sin(angle), inner * std::cos(angle));
    }
    arcs += "\n";
  }
  std::string text = fmt::format("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{}\n{}$EndNodes\n$Elements\n"
                                 "{}\n{}$EndElements\n",
                                 at(layers, 1, around - 1), nodes, element, elements);
  if (curved)
    text += "$Comments\ncurved edges, y z of an end, of a point between, of the other end\n" + arcs +
            "$EndComments\n";
  write_text(file, text);
}

BodyFile block() {
  BodyFile body;
  body.body.kind = BodyKind::block;
  body.strip = {-4, 4, 1};
  body.solid.offsets = 4;
  body.solid.elements_per_load = 4;
  body.solid.grading = 0.5;
  return body;
}

class Solid : public ::testing::Test {
protected:
  std::string error_of(const BodyFile& body = block(), const std::vector<int>& loads = {4}) {
    try {
      solid_numbers(body, straight_line(half), folder_ / "box.msh", {.loads = loads});
    } catch (const InputError& error) {
      return error.what();
    }
    return "no InputError";
  }
  Folder folder_;
};

TEST_F(Solid, flat_block_converges_to_the_halfspace) {
  write_box(folder_ / "box.msh");
  BodyFile body = block();
  const InfluenceNumbers exact = halfspace::influence_numbers(body.material, 1, 1, 4, 8);
  double before = 0;
  for (const int elements : {2, 4}) {
    body.solid.elements_per_load = elements;
    const SolidNumbers numbers =
        solid_numbers(body, straight_line(half), folder_ / "box.msh", {.loads = {4}});
    double self = 0;
    for (int i = 0; i < 3; ++i) {
      // The block's own motion reaches some percent of the self number: the differences to the elements
      // three millimetres off are free of it.
      const double here = numbers.at(0, i, 0, 4, i) - numbers.at(0, i, 0, 1, i),
                   there = exact.at(0, 4, i, 4, i) - exact.at(0, 1, i, 4, i);
      self = std::max(self, std::abs(here / there - 1));
    }
    if (before > 0) {
      EXPECT_LT(self, 0.006);
      EXPECT_LT(self, before / 2.5);
    }
    before = self;
  }
}

TEST_F(Solid, loads_of_one_mesh_are_reciprocal_and_the_field_is_written) {
  write_box(folder_ / "box.msh");
  BodyFile body = block();
  body.solid.elements_per_load = 1;
  body.solid.loads_at_once = 2;
  const SolidNumbers numbers =
      solid_numbers(body, straight_line(half), folder_ / "box.msh",
                    {.loads = {2, 5}, .field = {folder_ / "field.vtu", 5, component_n}});
  EXPECT_LT(numbers.report.betti_error, 1e-10);
  EXPECT_GT(numbers.at(0, component_n, 0, 2, component_n), 0);
  EXPECT_LT(numbers.at(0, component_n, 1, 2, component_x),
            0); // a pressure pulls what lies ahead towards itself
  std::ifstream in(folder_ / "field.vtu");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  EXPECT_THAT(text, AllOf(HasSubstr("VTKFile"), HasSubstr("displacement_mm")));
}

TEST_F(Solid, curved_sides_off_the_profile_are_curved) {
  const double outer = 10, inner = 4, area = std::numbers::pi * (outer * outer - inner * inner);
  for (const double reference_radius : {0.0, 40.0}) {
    const double length = reference_radius > 0 ? std::numbers::pi * reference_radius : 5;
    const ContactSurface surface(full_circle(outer, false), reference_radius);
    const auto error = [&](bool curved) {
      write_tube(folder_ / "tube.msh", outer, inner, length, reference_radius, curved);
      const SolidMesh mesh(folder_ / "tube.msh", surface);
      const SolidBody body(mesh, 3, as_it_was_read);
      double volume = 0;
      body.for_each_cell([&](const SolidCellView& cell) {
        for (const double weight : cell.weight)
          volume += weight;
      });
      return std::abs(volume / (area * length) - 1); // Pappus: the centroid lies at the reference radius
    };
    EXPECT_GT(error(false), 1e-3); // the inner wall is a polygon
    EXPECT_LT(error(true), 1e-6);
  }
}

TEST_F(Solid, a_field_that_cannot_be_written_is_refused_on_one_line) {
  write_box(folder_ / "box.msh");
  const ContactSurface surface(straight_line(half), 0);
  const SolidMesh mesh(folder_ / "box.msh", surface);
  const SolidBody body(mesh, 1, as_it_was_read);
  const std::vector<double> none(3 * body.node_count(), 0.0);
  body.write_vtu(folder_ / "field.vtu", none);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "field.vtu"));
  try {
    body.write_vtu(folder_ / "absent" / "field.vtu", none);
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("field.vtu' cannot be written"), Not(HasSubstr("\n"))));
  }
}

TEST_F(Solid, refuses_what_does_not_fit) {
  EXPECT_THAT(error_of(), AllOf(HasSubstr("cannot be read"), HasSubstr("mesh_body --solid")));
  write_box(folder_ / "box.msh", {.contact = 7});
  EXPECT_THAT(error_of(), HasSubstr("has no group 'contact' (physical surface 1)"));
  write_box(folder_ / "box.msh", {.tetrahedron = true});
  EXPECT_THAT(error_of(), HasSubstr("hexahedra"));
  write_box(folder_ / "box.msh");
  EXPECT_THAT(error_of(block(), {8}), HasSubstr("There is no station 8 to load (the strip has 8"));
  BodyFile far = block();
  far.solid.offsets = 80;
  far.solid.elements_per_load = 1;
  EXPECT_THAT(error_of(far), HasSubstr("The mesh's group 'contact' does not cover the strip"));
  BodyFile bore = block();
  bore.strip = {4, 12, 1};
  try {
    solid_numbers(bore, full_circle(40, true), folder_ / "box.msh", {.loads = {4}});
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("does not fit the profile"));
  }
}

TEST(SolidSurface, frame_and_places_of_a_roller) {
  const ContactSurface surface(straight_line(20), -460); // the axle lies below
  for (const double x : {0.0, 3.0, -2.0, 460 * std::numbers::pi}) {
    const Vector3 p = surface.position({5, x});
    EXPECT_NEAR(p[0], 460 * std::sin(x / 460), 1e-9);
    EXPECT_NEAR(p[2], 460 * (1 - std::cos(x / 460)), 1e-9); // the surface falls off to both sides
    const SurfacePoint back = surface.nearest(p);
    EXPECT_NEAR(back.s, 5, 1e-9);
    EXPECT_NEAR(back.x, x, 1e-9);
    const auto frame = surface.frame({5, x});
    EXPECT_NEAR(frame[component_n][0], -std::sin(x / 460), 1e-12); // towards the axle
    EXPECT_NEAR(frame[component_n][2], std::cos(x / 460), 1e-12);
    EXPECT_NEAR(frame[component_x][2], std::sin(x / 460), 1e-12);
  }
}

TEST(SolidSurface, frame_and_places_of_a_wheel) {
  const ContactSurface surface(straight_line(20, true), 460);
  for (const double x : {0.0, 3.0, -2.0, 460 * std::numbers::pi}) {
    const Vector3 p = surface.position({5, x});
    const SurfacePoint back = surface.nearest(p);
    EXPECT_NEAR(back.s, 5, 1e-9);
    EXPECT_NEAR(back.x, x, 1e-9);
    const auto frame = surface.frame({5, x});
    EXPECT_NEAR(frame[component_n][0], -std::sin(x / 460), 1e-12); // into the wheel: towards the axle
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        double product = 0;
        for (std::size_t c = 0; c < 3; ++c)
          product += frame[i][c] * frame[j][c];
        EXPECT_NEAR(product, i == j ? 1 : 0, 1e-12);
      }
  }
}

TEST(SolidSurface, a_patch_is_shared_out_among_skewed_faces) {
  const SurfacePatch patch{-0.3, 0.4, 0, 0.5};
  // Two faces whose common side runs aslant through the patch.
  const std::array<SurfacePoint, 4> left{{{-1, 0}, {0.2, 0}, {-1, 1}, {-0.4, 1}}},
      right{{{0.2, 0}, {1, 0}, {-0.4, 1}, {1, 1}}};
  double area = 0, moment = 0;
  for (const auto& face : {left, right})
    for_each_common_point(face, patch, [&](const FacePoint& p) {
      area += p.weight;
      moment += p.weight * p.place.s * p.place.s * p.place.x;
      const double low = (1 - p.xi) * face[0].s + p.xi * face[1].s,
                   high = (1 - p.xi) * face[2].s + p.xi * face[3].s;
      EXPECT_NEAR((1 - p.eta) * low + p.eta * high, p.place.s, 1e-12);
    });
  EXPECT_NEAR(area, patch.area(), 1e-12);
  EXPECT_NEAR(moment, (0.4 * 0.4 * 0.4 + 0.3 * 0.3 * 0.3) / 3 * 0.125, 1e-12);
}

} // namespace
} // namespace bem_contact::fem::test
