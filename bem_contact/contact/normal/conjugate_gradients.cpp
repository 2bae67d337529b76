#include "bem_contact/contact/normal/conjugate_gradients.hpp"

#include "bem_contact/contact/normal/settings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace bem_contact::contact {
namespace {

using Eigen::VectorXd;

/// Runs in single precision. Chosen: each gains up to four digits, so that a few reach double precision.
constexpr int most_cg_runs = 12;
/// 1. A run has to reduce the residual at least to this share. Chosen.
constexpr double cg_least_reduction = 0.5;
/// Products that a run may take beyond the number of elements, after which exact arithmetic would be done.
constexpr int extra_cg_products = 50;
/// Units of work of the preconditioner, an element (measured).
constexpr double cg_preconditioner_work = 0.3;

double largest_residual(const NormalBoxVectors& v) {
  double worst = 0;
  for (const int l : v.local)
    worst = std::max(worst, std::abs(static_cast<double>(v.r[l])));
  return worst;
}

/// d = z + beta d with z = r preconditioned, on the active elements. Polak and Ribiere's beta forgives the
/// rounding of the FFT. Returns r'z, which is not positive where the inverse is not.
double next_direction(const NormalBox& box, bool first, double rho, NormalBoxVectors& v) {
  box.invert(v.r, v.q);
  double next = 0, overlap = 0;
  for (const int l : v.local) {
    next += static_cast<double>(v.r[l]) * v.q[l];
    overlap += static_cast<double>(v.r[l]) * v.z[l];
    v.z[l] = v.q[l];
  }
  const auto beta = static_cast<float>(first ? 0 : std::max(0.0, (next - overlap) / rho));
  if (next > 0)
    for (const int l : v.local)
      v.d[l] = v.z[l] + beta * v.d[l];
  return next;
}

/// One run of preconditioned conjugate gradients for A_CC x = r from x = 0, in single precision. v.u becomes
/// A (p + scale x) on the whole boxes. Ends when the residual is at most `target` everywhere, or after `most`
/// products. Returns the residual reached, or nothing where A or its inverse is not positive.
std::optional<double> correct(const NormalBox& box, double scale, double target, int most,
                              NormalBoxVectors& v, int& products) {
  double rho = 0, worst = largest_residual(v);
  for (int k = 0; k < most && worst > target; ++k) {
    rho = next_direction(box, k == 0, rho, v);
    if (!(rho > 0))
      return std::nullopt;
    box.fast.apply(v.d, v.q);
    ++products;
    double curvature = 0;
    for (const int l : v.local)
      curvature += static_cast<double>(v.d[l]) * v.q[l];
    if (!(curvature > 0))
      return std::nullopt;
    const double alpha = rho / curvature;
    const auto step = static_cast<float>(alpha);
    for (std::size_t l = 0; l < v.u.size(); ++l)
      v.u[l] += scale * alpha * v.q[l];
    float largest = 0;
    for (const int l : v.local) {
      v.x[l] += step * v.d[l];
      v.r[l] -= step * v.q[l];
      largest = std::max(largest, std::abs(v.r[l]));
    }
    worst = largest;
  }
  return worst;
}

void start(const NormalBox& box, const std::vector<int>& list, const VectorXd& p, int grid_mx,
           NormalBoxVectors& v) {
  v.local.resize(list.size());
  std::fill(v.p.begin(), v.p.end(), 0.0);
  for (std::size_t a = 0; a < list.size(); ++a) {
    v.local[a] = box.boxes.local(list[a], grid_mx);
    v.p[v.local[a]] = p[list[a]];
  }
}

/// u = A p in double precision; returns the largest residual.
double double_precision_residual(const NormalBox& box, const std::vector<int>& list, const VectorXd& rhs,
                                 NormalBoxVectors& v) {
  box.nn.apply(v.p, v.u);
  double worst = 0;
  for (std::size_t a = 0; a < list.size(); ++a)
    worst = std::max(worst, std::abs(rhs[list[a]] - v.u[v.local[a]]));
  return worst;
}

} // namespace

bool conjugate_gradients(const NormalSystem& system, const std::vector<int>& list, const VectorXd& rhs,
                         double target, WorkBudget& work, Response& response) {
  const NormalBox& box = system.box_around(list, work);
  NormalBoxVectors& v = system.vectors();
  start(box, list, response.p, system.grid.mx, v);
  bool done = false;
  double former = std::numeric_limits<double>::infinity();
  for (int run = 0; run < most_cg_runs && !done; ++run) {
    const double worst = double_precision_residual(box, list, rhs, v);
    if (worst <= target || !(worst < former)) {
      done = worst <= target;
      break;
    }
    former = cg_least_reduction * worst;
    for (auto* w : {&v.x, &v.r, &v.z, &v.d})
      std::fill(w->begin(), w->end(), 0.0f);
    for (std::size_t a = 0; a < list.size(); ++a) // of order one, so that squares are in range
      v.r[v.local[a]] = static_cast<float>((rhs[list[a]] - v.u[v.local[a]]) / worst);
    const double wanted = target / worst;
    const int before = response.products;
    const auto reached = correct(box, worst, std::max(wanted, cg_single_run),
                                 extra_cg_products + static_cast<int>(list.size()), v, response.products);
    // one component: a quarter of a product; and the preconditioner
    const double product = product_work(system.numbers->translational, box.boxes.rows());
    work.spend((0.25 * product + cg_preconditioner_work) * (response.products - before) * box.boxes.size());
    if (!reached)
      return false;
    for (const int l : v.local)
      v.p[l] += worst * v.x[l];
    done = *reached <= wanted;
  }
  response.p.setZero();
  for (std::size_t a = 0; a < list.size(); ++a)
    response.p[list[a]] = v.p[v.local[a]];
  box.copy_to_grid(v.u, system.grid.mx, response.u);
  if (done)
    response.known = box.boxes;
  return done;
}

} // namespace bem_contact::contact
