#include "bem_contact/wheelset/scene_aids.hpp"

#include <algorithm>
#include <cmath>

namespace bem_contact {

StartingPoint start_from(const FormerTractions& former, const ContactProblem& problem, double reference_s,
                         double force) {
  const ContactGrid &to = problem.grid, &from = former.grid;
  const double scale = force > 0 && former.force > 0 ? std::cbrt(force / former.force) : 1.0;
  StartingPoint start;
  start.approach = former.approach * scale * scale;
  start.px.assign(to.size(), 0.0);
  start.ps = start.pn = start.px;
  for (int is = 0; is < to.ms; ++is) {
    const double s = former.reference_s + (problem.rows[is].s - reference_s) / scale;
    const double row = (s - former.first_s) / from.ds;
    if (row <= 0 || row >= from.ms - 1)
      continue;
    for (int ix = 0; ix < to.mx; ++ix) {
      const double column = (to.x(ix) / scale - from.x0) / from.dx;
      if (column <= 0 || column >= from.mx - 1)
        continue;
      const int i = static_cast<int>(row), k = static_cast<int>(column);
      const double t = row - i, u = column - k;
      const auto value = [&](const std::vector<double>& f) {
        const double* at = &f[static_cast<std::size_t>(i) * from.mx + k];
        return scale *
               ((1 - t) * ((1 - u) * at[0] + u * at[1]) + t * ((1 - u) * at[from.mx] + u * at[from.mx + 1]));
      };
      const int here = is * to.mx + ix;
      start.px[here] = value(former.px);
      start.ps[here] = value(former.ps);
      start.pn[here] = value(former.pn);
    }
  }
  return start;
}

} // namespace bem_contact
