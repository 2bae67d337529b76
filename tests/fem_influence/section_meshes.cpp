#include "section_meshes.hpp"

#include <gtest/gtest.h>
#include <mpi.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <iomanip>
#include <numbers>
#include <sstream>

namespace bem_contact::fem::test {

namespace {

class Mpi : public ::testing::Environment {
  void SetUp() override { MPI_Init(nullptr, nullptr); }
  void TearDown() override { MPI_Finalize(); }
};
[[maybe_unused]] const auto* const mpi = ::testing::AddGlobalTestEnvironment(new Mpi);

struct Line {
  int id, a, b;
};

void write_msh(const std::filesystem::path& file, const std::vector<Point2>& points,
               const std::vector<Line>& lines, const std::vector<std::array<int, 4>>& quads) {
  std::ofstream out(file);
  out << std::setprecision(17) << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" << points.size() << '\n';
  for (std::size_t i = 0; i < points.size(); ++i)
    out << i + 1 << ' ' << points[i].y << ' ' << points[i].z << " 0\n";
  out << "$EndNodes\n$Elements\n" << lines.size() + quads.size() << '\n';
  int number = 0;
  for (const auto& line : lines)
    out << ++number << " 1 2 " << line.id << ' ' << line.id << ' ' << line.a + 1 << ' ' << line.b + 1 << '\n';
  for (const auto& quad : quads) {
    out << ++number << " 3 2 10 10";
    for (const int vertex : quad)
      out << ' ' << vertex + 1;
    out << '\n';
  }
  out << "$EndElements\n";
}

} // namespace

Folder::Folder() {
  static int count = 0;
  path_ = std::filesystem::temp_directory_path() /
          ("conformal_fem_" + std::to_string(getpid()) + "_" + std::to_string(count++));
  std::filesystem::create_directories(path_);
}

Folder::~Folder() {
  std::filesystem::remove_all(path_);
}

void write_text(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file) << text;
}

std::vector<double> graded(double h, double inner, double outer, double ratio) {
  std::vector<double> x;
  const auto fine = static_cast<int>(std::lround(inner / h));
  for (int i = 0; i <= fine; ++i)
    x.push_back(i * h);
  for (double step = h * ratio; x.back() + step < outer - 0.5 * step; step *= ratio)
    x.push_back(x.back() + step);
  x.push_back(outer);
  return x;
}

void write_block_mesh(const std::filesystem::path& file, double h, double strip_half, double size, bool up,
                      double ratio) {
  const auto half = graded(h, strip_half, size, ratio), depth = graded(h, 2 * h, size, ratio);
  std::vector<double> across;
  for (std::size_t i = half.size() - 1; i > 0; --i)
    across.push_back(-half[i]);
  across.insert(across.end(), half.begin(), half.end());
  const int n = static_cast<int>(across.size()), m = static_cast<int>(depth.size());
  const double sign = up ? -1 : 1;
  std::vector<Point2> points;
  for (const double z : depth)
    for (const double y : across)
      points.push_back({sign * y, sign * z}); // half a turn keeps the orientation
  std::vector<Line> lines;
  std::vector<std::array<int, 4>> quads;
  const auto at = [n](int i, int j) { return j * n + i; };
  for (int i = 0; i + 1 < n; ++i) {
    const bool strip =
        std::abs(0.5 * (across[static_cast<std::size_t>(i)] + across[static_cast<std::size_t>(i) + 1])) <
        strip_half;
    lines.push_back({strip ? 1 : 3, at(i, 0), at(i + 1, 0)});
    lines.push_back({2, at(i, m - 1), at(i + 1, m - 1)});
  }
  for (int j = 0; j + 1 < m; ++j) {
    lines.push_back({2, at(0, j), at(0, j + 1)});
    lines.push_back({2, at(n - 1, j), at(n - 1, j + 1)});
    for (int i = 0; i + 1 < n; ++i)
      quads.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  }
  write_msh(file, points, lines, quads);
}

void write_ring_mesh(const std::filesystem::path& file, double radius, double end_radius, int around) {
  const double step = 2 * std::numbers::pi / around * (end_radius < radius ? -1 : 1);
  const auto rings = static_cast<int>(std::ceil(std::log(end_radius / radius) / step));
  std::vector<Point2> points;
  for (int j = 0; j <= rings; ++j)
    for (int i = 0; i < around; ++i) {
      const double r = radius * std::pow(end_radius / radius, double(j) / rings);
      const double angle = 2 * std::numbers::pi * i / around;
      points.push_back({r * std::sin(angle), r * std::cos(angle)});
    }
  std::vector<Line> lines;
  std::vector<std::array<int, 4>> quads;
  const auto at = [around](int i, int j) { return j * around + i % around; };
  for (int i = 0; i < around; ++i) {
    lines.push_back({1, at(i, 0), at(i + 1, 0)});
    lines.push_back({2, at(i, rings), at(i + 1, rings)});
    for (int j = 0; j < rings; ++j)
      quads.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  }
  write_msh(file, points, lines, quads);
}

void write_hexahedra(const std::filesystem::path& file, const Hexahedra& mesh) {
  const auto& [x, y, z, contact, sides, tetrahedron, wider] = mesh;
  const auto at = [&](std::size_t i, std::size_t j, std::size_t k) {
    return 1 + i + x.size() * (j + y.size() * k);
  };
  std::ostringstream nodes, elements;
  std::size_t node = 0, element = 0;
  for (const double c : z)
    for (const double b : y)
      for (const double a : x)
        nodes << ++node << ' ' << a << ' ' << b * wider(a) << ' ' << c << '\n';
  const auto quad = [&](int group, std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
    elements << ++element << " 3 2 " << group << ' ' << group << ' ' << a << ' ' << b << ' ' << c << ' ' << d
             << '\n';
  };
  const std::size_t nx = x.size() - 1, ny = y.size() - 1, nz = z.size() - 1;
  for (std::size_t i = 0; i < nx; ++i)
    for (std::size_t j = 0; j < ny; ++j) {
      quad(contact, at(i, j, 0), at(i + 1, j, 0), at(i + 1, j + 1, 0), at(i, j + 1, 0));
      quad(2, at(i, j, nz), at(i + 1, j, nz), at(i + 1, j + 1, nz), at(i, j + 1, nz));
    }
  for (std::size_t k = 0; k < nz; ++k) {
    for (std::size_t j = 0; j < ny; ++j) {
      quad(4, at(0, j, k), at(0, j + 1, k), at(0, j + 1, k + 1), at(0, j, k + 1));
      quad(3, at(nx, j, k), at(nx, j + 1, k), at(nx, j + 1, k + 1), at(nx, j, k + 1));
    }
    for (std::size_t i = 0; i < nx; ++i)
      for (const std::size_t j : {std::size_t{0}, ny})
        quad(sides, at(i, j, k), at(i + 1, j, k), at(i + 1, j, k + 1), at(i, j, k + 1));
  }
  for (std::size_t k = 0; k < nz; ++k)
    for (std::size_t j = 0; j < ny; ++j)
      for (std::size_t i = 0; i < nx; ++i) {
        elements << ++element << " 5 2 10 10";
        for (const std::size_t c : {k, k + 1})
          elements << ' ' << at(i, j, c) << ' ' << at(i + 1, j, c) << ' ' << at(i + 1, j + 1, c) << ' '
                   << at(i, j + 1, c);
        elements << '\n';
      }
  if (tetrahedron)
    elements << ++element << " 4 2 10 10 " << at(0, 0, 0) << ' ' << at(1, 0, 0) << ' ' << at(0, 1, 0) << ' '
             << at(0, 0, 1) << '\n';
  std::ofstream(file) << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n"
                      << node << '\n'
                      << nodes.str() << "$EndNodes\n$Elements\n"
                      << element << '\n'
                      << elements.str() << "$EndElements\n";
}

ProfileCurve straight_line(double half, bool up) {
  const double sign = up ? -1 : 1;
  const std::vector<Point2> points{
      {-sign * half, 0}, {-sign * half / 2, 0}, {0, 0}, {sign * half / 2, 0}, {sign * half, 0}};
  return ProfileCurve::through_points("straight line", points);
}

ProfileCurve full_circle(double radius, bool hole) {
  std::vector<Point2> points;
  const int n = 180;
  for (int i = -n; i <= n; ++i) {
    const double angle = std::numbers::pi * i / n;
    points.push_back({(hole ? 1 : -1) * radius * std::sin(angle), radius * std::cos(angle)});
  }
  return ProfileCurve::through_points("full circle", points);
}

} // namespace bem_contact::fem::test
