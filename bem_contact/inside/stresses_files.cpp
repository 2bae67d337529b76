#include "bem_contact/inside/stresses_inside.hpp"

#include <cmath>
#include <fmt/ostream.h>
#include <fmt/ranges.h>
#include <ostream>
#include <span>

namespace bem_contact::inside {

using halfspace::Stress;

void write_csv(std::ostream& out, const StressesInside& inside) {
  const bool has_body = !inside.areas.empty() && !inside.areas.front().body.empty();
  fmt::print(out, "patch,s,depth,x,xx,ss,nn,xs,xn,sn{}\n",
             has_body ? ",flat_xx,flat_ss,flat_nn,flat_xs,flat_xn,flat_sn,error" : "");
  const auto print = [&](const Stress& t) {
    for (const double value : {t.xx, t.ss, t.nn, t.xs, t.xn, t.sn})
      fmt::print(out, ",{:.6g}", value);
  };
  for (std::size_t k = 0; k < inside.areas.size(); ++k) {
    const AreaStresses& area = inside.areas[k];
    for (std::size_t i = 0; i < area.points.size(); ++i)
      for (std::size_t j = 0; j < area.x.size(); ++j) {
        fmt::print(out, "{},{:.6g},{:.6g},{:.6g}", k + 1, area.points[i].s, area.points[i].depth, area.x[j]);
        print(area.best()[i][j]);
        if (has_body) {
          print(area.flat[i][j]);
          fmt::print(out, ",{:.3g}", area.error[i]);
        }
        fmt::print(out, "\n");
      }
  }
}

namespace {

struct NamedMeasure {
  const char* name;
  double (*measure)(const Stress&);
};
std::span<const NamedMeasure> named_measures() {
  static constexpr NamedMeasure all[] = {
      {"von_mises", halfspace::von_mises},
      {"largest_shear", halfspace::largest_shear},
      {"mean_stress", [](const Stress& t) { return (t.xx + t.ss + t.nn) / 3; }},
      {"xx", [](const Stress& t) { return t.xx; }},
      {"ss", [](const Stress& t) { return t.ss; }},
      {"nn", [](const Stress& t) { return t.nn; }},
      {"xs", [](const Stress& t) { return t.xs; }},
      {"xn", [](const Stress& t) { return t.xn; }},
      {"sn", [](const Stress& t) { return t.sn; }}};
  return all;
}

/// Cells of all sections by their corners. Points of one's own have no cells: each is a vertex.
using Cells = std::vector<std::vector<std::size_t>>;
constexpr int hexahedron = 12, vertex = 1; ///< VTK's numbers

void add_cells(const AreaStresses& area, std::size_t first, Cells& cells) {
  const std::size_t nx = area.x.size();
  const auto known = [&](std::size_t i) { return std::isfinite(area.best()[i].front().xx); };
  if (area.rows == 0) {
    for (std::size_t i = 0; i < area.points.size() * nx; ++i)
      cells.push_back({first + i});
    return;
  }
  for (std::size_t is = 0; is + 1 < area.rows; ++is)
    for (std::size_t id = 0; id + 1 < area.depths; ++id) {
      const std::size_t a = is * area.depths + id, b = a + area.depths;
      if (!known(a) || !known(a + 1) || !known(b) || !known(b + 1))
        continue;
      for (std::size_t j = 0; j + 1 < nx; ++j) {
        std::vector<std::size_t>& cell = cells.emplace_back();
        for (const std::size_t place : {j, j + 1})
          for (const std::size_t i : {a, b, b + 1, a + 1})
            cell.push_back(first + i * nx + place);
      }
    }
}

/// One array of the file: write() prints its numbers.
template <class Write>
void data_array(std::ostream& out, const char* type, const char* name, int components, const Write& write) {
  fmt::print(out, "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">\n", type,
             name, components);
  write();
  fmt::print(out, "</DataArray>\n");
}

void write_cells(std::ostream& out, const Cells& cells) {
  fmt::print(out, "<Cells>\n");
  data_array(out, "Int64", "connectivity", 1, [&] {
    for (const std::vector<std::size_t>& cell : cells)
      fmt::print(out, "{}\n", fmt::join(cell, " "));
  });
  std::size_t end = 0;
  data_array(out, "Int64", "offsets", 1, [&] {
    for (const std::vector<std::size_t>& cell : cells)
      fmt::print(out, "{}\n", end += cell.size());
  });
  data_array(out, "UInt8", "types", 1, [&] {
    for (const std::vector<std::size_t>& cell : cells)
      fmt::print(out, "{}\n", cell.size() == 1 ? vertex : hexahedron);
  });
  fmt::print(out, "</Cells>\n");
}

} // namespace

void write_vtu(std::ostream& out, const StressesInside& inside) {
  std::size_t count = 0;
  Cells cells;
  for (const AreaStresses& area : inside.areas) {
    add_cells(area, count, cells);
    count += area.points.size() * area.x.size();
  }
  const auto each = [&](const auto& use) {
    for (const AreaStresses& area : inside.areas)
      for (std::size_t i = 0; i < area.points.size(); ++i)
        for (std::size_t j = 0; j < area.x.size(); ++j)
          use(area, i, j);
  };
  const bool placed = !inside.areas.empty() && !inside.areas.front().positions.empty();
  fmt::print(
      out,
      "<?xml version=\"1.0\"?>\n<!-- stresses of bem_contact: x rolling direction, {} (mm); MPa, frame "
      "(x, s, n), tension positive -->\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
      "<UnstructuredGrid>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<Points>\n",
      placed ? "y right, z DOWN" : "arc length s, depth", count, cells.size());
  data_array(out, "Float64", "points", 3, [&] {
    each([&](const AreaStresses& area, std::size_t i, std::size_t j) {
      const Point2 p = placed ? area.positions[i] : Point2{area.points[i].s, area.points[i].depth};
      fmt::print(out, "{:.9g} {:.9g} {:.9g}\n", area.x[j], p.y, p.z);
    });
  });
  fmt::print(out, "</Points>\n");
  write_cells(out, cells);
  fmt::print(out, "<PointData Scalars=\"von_mises\">\n");
  for (const NamedMeasure& one : named_measures())
    data_array(out, "Float64", one.name, 1, [&] {
      each([&](const AreaStresses& area, std::size_t i, std::size_t j) {
        const Stress& t = area.best()[i][j];
        fmt::print(out, "{:.6g}\n", std::isfinite(t.xx) ? one.measure(t) : 0.0);
      });
    });
  fmt::print(out, "</PointData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
}

} // namespace bem_contact::inside
