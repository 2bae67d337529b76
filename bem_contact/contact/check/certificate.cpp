#include "bem_contact/contact/check/certificate.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/contact/check/direct_sums.hpp"
#include "bem_contact/contact/check/imbalance.hpp"
#include "bem_contact/contact/check/warm_friction.hpp"
#include "bem_contact/contact/friction_memory.hpp"
#include "bem_contact/contact/plastic_slip.hpp"
#include "bem_contact/contact/slip_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace bem_contact {
namespace {

using Fields = contact::ComponentFields;

/// 1. The certificate's slip scale is at least this times pmax times the largest self number: displacements
/// have rounding errors in proportion to that product. In steady rolling slip is the difference of
/// displacements one element apart, which has less of them; shift_slip_rounding is for all other motions.
constexpr double steady_slip_rounding = 1e-12;
constexpr double shift_slip_rounding = 1e-9;
/// 1. The slip scale is also at least this times the creepage found: where that cancels the prescribed rigid
/// slip, the sum of both is only rounding.
constexpr double creepage_rounding = 1e-9;

double relative(double value, double to) {
  return value > 0 ? value / to : 0.0;
}

/// Certificate::rounding of sums of terms as large as `term`, which are judged by `scale`.
double rounding(double term, double scale, double elements) {
  return elements *
         (std::numeric_limits<double>::epsilon() * term + std::numeric_limits<double>::denorm_min()) / scale;
}

double approach_of(const ContactProblem& problem, const ContactResult& result) {
  return problem.load == LoadKind::approach ? problem.approach : result.totals.approach;
}

/// Elements in contact, which may slip; none without friction.
std::vector<int> elements_of_slip(const ContactProblem& problem, const ContactResult& result) {
  std::vector<int> out;
  for (int i = 0; i < problem.grid.size() && problem.has_friction(); ++i)
    if (result.pn[i] > 0)
      out.push_back(i);
  return out;
}

/// Places in the sums that lie `first` to `last` columns ahead of these elements.
std::vector<int> places_ahead(const ContactProblem& problem, const std::vector<int>& elements, int first,
                              int last) {
  const int mx = problem.grid.mx, columns = contact::summed_columns(problem);
  std::vector<int> out;
  for (const int i : elements)
    for (int ahead = first; ahead <= last; ++ahead)
      out.push_back(i / mx * columns + i % mx + ahead);
  return out;
}

/// Columns ahead of an element that its slip takes displacements of now from.
int columns_ahead(const SlipStep& step) {
  int last = 0;
  for (int k = 0; k <= rolling_columns; ++k)
    if (step.present[k] != 0)
      last = k;
  return last;
}

/// Elements at which pressure has something to say: those that it acts on or that the approach alone lets
/// overlap. All others are apart, and pressure moves them further apart.
std::vector<int> loaded_or_overlapping(const ContactProblem& problem, const ContactResult& result) {
  const double q = approach_of(problem, result);
  const int mx = problem.grid.mx;
  std::vector<int> out;
  for (int is = 0; is < problem.grid.ms; ++is) {
    const double approach = q * std::cos(problem.rows[is].delta);
    for (int i = is * mx; i < (is + 1) * mx; ++i)
      if (result.pn[i] != 0 || result.px[i] != 0 || result.ps[i] != 0 || !(problem.gap[i] >= approach))
        out.push_back(i);
  }
  return out;
}

/// Tangential displacements at some elements, taken so many columns ahead.
Fields tangential_displacements(const ContactProblem& problem, const std::vector<int>& elements, int ahead,
                                const contact::ComponentSpans& p) {
  return contact::direct_displacements(
      problem, {places_ahead(problem, elements, ahead, ahead), std::vector<int>{}}, p);
}

/// sum_k former[k] (A p_k)(x + k columns dx) over the tractions of former steps, at some elements; nothing
/// where there are none.
std::optional<Fields> former_displacements(const ContactProblem& problem, const SlipStep& step,
                                           const std::vector<int>& elements) {
  if (problem.previous.empty())
    return std::nullopt;
  const int mx = problem.grid.mx, columns = contact::summed_columns(problem);
  Fields sum;
  sum.fill(std::vector<double>(static_cast<std::size_t>(columns) * problem.grid.ms, 0.0));
  for (std::size_t k = 1; k <= std::min<std::size_t>(problem.previous.size(), 2); ++k) {
    const Tractions& former = problem.previous[k - 1];
    const int ahead = static_cast<int>(k) * step.columns;
    const Fields u = tangential_displacements(problem, elements, ahead, {former.px, former.ps, former.pn});
    for (const int c : {component_x, component_s})
      for (const int i : elements) {
        const int at = i / mx * columns + i % mx;
        sum[c][at] += step.former[k] * u[c][at + ahead];
      }
  }
  return sum;
}

void require_fields(const ContactProblem& problem, const ContactResult& result) {
  const std::size_t n = problem.grid.size();
  if (result.px.size() != n || result.ps.size() != n || result.pn.size() != n)
    throw InputError("The result does not belong to the problem",
                     "its fields have another size than the grid",
                     "Certify a result with the problem that it solves.");
}

/// u = -A p without the columns ahead of the grid.
std::vector<double> on_the_grid(const ContactProblem& problem, const std::vector<double>& sums) {
  const auto& [mx, ms, dx, ds, x0] = problem.grid;
  std::vector<double> out;
  for (int is = 0; is < ms; ++is)
    for (int ix = 0; ix < mx; ++ix)
      out.push_back(-sums[sums.size() / ms * is + ix]);
  return out;
}

/// 1. A pressure this close to its limit is at the limit: as much as the certificate may leave.
constexpr double at_limit = 1e-6;

void check_normal(const ContactProblem& problem, const ContactResult& result, const std::vector<double>& u_n,
                  int columns, Certificate& certificate) {
  const auto& [mx, ms, dx, ds, x0] = problem.grid;
  const double q = approach_of(problem, result);
  const double limit = problem.limit_pressure.value_or(std::numeric_limits<double>::infinity());
  double pmax = 0, scale = 0, remote_scale = std::abs(q), lowest_p = 0, lowest_e = 0, product = 0;
  double term = 0; // of those that cancel
  int in_contact = 0;
  for (int is = 0; is < ms; ++is) {
    const double approach = q * std::cos(problem.rows[is].delta);
    for (int ix = 0; ix < mx; ++ix) {
      const int i = is * mx + ix;
      const double p = result.pn[i], u = u_n[static_cast<std::size_t>(is) * columns + ix];
      const double e = problem.gap[i] - approach + u;
      pmax = std::max(pmax, p);
      remote_scale = std::max(remote_scale, std::abs(problem.gap[i]));
      if (p > 0) {
        scale = std::max(scale, std::abs(u));
        term = std::max({term, std::abs(problem.gap[i]), std::abs(approach), std::abs(u)});
        ++in_contact;
      }
      lowest_p = std::max({lowest_p, -p, p - limit});
      if (!std::isfinite(p) || !std::isfinite(e))
        lowest_p = std::numeric_limits<double>::infinity();
      if (p > (1 - at_limit) * limit && e < 0) // the bodies are indented
        continue;
      lowest_e = std::max(lowest_e, -e);
      product = std::max(product, std::abs(p * e));
    }
  }
  if (scale == 0)
    scale = remote_scale;
  certificate.pressure = relative(lowest_p, pmax);
  certificate.penetration = relative(lowest_e, scale);
  certificate.complementarity = relative(product, pmax * scale);
  certificate.rounding = rounding(term, scale, in_contact);
}

/// The largest violation of the cone |p_t| <= bound, MPa.
double cone_violation(const ContactResult& result, const std::vector<double>& bound) {
  double cone = 0;
  for (std::size_t i = 0; i < bound.size(); ++i) {
    const double shear = std::hypot(result.px[i], result.ps[i]);
    cone = std::max(cone, shear - bound[i]);
    if (!std::isfinite(shear))
      cone = std::numeric_limits<double>::infinity();
  }
  return cone;
}

/// Slip of the elements in contact, mm, from the tractions alone.
struct Slips {
  struct Slip {
    double x, s, bound; ///< bound: mu p_n of this slip, MPa
    int element;
  };
  std::vector<Slip> slips;
  double scale;    ///< mm
  double term = 0; ///< the largest of those that cancel in a slip, mm
};

Slips slips_of(const ContactProblem& problem, const ContactResult& result, const Fields& u,
               const std::vector<int>& elements) {
  const int mx = problem.grid.mx, columns = contact::summed_columns(problem);
  const bool steady = problem.motion == MotionKind::steady;
  const SlipStep step = slip_step(problem);
  const int ahead = columns_ahead(step);
  const auto before = former_displacements(problem, step, elements);
  std::optional<Fields> from_normal;
  if (!steady) {
    const std::vector<double> none(result.pn.size(), 0.0);
    from_normal = tangential_displacements(problem, elements, 0, {none, none, result.pn});
  }
  double self = 0;
  for (int row = 0; row < problem.grid.ms; ++row)
    self = std::max(self, problem.numbers.at(0, row, component_n, row, component_n));
  const double pmax = *std::max_element(result.pn.begin(), result.pn.end());
  Slips out{{},
            std::max((steady ? steady_slip_rounding : shift_slip_rounding) * pmax * self,
                     creepage_rounding * std::hypot(result.totals.creepage_x, result.totals.creepage_s) *
                         step.length),
            std::hypot(result.totals.creepage_x, result.totals.creepage_s) * step.length};
  for (const int i : elements) {
    const int is = i / mx;
    const std::size_t at = static_cast<std::size_t>(is) * columns + i % mx;
    const double rigid_x = (problem.slip_x[i] + result.totals.creepage_x) * step.length;
    const double rigid_s =
        (problem.slip_s[i] + result.totals.creepage_s * problem.lateral_share(is)) * step.length;
    const double before_x = before ? (*before)[component_x][at] : 0.0;
    const double before_s = before ? (*before)[component_s][at] : 0.0;
    out.term = std::max({out.term, std::hypot(rigid_x, rigid_s), std::hypot(before_x, before_s)});
    double elastic_x = -before_x, elastic_s = -before_s; // u = -A p
    for (int k = 0; k <= ahead; ++k) {
      const double now_x = step.present[k] * u[component_x][at + k],
                   now_s = step.present[k] * u[component_s][at + k];
      out.term = std::max(out.term, std::hypot(now_x, now_s));
      elastic_x -= now_x;
      elastic_s -= now_s;
    }
    const double slip_x = rigid_x + elastic_x, slip_s = rigid_s + elastic_s;
    const double falling =
        problem.falling.empty()
            ? 1.0
            : problem.falling_factor(is, std::hypot(slip_x, slip_s) / step.length * problem.speed);
    out.slips.push_back(
        {slip_x, slip_s, problem.kinetic * problem.friction_of(is) * falling * result.pn[i], i});
    out.scale = std::max({out.scale, std::hypot(rigid_x, rigid_s), std::hypot(elastic_x, elastic_s)});
    if (from_normal) // if everything sticks without rigid slip: the slip that the shear tractions prevent
      out.scale = std::max(
          out.scale, std::hypot(rigid_x - before_x - step.present[0] * (*from_normal)[component_x][at],
                                rigid_s - before_s - step.present[0] * (*from_normal)[component_s][at]));
  }
  return out;
}

/// The bounds of a layer that yields. `bound`: of friction at rest, MPa; `limits`: tau_0; fields. Where
/// friction falls, what slides may have less friction than the layer bears, though at rest it has more: then
/// the state that is nearer counts.
void take_bounds_of_layer(const ContactProblem& problem, const ContactResult& result,
                          const std::vector<double>& limits, Slips& slips, std::vector<double>& bound) {
  if (!problem.hardens()) {
    for (Slips::Slip& slip : slips.slips) {
      const double shear = limits[slip.element];
      const double size = std::hypot(result.px[slip.element], result.ps[slip.element]);
      const bool yields = bound[slip.element] > shear &&
                          std::abs(size - shear) <= std::abs(size - std::min(slip.bound, shear));
      slip.bound = yields ? shear : std::min(slip.bound, shear);
    }
    for (std::size_t i = 0; i < bound.size(); ++i)
      bound[i] = std::min(bound[i], limits[i]);
    return;
  }
  std::vector<double> slip_x(bound.size(), 0.0), slip_s(bound.size(), 0.0);
  for (const Slips::Slip& slip : slips.slips) {
    slip_x[slip.element] = slip.x;
    slip_s[slip.element] = slip.s;
  }
  const std::vector<LayerAnswer> answers = contact::PlasticSlip(problem).answers({.px = result.px,
                                                                                  .ps = result.ps,
                                                                                  .slip_x = slip_x,
                                                                                  .slip_s = slip_s,
                                                                                  .friction = bound,
                                                                                  .limits = limits});
  for (std::size_t i = 0; i < bound.size(); ++i)
    bound[i] = answers[i].bound;
  for (Slips::Slip& slip : slips.slips)
    slip.bound = bound[slip.element];
}

/// The bounds of friction that remembers, in slip and at rest, MPa; `bound`: without slip, field.
void take_remembered_bounds(const ContactProblem& problem, Slips& slips, std::vector<double>& bound) {
  std::vector<double> velocity(bound.size(), 0.0);
  std::vector<char> in_contact(bound.size(), 0);
  for (const Slips::Slip& slip : slips.slips) {
    velocity[slip.element] = std::hypot(slip.x, slip.s) / slip_step(problem).length * problem.speed;
    in_contact[slip.element] = 1;
  }
  const std::vector<double> factors = contact::remembered_factors(problem, velocity, in_contact);
  for (std::size_t i = 0; i < bound.size(); ++i)
    bound[i] *= factors[i];
  for (Slips::Slip& slip : slips.slips)
    slip.bound = bound[slip.element];
}

/// Of friction, by element, MPa mm/s; field.
std::vector<double> heat_of(const ContactProblem& problem, const ContactResult& result, const Slips& slips) {
  const double length = slip_step(problem).length;
  std::vector<double> heat(result.pn.size(), 0.0);
  for (const Slips::Slip& slip : slips.slips)
    heat[slip.element] =
        (result.px[slip.element] * slip.x + result.ps[slip.element] * slip.s) / length * problem.speed;
  return heat;
}

/// Coulomb's law leaves two states; each element counts for the one that it is nearer to.
void check_states(const ContactResult& result, const Slips& slips, double traction_scale,
                  Certificate& certificate) {
  for (const Slips::Slip& slip : slips.slips) {
    const double length = std::hypot(slip.x, slip.s);
    if (length == 0)
      continue;
    const double adhesion = length / slips.scale;
    const double direction = std::hypot(result.px[slip.element] - slip.bound * slip.x / length,
                                        result.ps[slip.element] - slip.bound * slip.s / length) /
                             traction_scale;
    double& quantity = adhesion <= direction ? certificate.adhesion : certificate.slip_direction;
    quantity = std::max(quantity, std::min(adhesion, direction));
  }
}

void check_friction(const ContactProblem& problem, const ContactResult& result, const Fields& u,
                    const std::vector<int>& elements, Certificate& certificate) {
  std::vector<double> bound(result.pn.size(), 0.0); // at rest
  if (!problem.has_friction()) {
    certificate.friction_cone = relative(cone_violation(result, bound), std::ranges::max(result.pn));
    return;
  }
  Slips slips = slips_of(problem, result, u, elements);
  for (int i = 0; i < problem.grid.size(); ++i)
    bound[i] = problem.friction_of(i / problem.grid.mx) * result.pn[i];
  double traction_scale = std::ranges::max(bound);
  if (problem.memory)
    take_remembered_bounds(problem, slips, bound);
  std::vector<double> temperatures;
  if (problem.heat_acts())
    temperatures = contact::warm_temperatures(problem, heat_of(problem, result, slips));
  if (problem.friction_falls_with_heat()) {
    const auto warm = [&](int i) { return problem.heating->friction->factor(temperatures[i]); };
    for (int i = 0; i < problem.grid.size(); ++i)
      bound[i] *= warm(i);
    for (Slips::Slip& slip : slips.slips)
      slip.bound *= warm(slip.element);
  }
  if (problem.yield) {
    std::vector<double> limits(bound.size(), problem.yield->shear);
    for (std::size_t i = 0; i < temperatures.size(); ++i)
      limits[i] = problem.yield->at(temperatures[i]);
    take_bounds_of_layer(problem, result, limits, slips, bound);
    traction_scale = contact::traction_scale(std::ranges::max(bound), traction_scale);
  }
  certificate.friction_cone = relative(cone_violation(result, bound), traction_scale);
  check_states(result, slips, traction_scale, certificate);
  if (!slips.slips.empty())
    certificate.rounding =
        std::max(certificate.rounding, rounding(slips.term, slips.scale, double(slips.slips.size())));
}

} // namespace

Certificate certify(const ContactProblem& problem, const ContactResult& result, Displacements* displacements,
                    int threads) {
  require_fields(problem, result);
  const std::vector<int> elements = elements_of_slip(problem, result);
  Certificate certificate = Certificate::without_violation();
  contact::WantedDisplacements wanted{std::nullopt, std::nullopt};
  if (!displacements)
    wanted = {places_ahead(problem, elements, 0, columns_ahead(slip_step(problem))),
              places_ahead(problem, loaded_or_overlapping(problem, result), 0, 0)};
  const auto u = contact::direct_displacements(problem, wanted, {result.px, result.ps, result.pn}, threads);
  check_normal(problem, result, u[component_n], contact::summed_columns(problem), certificate);
  check_friction(problem, result, u, elements, certificate);
  certificate.force_balance = contact::force_imbalance(problem, result);
  if (displacements)
    *displacements = {on_the_grid(problem, u[component_x]), on_the_grid(problem, u[component_s]),
                      on_the_grid(problem, u[component_n])};
  return certificate;
}

} // namespace bem_contact
