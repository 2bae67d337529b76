#include "bem_contact/halfspace/flat_strip.hpp"
#include "bem_contact/halfspace/resample.hpp"
#include "bem_contact/influence/influence_file.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "fem_influence/solid/patch_functionals.hpp"
#include "fem_influence/solid/solid_body.hpp"
#include "fem_influence/solid/solid_solver.hpp"
#include "section_meshes.hpp"
#include "tests/halfspace/strip_kernel.hpp"

#include <Eigen/Dense>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

/// A wheel on a nose that gets wider, by influence functions blended between two sections. The 3-D method,
/// which shares nothing with it, judges: the nose is a body of finite length there.
namespace bem_contact::fem::test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The nose of a crossing 1:9, its top flat. Sections have influence files at u = `from`, 10 mm wide, and at
/// `to`, 20 mm wide. It ends freely at `tip` and is held `deep` below the top. At `end` the 3-D body is
/// mirrored. mm.
constexpr double from = 0, to = 90, tip = -24, end = 168, deep = 40;
double width(double u) {
  return 10 + u / 9;
}

constexpr double dx = 0.5, ds = 0.25; ///< of elements, mm
constexpr double across = 700;        ///< where the nose lies in the track, mm

SparseColumns normal_functionals(const SolidBody& body, const ContactSurface& surface,
                                 const std::vector<SurfacePatch>& patches) {
  std::vector<std::size_t> columns;
  for (std::size_t i = 0; i < patches.size(); ++i)
    columns.push_back(3 * i + component_n);
  return select_columns(patch_functionals(body, surface, patches), columns);
}

/// The elements in contact of a solution, and what influence numbers make of them.
struct Loaded {
  std::vector<double> x, s; ///< centres, mm
  std::vector<int> column, row;
  VectorXd pressure; ///< MPa

  explicit Loaded(const SceneResult& r) {
    const ContactGrid& grid = r.problem.grid;
    std::vector<double> p;
    for (int i = 0; i < grid.ms; ++i)
      for (int k = 0; k < grid.mx; ++k)
        if (const double here = r.result.pn[std::size_t(i * grid.mx + k)]; here > 0) {
          x.push_back(grid.x(k)), s.push_back(r.problem.rows[std::size_t(i)].position.y - across);
          column.push_back(k), row.push_back(i), p.push_back(here);
        }
    pressure = Eigen::Map<const VectorXd>(p.data(), std::ssize(p));
  }
  /// Displacements along n: [displaced][loaded].
  MatrixXd by(const InfluenceNumbers& numbers) const {
    const auto n = pressure.size();
    MatrixXd a(n, n);
    for (Index i = 0; i < n; ++i)
      for (Index j = 0; j < n; ++j)
        a(i, j) = numbers.at(std::abs(column[std::size_t(i)] - column[std::size_t(j)]), row[std::size_t(i)],
                             component_n, row[std::size_t(j)], component_n);
    return a;
  }
  double length() const { return *std::ranges::max_element(x) - *std::ranges::min_element(x) + dx; }
};

/// By the 3-D method: the mean displacement of each element under all pressures, mm.
VectorXd displaced_by_solid(const std::filesystem::path& file, const Loaded& on, double along) {
  Hexahedra mesh{.x = {}, .y = {-0.5, -0.25, 0, 0.25, 0.5}, .z = {}}; // x = end - u
  for (int i = 0; i <= 48; ++i)
    mesh.x.push_back((end - tip) * i / 48);
  for (int i = 0; i <= 10; ++i)
    mesh.z.push_back(deep * i / 10);
  mesh.wider = [](double x) { return width(end - x); };
  write_hexahedra(file, mesh);
  const ContactSurface surface(straight_line(40), 0);
  const SolidMesh solid_mesh(file, surface);
  const SurfacePoint middle{0, end - along};
  const SolidBody solid(
      solid_mesh, 2, {.loads = {&middle, 1}, .load_radius = 5, .smallest = 1, .grading = 0.35, .reach = 15});
  std::vector<SurfacePatch> patches;
  for (std::size_t i = 0; i < on.x.size(); ++i) {
    const double x = end - along - on.x[i];
    patches.push_back({on.s[i] - ds / 2, on.s[i] + ds / 2, x - dx / 2, x + dx / 2});
  }
  const SparseColumns samples = normal_functionals(solid, surface, patches);
  ColumnSums load(1);
  for (std::size_t i = 0; i < patches.size(); ++i)
    samples.for_each_entry(i,
                           [&](int row, double value) { load.add(0, row, value * on.pressure[Index(i)]); });
  VectorXd out;
  SolidSolver(solid, Material{})
      .solve(MirrorSymmetry::even, load.sparse(), samples,
             [&](std::size_t, std::span<const double> sampled, std::span<const double>) {
               out = Eigen::Map<const VectorXd>(sampled.data(), std::ssize(sampled)) / patches[0].area();
             });
  return out;
}

/// By how much pressures change where a body yields by `more` (mm) than was thought: the elements in contact
/// stay, and the force.
VectorXd change_of_pressure(const MatrixXd& numbers, const VectorXd& more) {
  const Index n = more.size();
  MatrixXd system = MatrixXd::Zero(n + 1, n + 1);
  system.topLeftCorner(n, n) = numbers;
  system.col(n).head(n).setConstant(-1);
  system.row(n).head(n).setConstant(1);
  VectorXd right = VectorXd::Zero(n + 1);
  right.head(n) = -more;
  return system.partialPivLu().solve(right).head(n);
}

class SolidNose : public ::testing::Test {
protected:
  SolidNose() {
    make_section("narrow", width(from));
    make_section("wide", width(to));
    std::string points; // a wheel that is a half-space, its tread convex with a radius of 80 mm
    for (int i = -80; i <= 80; ++i)
      points += fmt::format("{:.12f} {:.12f}\n", -0.25 * i, std::sqrt(80 * 80 - 0.0625 * i * i) - 80);
    write_text(folder_ / "wheel.txt", points);
    write_influence("wheel", ProfileKind::wheel, halfspace_function(Material{}, 40, ds, dx, 300));
  }

  void make_section(const std::string& name, double wide) {
    const std::string body = (folder_ / (name + ".toml")).string(), mesh = (folder_ / "section.msh").string(),
                      file = (folder_ / "section.h5").string();
    write_text(body, fmt::format("[body]\nkind = 'outline'\nname = 'nose'\noutline = [ {{ to = [-{0}, 0] }}, "
                                 "{{ to = [{0}, 0], group = 'contact' }}, {{ to = [{0}, {1}] }}, "
                                 "{{ to = [-{0}, {1}], group = 'held' }} ]\n"
                                 "[strip]\nfrom = -4\nto = 4\nstation_width = {2}\n"
                                 "[harmonic]\nshortest_dx = {3}\n",
                                 wide / 2, deep, ds, dx));
    for (const std::string& command : {MESH_BODY_PROGRAM " " + body + " -o " + mesh,
                                       FEM_INFLUENCE_PROGRAM " " + body + " " + mesh + " -o " + file})
      EXPECT_EQ(std::system((command + " > /dev/null 2>&1").c_str()), 0) << command;
    std::string points;
    for (int i = -20; i <= 20; ++i)
      points += fmt::format("{:.12f} 0\n", wide / 40 * i);
    write_text(folder_ / (name + ".txt"), points);
    write_influence(name, ProfileKind::rail, read_influence_file(file));
    std::filesystem::remove(file);
  }
  /// As the file of the profile in a text file: the middle of its strip lies at y = 0.
  void write_influence(const std::string& name, ProfileKind kind, InfluenceFunction f) const {
    ProfileReading reading;
    reading.keep_origin = true;
    reading.unit = ProfileUnit::mm;
    reading.profile_z = ProfileZ::down;
    const ProfileCurve curve = named_profile(name + ".txt", kind, folder_ / "", reading);
    const double middle = curve.nearest({0, 0}).s;
    f.body = name_of(kind);
    f.profile = curve.name();
    f.profile_digest = curve.digest();
    for (Station& station : f.stations) {
      const CurvePoint p = curve.at(station.s + middle);
      station = {p.s, p.position, p.delta};
    }
    write_influence_file(folder_ / (name + ".h5"), f);
  }

  SceneResult solved(double along) const {
    SceneFile scene = parse_scene_file(fmt::format(
        "wheel = {{ profile = 'wheel.txt', influence = 'wheel.h5', {0} }}\nrail = {{ {0}, sections = [\n"
        "{{ at = {1}, profile = 'narrow.txt', influence = 'narrow.h5' }},\n"
        "{{ at = {2}, profile = 'wide.txt', influence = 'wide.h5' }} ] }}\n"
        "position = {{ wheel_radius = 460, along = {3} }}\nload.force = 1.5e4\ngrid = {{ dx = {4}, ds = {5} "
        "}}\n"
        "motion.frictionless = true\nsolver.model = 'fem'\n",
        fmt::format("place = 'absolute', y = {}, z = 0, profile_z = 'down', unit = 'mm'", across), from, to,
        along, dx, ds));
    scene.folder = folder_ / "";
    return Sequence().solve(scene);
  }
  /// Of a section that goes on all along, at the rows of this solution.
  InfluenceNumbers numbers_of(const std::string& name, const SceneResult& at,
                              StructuralCompliance structural) const {
    const InfluenceFunction f = read_influence_file(folder_ / (name + ".h5"));
    std::vector<double> s;
    for (const ContactRow& row : at.problem.rows)
      s.push_back(row.position.y - across + 0.5 * (f.stations.front().s + f.stations.back().s));
    return halfspace::resample(f, {.dx = dx, .offsets = at.problem.grid.mx + 2, .structural = structural}, s,
                               ds);
  }

  Folder folder_;
};

/// How far the nose yields with all of its motions, and the pressure that this means. Either section alone
/// would be wrong by more.
TEST_F(SolidNose, blended_numbers_are_wrong_by_less_than_stated) {
  for (const double along : {15.0, 45.0, 75.0}) {
    const SceneResult r = solved(along);
    ASSERT_TRUE(certified(r));
    const ContactTotals& totals = r.result.totals;
    const Loaded on(r);
    const double force = on.pressure.sum(), weight = (along - from) / (to - from);
    const auto mean = [&](const VectorXd& u) { return u.dot(on.pressure) / force; };
    const auto blend = [&](StructuralCompliance structural) -> MatrixXd {
      return (1 - weight) * on.by(numbers_of("narrow", r, structural)) +
             weight * on.by(numbers_of("wide", r, structural));
    };
    const VectorXd solid = displaced_by_solid(folder_ / "nose.msh", on, along);
    const VectorXd off = solid - blend(StructuralCompliance::included) * on.pressure;
    const MatrixXd wheel =
        on.by(halfspace::influence_numbers(Material{}, dx, ds, r.problem.grid.mx + 2, r.problem.grid.ms));
    const VectorXd pressure =
        on.pressure + change_of_pressure(blend(StructuralCompliance::removed) + wheel, off);
    fmt::print("{:g} mm along: yields by {:.2f} um, {:+.2f} off ({:.2f} stated); pmax {:.1f} MPa, {:+.2f} "
               "off ({:.1f} "
               "stated)\n",
               along, 1e3 * mean(solid), -1e3 * mean(off), 1e3 * totals.approach.error, totals.pmax.value,
               totals.pmax - pressure.maxCoeff(), totals.pmax.error);
    EXPECT_LT(std::abs(mean(off)), totals.approach.error);
    EXPECT_LT(std::abs(totals.pmax - pressure.maxCoeff()), 0.002 * totals.pmax);
    EXPECT_LT(std::abs(totals.pmax - pressure.maxCoeff()), totals.pmax.error);
    if (along == 45) { // half way
      for (const char* alone : {"narrow", "wide"})
        EXPECT_GT(
            std::abs(mean(solid - on.by(numbers_of(alone, r, StructuralCompliance::included)) * on.pressure)),
            totals.approach.error)
            << alone;
    }
  }
}

} // namespace
} // namespace bem_contact::fem::test
