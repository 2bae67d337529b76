#include "bem_contact/influence/expand.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/parallel.hpp"
#include "bem_contact/base/simd.hpp"
#include "bem_contact/influence/dense.hpp"
#include "bem_contact/influence/remote_factor.hpp"
#include "bem_contact/influence/requirements.hpp"
#include "bem_contact/influence/series_weights.hpp"
#include "bem_contact/influence/settings.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <string>
#include <vector>

namespace bem_contact {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Table = Eigen::Map<const RowMajor>;

/// 1. How far the phase of least_half_element_phase may fall short: rounding.
constexpr double phase_slack = 1e-9;
/// 1. How far the ratio of an element's length to a table's may be from a whole number: rounding.
constexpr double whole_ratio_slack = 1e-9;

/// Element length on the reference radius and the load's scale: A(x; a) = (Rc/R) A_ref(x R/Rc; a R/Rc), since
/// the kernel's unit load is per reference area.
struct Scaling {
  double dx = 0, load = 1;
};

constexpr Index remote_motions = 6; ///< of the remote section

/// line -= the sum over the motions of a b, each of which has `length` values for each motion.
BEM_CONTACT_WIDE void take_products(const double* a, const double* b, Index length, double* __restrict line) {
  const auto product = [=](Index at) { return a[at] * b[at]; };
  for (Index k = 0; k < length; ++k)
    line[k] -= product(k) + product(k + length) + product(k + 2 * length) + product(k + 3 * length) +
               product(k + 4 * length) + product(k + 5 * length);
}

/// What "removed" takes from the kernel at each wavenumber is factor^T factor, factor 6 x 3 stations.
class Removed {
public:
  Removed(const InfluenceFunction& f, StationRange range, StructuralCompliance structural, Index nk) {
    if (structural == StructuralCompliance::included)
      return;
    factor_.resize(nk, remote_motions * 3 * range.count);
    for (Index k = 0; k < nk; ++k)
      factor_.row(k) = remote_factor(f, range, k).reshaped();
  }

  /// Takes it from the kernel at (row, column) of the range, all wavenumbers.
  void take_from(double* line, Index row, Index column) const {
    if (factor_.size() > 0)
      take_products(factor_.col(remote_motions * row).data(), factor_.col(remote_motions * column).data(),
                    factor_.rows(), line);
  }

private:
  MatrixXd factor_; ///< [wavenumber][remote_motions column + motion], column-major
};

/// The kernel of one row of stations against the columns J <= I, as NumberLines has the numbers. The sign is
/// that of the sine series (influence_function.hpp): load p_j cos kx gives u_x = +g_xj sin kx, load p_x cos
/// kx gives u_i = -g_ix sin kx.
struct KernelRow {
  MatrixXd even, odd; ///< [wavenumber][5 J + e], [wavenumber][4 J + e], column-major
};

KernelRow kernel_row(const InfluenceFunction& f, StationRange range, Index row, const Removed& removed,
                     Index nk) {
  const Index columns = row + 1;
  KernelRow kernel{MatrixXd(nk, 5 * columns), MatrixXd(nk, 4 * columns)};
  const auto write = [&](double* line, Index from_row, Index from_column) {
    const auto in_file = [&](Index in_range) { return static_cast<std::size_t>(3 * range.first + in_range); };
    std::copy_n(&f.kernel[f.kernel_index(0, in_file(from_row), in_file(from_column))], nk, line);
    removed.take_from(line, from_row, from_column);
  };
  for (Index column = 0; column < columns; ++column) {
    for (Index e = 0; e < 5; ++e) {
      const auto [i, j] = NumberLines::even_entries[static_cast<std::size_t>(e)];
      write(&kernel.even(0, 5 * column + e), 3 * row + i, 3 * column + j);
    }
    for (Index e = 0; e < 4; ++e) {
      const auto [i, j] = NumberLines::odd_entries[static_cast<std::size_t>(e)];
      write(&kernel.odd(0, 4 * column + e), 3 * row + i, 3 * column + j);
      if (i != component_x)
        kernel.odd.col(4 * column + e) *= -1;
    }
  }
  return kernel;
}

/// The Fourier series of the kernel. Throws InputError where the structure cannot be removed.
void expand_kernel(const InfluenceFunction& f, const ExpandOptions& o, StationRange range,
                   const Scaling& scaling, const TakeLines& take) {
  const Index nk = o.dx == 0 ? 1 : static_cast<Index>(f.wavenumber_count());
  const Removed removed(f, range, o.structural, nk);
  MatrixXd even = MatrixXd::Ones(1, 1), odd = MatrixXd::Zero(1, 1); // plane strain: odd ones vanish at k = 0
  if (o.dx > 0) {
    SeriesStore only_now;
    const double angle = std::numbers::pi / f.half_period * scaling.dx * o.offsets;
    const SeriesWeights weights = series_weights(
        (o.series ? *o.series : only_now).get(f.wavenumber, f.half_period, angle), scaling.dx, o.offsets);
    even = Table(weights.even.data(), o.offsets, nk);
    odd = Table(weights.odd.data(), o.offsets, nk);
  }
  even *= scaling.load;
  odd *= scaling.load;
  // A row has one block more than the one before. The first and the last together, then the second and the
  // last but one, and so on, are work for each thread alike.
  const int pairs = (range.count + 1) / 2;
  in_parts(o.threads, pairs, [&](int pair, int end, int) {
    NumberLines lines(range.count, o.offsets);
    const auto make = [&](int row) {
      const KernelRow kernel = kernel_row(f, range, row, removed, nk);
      lines.begin(row);
      dense_product(even, kernel.even, lines.even());
      dense_product(odd, kernel.odd, lines.odd());
      take(lines);
    };
    for (; pair < end; ++pair) {
      make(pair);
      if (const int opposite = range.count - 1 - pair; opposite != pair)
        make(opposite);
    }
  });
}

/// How many elements of the table make one that is asked for: whole multiples alone are served.
int checked_parts(const InfluenceFunction& f, const ExpandOptions& o, const Scaling& scaling) {
  if (o.structural != StructuralCompliance::included)
    throw InputError("The structural compliance of '" + f.body + "' cannot be removed",
                     "its file is a table of influence numbers and knows no remote section",
                     "Use structural compliance 'included'.");
  const double parts = scaling.dx / f.table_dx;
  if (!(parts >= 1 - whole_ratio_slack) || std::abs(parts - std::round(parts)) > whole_ratio_slack * parts)
    throw InputError(
        fmt::format("The influence numbers of '{}' do not serve dx = {:.9g} mm", f.body, o.dx),
        fmt::format("they are a table of elements {:.9g} mm long at this radius", f.table_dx * scaling.load),
        "Use that length or a whole multiple of it, or compute them with another solid.dx.");
  if (o.offsets * parts > static_cast<double>(f.table_offsets()) + 0.5)
    throw InputError("The patch is longer than the table of influence numbers of '" + f.body + "'",
                     fmt::format("{} elements of {:g} mm, the table has {} of {:g} mm", o.offsets, o.dx,
                                 f.table_offsets(), f.table_dx * scaling.load),
                     "Use a shorter patch, or compute it with more solid.offsets.");
  return static_cast<int>(std::lround(parts));
}

/// An element of q table elements under a load on q of them: A(M) = 1/q sum_c (q - |c|) A_table(M q + c).
/// Sums of a table's numbers. Throws InputError where the table does not serve the options.
InfluenceNumbers expand_table(const InfluenceFunction& f, const ExpandOptions& o, StationRange range,
                              const Scaling& scaling) {
  const int q = checked_parts(f, o, scaling);
  const auto size = static_cast<std::size_t>(3 * range.count),
             from = static_cast<std::size_t>(3 * range.first), all = 3 * f.station_count();
  InfluenceNumbers result{o.offsets, static_cast<int>(range.count), o.dx, f.station_width, {}};
  result.values.assign(static_cast<std::size_t>(o.offsets) * size * size, 0.0);
  for (int m = 0; m < o.offsets; ++m)
    for (int c = 1 - q; c < q; ++c) {
      const int offset = m * q + c;
      const double weight = scaling.load * (q - std::abs(c)) / q;
      const double* a = f.table.data() + static_cast<std::size_t>(std::abs(offset)) * all * all;
      double* to = result.values.data() + static_cast<std::size_t>(m) * size * size;
      for (std::size_t row = 0; row < size; ++row)
        for (std::size_t column = 0; column < size; ++column) {
          const int sign = offset < 0 ? parity(static_cast<int>(row % 3), static_cast<int>(column % 3)) : 1;
          to[row * size + column] += weight * sign * a[(from + row) * all + from + column];
        }
    }
  return result;
}

StationRange checked_range(const InfluenceFunction& f, const ExpandOptions& o) {
  const auto total = static_cast<int>(f.station_count());
  const int count = o.stations < 0 ? total - o.first_station : o.stations;
  if (o.first_station < 0 || count < 1 || o.first_station > total - count)
    throw InputError("Stations were asked for that the influence functions of '" + f.body + "' do not have",
                     fmt::format("{} from number {} on, of {}", count, o.first_station, total),
                     "Ask for stations on the strip.");
  return {o.first_station, count};
}

Scaling checked_scaling(const InfluenceFunction& f, const ExpandOptions& o) {
  if (!(std::isfinite(o.dx) && o.dx >= 0) || o.offsets < 1)
    throw InputError("Influence numbers cannot be expanded",
                     fmt::format("dx = {} mm, {} offsets", o.dx, o.offsets),
                     "Give dx >= 0 and at least one offset.");
  if (!(std::isfinite(o.contact_radius) && o.contact_radius >= 0))
    throw InputError("Influence numbers cannot be expanded",
                     fmt::format("contact radius {} mm", o.contact_radius), "Give a radius above 0.");
  Scaling scaling{o.dx, 1};
  if (f.invariance == Invariance::revolution && o.contact_radius > 0) {
    scaling.load = o.contact_radius / std::abs(f.reference_radius);
    scaling.dx = o.dx / scaling.load;
  }
  if (f.is_table())
    return scaling;
  if (o.dx == 0) {
    if (o.offsets != 1)
      throw InputError("Plane strain has no offsets along x", fmt::format("{} were asked for", o.offsets),
                       "Ask for one offset, or give dx.");
    return scaling;
  }
  const double largest = f.wavenumber.back();
  if (f.wavenumber_count() < 3 || largest * scaling.dx / 2 < least_half_element_phase * (1 - phase_slack))
    throw InputError(fmt::format("The influence functions of '{}' are too coarse along x for dx = {:.9g} mm",
                                 f.body, o.dx),
                     largest > 0 ? fmt::format("they serve dx >= {:.9g} mm", shortest_dx(f) * scaling.load)
                                 : "they hold plane strain only",
                     "Use longer elements, or compute them with a smaller harmonic.shortest_dx.");
  if (o.offsets * scaling.dx > f.half_period)
    throw InputError(
        "The patch is longer than the half period of the influence functions of '" + f.body + "'",
        fmt::format("{} elements of {:g} mm, half period {:g} mm", o.offsets, o.dx, f.half_period),
        "Use a shorter patch, or compute them with a larger harmonic.half_period.");
  return scaling;
}

} // namespace

void expand_lines(const InfluenceFunction& f, const ExpandOptions& o, const TakeLines& take) {
  const StationRange range = checked_range(f, o);
  const Scaling scaling = checked_scaling(f, o);
  if (!f.is_table())
    return expand_kernel(f, o, range, scaling, take);
  const InfluenceNumbers numbers = expand_table(f, o, range, scaling);
  NumberLines lines(numbers.rows, numbers.offsets);
  for (int row = 0; row < numbers.rows; ++row) {
    lines.begin(row);
    lines.read_from(numbers);
    take(lines);
  }
}

InfluenceNumbers expand(const InfluenceFunction& f, const ExpandOptions& o) {
  const StationRange range = checked_range(f, o);
  const Scaling scaling = checked_scaling(f, o);
  if (f.is_table())
    return expand_table(f, o, range, scaling);
  InfluenceNumbers result{o.offsets, static_cast<int>(range.count), o.dx, f.station_width, {}};
  result.values.resize(result.expected_values());
  expand_kernel(f, o, range, scaling, [&](NumberLines& lines) { lines.write_to(result); });
  return result;
}

} // namespace bem_contact
