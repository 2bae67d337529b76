#include "bem_contact/contact/check/regions.hpp"

#include "bem_contact/contact/dissipation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace bem_contact::contact {
namespace {

/// Looks up fields by column and row; zero pressure and exterior beyond the grid.
struct Field {
  const ContactProblem& problem;
  const ContactResult& result;

  bool inside(int ix, int is) const {
    return ix >= 0 && ix < problem.grid.mx && is >= 0 && is < problem.grid.ms;
  }
  double pressure(int ix, int is) const {
    return inside(ix, is) ? std::max(0.0, result.pn[is * problem.grid.mx + ix]) : 0.0;
  }
  ElementState state(int ix, int is) const {
    return inside(ix, is) ? result.state[is * problem.grid.mx + ix] : ElementState::exterior;
  }
  bool beside(int ix, int is, ElementState wanted) const {
    const bool along_x = state(ix - 1, is) == wanted || state(ix + 1, is) == wanted;
    const bool along_s = state(ix, is - 1) == wanted || state(ix, is + 1) == wanted;
    return (problem.grid.mx > 1 && along_x) || (problem.grid.ms > 1 && along_s);
  }
  double curvature(int ix, int is) const {
    const double p = pressure(ix, is);
    const double x = 2 * p - pressure(ix - 1, is) - pressure(ix + 1, is);
    const double s = 2 * p - pressure(ix, is - 1) - pressure(ix, is + 1);
    return (problem.grid.mx > 1 ? std::abs(x) : 0.0) + (problem.grid.ms > 1 ? std::abs(s) : 0.0);
  }
};

/// of(row) of each row.
template <class Of> std::vector<double> of_rows(const ContactProblem& problem, const Of& of) {
  std::vector<double> values;
  values.reserve(problem.rows.size());
  for (int row = 0; row < problem.grid.ms; ++row)
    values.push_back(of(row));
  return values;
}

/// Shear forces of a patch's elements, N.
struct ShearParts {
  std::span<const Part> x, s;
};

/// The moment about the patch's centre, and what friction does. `out`: with its centre.
void add_moment_and_work(const ContactProblem& problem, const ContactResult& result,
                         std::span<const int> elements, const ShearParts& shear, Region& out) {
  const double dS = problem.element_area();
  const std::vector<double> rate = friction_work_density(result), slipping = dissipated_in_slip(result);
  const std::vector<double> share = of_rows(problem, [&](int row) { return problem.lateral_share(row); });
  std::vector<Part> moment, driving;
  moment.reserve(elements.size());
  driving.reserve(elements.size());
  const bool steady = problem.motion == MotionKind::steady;
  for (std::size_t k = 0; k < elements.size(); ++k) {
    const int i = elements[k];
    const double lever_x = problem.grid.x(i % problem.grid.mx) - out.x;
    const double lever_s = problem.rows[i / problem.grid.mx].s - out.s;
    moment.push_back(
        {lever_x * shear.s[k].value - lever_s * shear.x[k].value, shear.x[k].fn, shear.x[k].adheres});
    if (!problem.has_friction())
      continue;
    out.T_gamma += rate[i] * dS;
    out.T_gamma_in_slip += slipping[i] * dS;
    const double sheared = steady ? shear_drive(problem, result, i, share[i / problem.grid.mx]) : rate[i];
    driving.push_back({sheared * dS, shear.x[k].fn, shear.x[k].adheres});
  }
  out.driving_power = sum_of(driving);
  if (steady && problem.has_friction()) // of large parts, which cancel: none of them counts for its error
    out.driving_power.total += pressure_drive(problem, result, elements) * dS;
  out.moment = sum_of(moment);
}

Region region_of(const ContactProblem& problem, const ContactResult& result, std::span<const int> elements) {
  const Field field{problem, result};
  const double dS = problem.element_area();
  Region out;
  out.line = problem.grid.is_line();
  std::vector<Part> fx, fs;
  fx.reserve(elements.size());
  fs.reserve(elements.size());
  std::vector<int> in_row(problem.grid.ms, 0);
  const std::vector<double> approach =
      of_rows(problem, [&](int row) { return result.totals.approach * std::cos(problem.rows[row].delta); });
  for (const int i : elements) {
    const int ix = i % problem.grid.mx, is = i / problem.grid.mx;
    const double fn = result.pn[i] * dS;
    const bool adheres = result.state[i] == ElementState::adhesion;
    ++out.contact;
    out.rows += in_row[is] == 0;
    out.longest = std::max(out.longest, ++in_row[is]);
    out.border += field.beside(ix, is, ElementState::exterior);
    out.adhesion += adheres;
    out.adhesion_border += adheres && field.beside(ix, is, ElementState::slip);
    out.fn += fn;
    fx.push_back({result.px[i] * dS, fn, adheres});
    fs.push_back({result.ps[i] * dS, fn, adheres});
    out.x += fn * problem.grid.x(ix);
    out.s += fn * problem.rows[is].s;
    out.overlap = std::max(out.overlap, approach[is] - problem.gap[i]);
    if (result.pn[i] > out.pmax) {
      out.pmax = result.pn[i];
      out.at_limit = problem.limit_pressure && out.pmax >= *problem.limit_pressure;
      out.curvature = out.at_limit ? 0 : field.curvature(ix, is); // beside the limit it falls in any grid
    }
  }
  out.fx = sum_of(fx);
  out.fs = sum_of(fs);
  out.area = out.contact * dS;
  out.x /= out.fn;
  out.s /= out.fn;
  add_moment_and_work(problem, result, elements, {fx, fs}, out);
  return out;
}

} // namespace

UncertainSum sum_of(std::span<const Part> parts) {
  UncertainSum out;
  double fn = 0, adhering = 0;
  int adhesion = 0;
  for (const Part& part : parts) {
    fn += part.fn;
    out.total += part.value;
    out.size += std::abs(part.value);
    if (!part.adheres)
      continue;
    ++adhesion;
    adhering += part.value;
    out.adhering += part.value * part.value;
  }
  if (adhesion > 0)
    out.adhering_alike = std::abs(adhering) / std::sqrt(adhesion);
  for (const Part& part : parts)
    out.deviation += std::abs(part.value - out.total * part.fn / fn);
  return out;
}

std::vector<Region> patches_of(const ContactProblem& problem, const ContactResult& result) {
  std::vector<Region> out;
  for (const std::vector<int>& elements : patch_elements(problem, result))
    out.push_back(region_of(problem, result, elements));
  return out;
}

Region contact_of(const ContactProblem& problem, const ContactResult& result,
                  const std::vector<Region>& patches) {
  if (patches.size() == 1)
    return patches.front();
  std::vector<int> all;
  for (int i = 0; i < problem.grid.size(); ++i)
    if (result.state[i] != ElementState::exterior)
      all.push_back(i);
  return region_of(problem, result, all);
}

std::vector<Region> matched(const std::vector<Region>& fine, std::vector<Region> coarse) {
  std::vector<Region> out;
  if (fine.size() != coarse.size())
    return out;
  for (const Region& patch : fine) {
    const auto distance = [&](const Region& r) { return std::hypot(r.x - patch.x, r.s - patch.s); };
    const auto nearest = std::ranges::min_element(coarse, {}, distance);
    out.push_back(*nearest);
    coarse.erase(nearest);
  }
  return out;
}

ShearEffects effects_of_shear(const ContactProblem& problem, const ContactResult& result) {
  const int mx = problem.grid.mx;
  const double dS = problem.element_area();
  double across = 0, down = 0; // of the pressure, N
  for (int is = 0; is < problem.grid.ms; ++is) {
    const double* pn = &result.pn[is * mx];
    const double pressed = std::accumulate(pn, pn + mx, 0.0) * dS, delta = problem.rows[is].delta;
    across += pressed * std::sin(delta);
    down += pressed * std::cos(delta);
  }
  ShearEffects out;
  const bool made_up = problem.load == LoadKind::force && down > 0;
  const double mean = std::atan2(across, down);
  if (made_up)
    out.slope = across / down;
  std::vector<Part> fy, fz, fn;
  for (int is = 0; is < problem.grid.ms; ++is) {
    const double delta = problem.rows[is].delta, sine = std::abs(std::sin(delta)),
                 aside = std::sin(delta - mean), bent = 1 - std::cos(delta - mean);
    const double across_share = std::cos(delta) + std::abs(out.slope) * sine,
                 turned = std::abs(aside) / std::cos(mean);
    for (int i = is * mx; i < (is + 1) * mx; ++i) {
      if (result.state[i] == ElementState::exterior)
        continue;
      const double fs = result.ps[i] * dS, pressed = result.pn[i] * dS;
      const auto part = [&](double value) {
        return Part{value, pressed, result.state[i] == ElementState::adhesion};
      };
      fy.push_back(part(fs * across_share));
      fz.push_back(part(made_up ? 0.0 : fs * sine));
      fn.push_back(part(made_up ? fs * aside : 0.0));
      out.turned += pressed * turned;
      out.bent += pressed * bent;
    }
  }
  out.fy = sum_of(fy);
  out.fz = sum_of(fz);
  out.fn = sum_of(fn);
  return out;
}

} // namespace bem_contact::contact
