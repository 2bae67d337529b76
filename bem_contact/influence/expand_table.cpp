#include "bem_contact/influence/expand_table.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/influence/settings.hpp"

#include <cmath>
#include <string>

namespace bem_contact {
namespace {

/// How many elements of the table make one that is asked for: whole multiples alone are served.
int checked_parts(const InfluenceFunction& f, const ExpandOptions& o, const Scaling& scaling) {
  if (o.structural != StructuralCompliance::included)
    throw InputError("the structural compliance of '" + f.body + "' cannot be removed",
                     "its file is a table of influence numbers and knows no remote section",
                     "Use structural compliance 'included'.");
  const double parts = scaling.dx / f.table_dx;
  if (!(parts >= 1 - whole_ratio_slack) || std::abs(parts - std::round(parts)) > whole_ratio_slack * parts)
    throw InputError("the influence numbers of '" + f.body + "' do not serve dx = " + std::to_string(o.dx) +
                         " mm",
                     "they are a table of elements " + std::to_string(f.table_dx * scaling.load) +
                         " mm long at this radius",
                     "Use that length or a whole multiple of it, or compute them with another solid.dx.");
  if (o.offsets * parts > static_cast<double>(f.table_offsets()) + 0.5)
    throw InputError("the patch is longer than the table of influence numbers of '" + f.body + "'",
                     std::to_string(o.offsets) + " elements of " + std::to_string(o.dx) +
                         " mm, the table has " + std::to_string(f.table_offsets()) + " of " +
                         std::to_string(f.table_dx * scaling.load) + " mm",
                     "Use a shorter patch, or compute it with more solid.offsets.");
  return static_cast<int>(std::lround(parts));
}

} // namespace

/// An element of q table elements under a load on q of them: A(M) = 1/q sum_c (q - |c|) A_table(M q + c).
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

} // namespace bem_contact
