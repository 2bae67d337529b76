#include "bem_contact/sequence/numbers/add_wheel.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace bem_contact {

namespace {

/// Inclination of one row and dx / (2 R).
struct Radial {
  double inclination, half_step;

  /// Adds the integral of u_r / R to A_xj of that row; A_sj and A_nj are `sign` times these.
  void add_to(std::span<double> line, std::span<const double> of_s, std::span<const double> of_n,
              double sign) const {
    // Outwards is -e_n at inclination 0: on a roller; and on a wheel, whose own frame is the contact frame
    // turned by pi about x (base/conventions.hpp).
    const double along_s = -std::sin(inclination), along_n = -std::cos(inclination);
    double sum = 0, before = 0;
    for (std::size_t m = 0; m < line.size(); ++m) {
      const double here = sign * (along_s * of_s[m] + along_n * of_n[m]);
      sum += m > 0 ? half_step * (before + here) : 0.0;
      before = here;
      line[m] += sum;
    }
  }
};

/// A_xj(m; I, J) of one row I and A_xj(m; J, I), J <= I, with the radial displacement of each.
class LinesAlongX {
public:
  LinesAlongX(NumberLines& wheel, std::span<const double> inclination, double half_step)
      : offsets_(wheel.offsets()), own_(3 * static_cast<std::size_t>(wheel.columns()) * offsets_),
        opposite_(own_.size()) {
    for (int column = 0; column < wheel.columns(); ++column)
      for (int j = 0; j < 3; ++j) {
        std::ranges::copy(wheel.line(column, component_x, j), own(column, j).begin());
        std::ranges::transform(wheel.line(column, j, component_x), opposite(column, j).begin(),
                               [sign = parity(component_x, j)](double a) { return sign * a; });
        if (inclination.empty())
          continue;
        Radial{inclination[wheel.row()], half_step}.add_to(own(column, j), wheel.line(column, component_s, j),
                                                           wheel.line(column, component_n, j), 1);
        Radial{inclination[column], half_step}.add_to(opposite(column, j), wheel.line(column, j, component_s),
                                                      wheel.line(column, j, component_n),
                                                      parity(component_s, j));
      }
  }

  std::span<double> own(int column, int j) { return of(own_, column, j); }
  std::span<double> opposite(int column, int j) { return of(opposite_, column, j); }

private:
  std::span<double> of(std::vector<double>& all, int column, int j) const {
    return std::span(all).subspan((3 * static_cast<std::size_t>(column) + j) * offsets_, offsets_);
  }

  std::size_t offsets_;
  std::vector<double> own_, opposite_;
};

/// A line and where it is added: at offset m to pair.values[place + m (values of an offset)].
struct Addition {
  const double* line;
  double sign;
  std::size_t place;
};

/// T A T is A with the signs of parity(): T = diag(1, -1, -1).
std::vector<Addition> additions(NumberLines& wheel, LinesAlongX& along_x, const InfluenceNumbers& pair) {
  std::vector<Addition> all;
  const int row = wheel.row();
  all.reserve(18 * static_cast<std::size_t>(wheel.columns()));
  for (int column = 0; column <= row; ++column)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const bool x = i == component_x;
        const double sign = parity(i, j);
        all.push_back({(x ? along_x.own(column, j) : wheel.line(column, i, j)).data(), sign,
                       pair.index(0, row, i, column, j)});
        if (column < row) // Maxwell-Betti: parity(i, j) line(j, i)
          all.push_back({(x ? along_x.opposite(column, j) : wheel.line(column, j, i)).data(), x ? sign : 1,
                         pair.index(0, column, i, row, j)});
      }
  return all;
}

/// `table`: values of an offset.
void add_lines(std::span<const Addition> additions, std::size_t offsets, std::size_t table, double* values) {
  constexpr std::size_t block = 8; // offsets of a cache line
  for (std::size_t from = 0; from < offsets; from += block) {
    const std::size_t count = std::min(block, offsets - from);
    for (const Addition& a : additions) {
      double* place = values + a.place + from * table;
      for (std::size_t m = 0; m < count; ++m, place += table)
        *place += a.sign * a.line[from + m];
    }
  }
}

} // namespace

void add_wheel(NumberLines& wheel, std::span<const double> inclination, double radius,
               InfluenceNumbers& pair) {
  for (int i = 0; i < 3; ++i)
    for (int j = i + 1; j < 3; ++j) // those of the diagonal are not there yet
      std::ranges::transform(wheel.line(wheel.row(), j, i), wheel.line(wheel.row(), i, j).begin(),
                             [sign = parity(i, j)](double a) { return sign * a; });
  LinesAlongX along_x(wheel, inclination, 0.5 * pair.dx / radius);
  const std::size_t table = 9 * static_cast<std::size_t>(pair.rows) * static_cast<std::size_t>(pair.rows);
  add_lines(additions(wheel, along_x, pair), static_cast<std::size_t>(wheel.offsets()), table,
            pair.values.data());
}

void add_radial_displacement(std::span<const double> inclination, double radius, InfluenceNumbers& roller) {
  const auto offsets = static_cast<std::size_t>(roller.offsets);
  std::vector<double> x(offsets), s(offsets), n(offsets);
  for (const auto& [row_i, row_j] : roller.stored_rows())
    for (int j = 0; j < 3; ++j) {
      for (int m = 0; m < roller.offsets; ++m) {
        x[m] = roller.at(m, row_i, component_x, row_j, j);
        s[m] = roller.at(m, row_i, component_s, row_j, j);
        n[m] = roller.at(m, row_i, component_n, row_j, j);
      }
      Radial{inclination[row_i], 0.5 * roller.dx / radius}.add_to(x, s, n, 1);
      for (int m = 0; m < roller.offsets; ++m)
        roller.at(m, row_i, component_x, row_j, j) = x[m];
    }
}

} // namespace bem_contact
