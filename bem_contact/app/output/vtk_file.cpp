#include "bem_contact/app/output/vtk_file.hpp"

#include "bem_contact/base/output_file.hpp"

#include <fmt/ostream.h>
#include <ostream>

namespace bem_contact::app {

namespace {

/// The edges of the rows: half way between their middles, half a row beyond the first and the last.
std::vector<Point2> row_edges(const ContactProblem& problem) {
  const auto& rows = problem.rows;
  const double half = 0.5 * problem.grid.ds;
  std::vector<Point2> edges{rows.front().position - half * tangent_of(rows.front().delta)};
  for (std::size_t i = 0; i + 1 < rows.size(); ++i)
    edges.push_back(0.5 * (rows[i].position + rows[i + 1].position));
  edges.push_back(rows.back().position + half * tangent_of(rows.back().delta));
  return edges;
}

template <class Value>
void data_array(std::ostream& out, const std::string& name, int components, int count, const Value& value) {
  fmt::print(out, "<DataArray type=\"Float64\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">\n",
             name, components);
  for (int i = 0; i < count; ++i)
    for (int c = 0; c < components; ++c)
      fmt::print(out, "{:.9g}{}", value(i, c), c + 1 == components ? '\n' : ' ');
  fmt::print(out, "</DataArray>\n");
}

void write(std::ostream& out, const SceneResult& result) {
  const ContactProblem& problem = result.problem;
  const ContactGrid& grid = problem.grid;
  const ContactResult& r = result.result;
  const std::string extent = fmt::format("0 {} 0 {} 0 0", grid.mx, grid.ms);
  fmt::print(out,
             "{}{}: x rolling direction, y right, z DOWN (mm); tractions on the rail, "
             "MPa -->\n"
             "<VTKFile type=\"StructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
             "<StructuredGrid WholeExtent=\"{}\">\n<Piece Extent=\"{}\">\n<Points>\n",
             surface_begin, name_of(result.choice.model), extent, extent);
  const std::vector<Point2> edges = row_edges(problem);
  const int columns = grid.mx + 1;
  data_array(out, "points", 3, columns * (grid.ms + 1), [&](int i, int c) {
    const Point2 p = edges[i / columns];
    return c == 0 ? grid.x0 + (i % columns - 0.5) * grid.dx : c == 1 ? p.y : p.z;
  });
  fmt::print(out, "</Points>\n<CellData Scalars=\"pressure\" Vectors=\"traction\">\n");
  const auto at = [](const std::vector<double>& field, int i) { return field.empty() ? 0.0 : field[i]; };
  /// A vector (x, s, n) of an element in the track frame.
  const auto turned = [&](int i, int c, double x, double s, double n) {
    const double delta = problem.rows[i / grid.mx].delta;
    const Point2 v = s * tangent_of(delta) + n * normal_of(delta);
    return c == 0 ? x : c == 1 ? v.y : v.z;
  };
  const int n = grid.size();
  data_array(out, "pressure", 1, n, [&](int i, int) { return at(r.pn, i); });
  data_array(out, "traction", 3, n,
             [&](int i, int c) { return turned(i, c, at(r.px, i), at(r.ps, i), at(r.pn, i)); });
  data_array(out, "shear_traction", 3, n,
             [&](int i, int c) { return turned(i, c, at(r.px, i), at(r.ps, i), 0); });
  data_array(out, "slip", 3, n,
             [&](int i, int c) { return turned(i, c, at(r.slip_x, i), at(r.slip_s, i), 0); });
  const Displacements& u = result.result.displacements;
  data_array(out, "displacement", 3, n,
             [&](int i, int c) { return turned(i, c, at(u.ux, i), at(u.us, i), at(u.un, i)); });
  const std::vector<double> power = friction_work_density(r);
  data_array(out, "friction_work_density", 1, n, [&](int i, int) { return at(power, i); });
  if (r.temperatures) {
    data_array(out, "T_rail", 1, n, [&](int i, int) { return r.temperatures->rail[i]; });
    data_array(out, "T_wheel", 1, n, [&](int i, int) { return r.temperatures->wheel[i]; });
  }
  data_array(out, "state", 1, n, [&](int i, int) { return r.state.empty() ? 0.0 : double(r.state[i]); });
  data_array(out, "undeformed_distance", 1, n, [&](int i, int) { return problem.gap[i]; });
  data_array(out, "deformed_distance", 1, n, [&](int i, int) { return at(r.deformed_distance, i); });
  fmt::print(out, "</CellData>\n</Piece>\n</StructuredGrid>\n</VTKFile>\n");
}

} // namespace

void write_vts(const std::filesystem::path& file, const SceneResult& result) {
  write_text(file, [&](std::ostream& out) { write(out, result); });
}

} // namespace bem_contact::app
