#include "bem_contact/app/commands/numbers_file.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/record/file_kinds.hpp"
#include "bem_contact/record/hdf5.hpp"
#include "bem_contact/sequence/scene_record.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <ostream>

namespace bem_contact::app {

namespace {

using Block = std::array<std::array<double, 3>, 3>; ///< [displacement][traction]

/// 1, part of the self number. One matrix serves all rows if numbers of equal distance differ by less than
/// this along the strip. Chosen, not measured.
constexpr double largest_variation = 0.01;

Block block_at(const InfluenceNumbers& a, int m, int row_i, int row_j) {
  Block block{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      block[i][j] = a.at(m, row_i, i, row_j, j);
  return block;
}

double self_number(const InfluenceNumbers& a) {
  return a.at(0, a.rows / 2, component_n, a.rows / 2, component_n);
}

/// Mean over all pairs of rows `distance` = I - J apart, and how much they differ, largest.
std::pair<Block, double> mean_of_distance(const InfluenceNumbers& a, int m, int distance) {
  Block mean{}, low{}, high{};
  const int first = std::max(0, -distance), last = std::min(a.rows, a.rows - distance);
  for (int row_j = first; row_j < last; ++row_j) {
    const Block b = block_at(a, m, row_j + distance, row_j);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        mean[i][j] += b[i][j] / (last - first);
        low[i][j] = row_j == first ? b[i][j] : std::min(low[i][j], b[i][j]);
        high[i][j] = row_j == first ? b[i][j] : std::max(high[i][j], b[i][j]);
      }
  }
  double variation = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      variation = std::max(variation, high[i][j] - low[i][j]);
  return {mean, variation};
}

/// One line of the text format: the normal first, in displacements and in tractions (its order 312).
std::string contact_line(int m, double x, const Block& b, double scale) {
  constexpr std::array<int, 3> order = {component_n, component_x, component_s};
  std::string line = fmt::format("{:4d} {:11.5f}", m, x);
  for (const int i : order)
    for (const int j : order)
      line += fmt::format(" {:24.16e}", scale * b[i][j]);
  return line + "\n";
}

} // namespace

void write_numbers_h5(const std::filesystem::path& file, const PlainNumbers& plain) {
  const InfluenceNumbers& a = plain.numbers;
  const auto mx = static_cast<std::size_t>(a.offsets), my = static_cast<std::size_t>(a.rows);
  const InfluenceNumbers written_out = with_every_pair_of_rows(a);
  record::Record out = headed(numbers_format);
  out.add("influence_numbers",
          record::field(
              {written_out.values.begin(), written_out.values.end()}, "mm/MPa",
              "[m][I][i][J][j]: displacement i of element (m, I), averaged over it, under 1 MPa of traction "
              "j on element (0, J); i, j = 0 x, 1 s, 2 n; m < 0: times -1 where exactly one of i, j is x",
              {mx, my, 3, my, 3}));
  std::vector<double> x;
  for (int m = 0; m < a.offsets; ++m)
    x.push_back(m * a.dx);
  out.add("offset", record::field(std::move(x), "mm", "x of the displaced element less x of the loaded one"));
  for (const auto& [name, values] : plain.rows)
    out.add(name, record::field(values, "mm", "arc length of the rows' centres on that body's profile"));
  out.add("dx", record::Number{a.dx, "mm", "length of an element"});
  out.add("ds", record::Number{a.ds, "mm", "width of an element"});
  for (const auto& [name, text] : plain.remarks)
    out.add(name, text);
  record::write_hdf5(file, out);
}

void write_numbers_csv(const std::filesystem::path& file, const PlainNumbers& plain) {
  const InfluenceNumbers& a = plain.numbers;
  write_text(file, [&](std::ostream& out) {
    out << "# " << numbers_format << '\n';
    out << fmt::format("# dx: {:.17g} mm\n# ds: {:.17g} mm\n", a.dx, a.ds);
    for (const auto& [name, text] : plain.remarks)
      out << "# " << name << ": " << text << '\n';
    for (const auto& [name, values] : plain.rows)
      out << fmt::format("# {}: {:.17g} .. {:.17g} mm\n", name, values.front(), values.back());
    out << "# ij: displacement i of element (m, I) in mm under 1 MPa of traction j on element (0, J)\n"
        << "m,I,J,xx,xs,xn,sx,ss,sn,nx,ns,nn\n";
    for (int m = 0; m < a.offsets; ++m)
      for (int row_i = 0; row_i < a.rows; ++row_i)
        for (int row_j = 0; row_j < a.rows; ++row_j) {
          out << fmt::format("{},{},{}", m, row_i, row_j);
          for (int e = 0; e < 9; ++e)
            out << fmt::format(",{:.17g}", a.at(m, row_i, e / 3, row_j, e % 3));
          out << '\n';
        }
  });
}

double variation_along_the_strip(const InfluenceNumbers& a) {
  double largest = 0;
  for (int m = 0; m < a.offsets; ++m)
    for (int distance = 0; distance < a.rows; ++distance)
      largest = std::max(largest, mean_of_distance(a, m, distance).second);
  return largest / self_number(a);
}

void write_numbers_contact(const std::filesystem::path& file, const PlainNumbers& plain, Matrices matrices) {
  const InfluenceNumbers& a = plain.numbers;
  const bool one = matrices == Matrices::one;
  if (one) {
    const double variation = variation_along_the_strip(a);
    if (variation > largest_variation)
      throw InputError(
          "One matrix of influence coefficients does not serve this strip",
          fmt::format("numbers of rows equally far apart differ by up to {:.1f} % of self, {:g} % "
                      "are allowed",
                      100 * variation, 100 * largest_variation),
          "Use --matrices each, or a shorter strip of constant curvature.");
  }
  constexpr const char* columns = "% ix  x   n-displacement due to pn, px, ps;  x-displacement due to pn, "
                                  "px, ps;  s-displacement due to pn, px, "
                                  "ps\n";
  write_text(file, [&](std::ostream& out) {
    out << fmt::format("{:4d} 1   % nmatrix, iaconvex: number of matrices, the rail is the upper body (1)\n",
                       one ? 1 : a.rows)
        << "   0 312   % lquasid, xyzorder: general, 9 columns a point, order n, x, s\n"
        << "   1 0   % lsymmx, lsymmy: symmetry in x, none in s\n"
        << fmt::format(
               "{:4d} {:4d} {:.10g} {:.10g}   % mx, my, dx, dy (mm); u = C p / G with G = {:.10g} MPa\n",
               a.offsets, a.rows, a.dx, a.ds, plain.shear_modulus);
    const std::string bar = '%' + std::string(60, '-') + '\n';
    for (int row_j = 0; row_j < (one ? 1 : a.rows); ++row_j) {
      const double centre = (row_j - 0.5 * (a.rows - 1)) * a.ds;
      if (!one)
        out << bar << fmt::format("% matrix {}: load on row {}\n", row_j + 1, row_j + 1) << bar
            << fmt::format("{:4d} {:8.3f} {:10.5f}   % matrix, centre of the loaded element (x, s)\n",
                           row_j + 1, 0.0, centre);
      for (int distance = 1 - a.rows; distance < a.rows; ++distance) {
        const int row_i = row_j + distance;
        const bool inside = one || (row_i >= 0 && row_i < a.rows);
        out << fmt::format("% offset in s {} ({:.5f} mm){}\n", distance, distance * a.ds,
                           inside ? "" : ": off the grid, never used")
            << columns;
        for (int m = 0; m < a.offsets; ++m)
          out << contact_line(m, m * a.dx,
                              one      ? mean_of_distance(a, m, distance).first
                              : inside ? block_at(a, m, row_i, row_j)
                                       : Block{},
                              plain.shear_modulus);
      }
    }
  });
}

} // namespace bem_contact::app
