#include "bem_contact/contact/normal/normal.hpp"

#include "bem_contact/contact/prepared.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bem_contact::contact {
namespace {

using Eigen::VectorXd;

/// One run of preconditioned conjugate gradients for A_CC x = r from x = 0, in single precision. at.u
/// follows: it becomes A (p + scale x) on the whole box. The residual falls to `target` everywhere; returns
/// where it got to, or nothing where A or its inverse is not positive.
std::optional<double> correct(NormalBox& at, double scale, double target, int most, int& products) {
  double rho = 0, worst = 0;
  for (const int l : at.local)
    worst = std::max(worst, std::abs(static_cast<double>(at.r[l])));
  for (int k = 0; k < most && worst > target; ++k) {
    // z = r preconditioned, on the active elements; Polak-Ribiere's beta forgives what the FFT rounds
    at.invert();
    double next = 0, overlap = 0;
    for (const int l : at.local) {
      next += static_cast<double>(at.r[l]) * at.q[l];
      overlap += static_cast<double>(at.r[l]) * at.z[l];
      at.z[l] = at.q[l];
    }
    if (!(next > 0))
      return std::nullopt;
    const auto beta = static_cast<float>(k == 0 ? 0 : std::max(0.0, (next - overlap) / rho));
    rho = next;
    for (const int l : at.local)
      at.d[l] = at.z[l] + beta * at.d[l];
    at.fast.apply(at.d, at.q);
    ++products;
    double curvature = 0;
    for (const int l : at.local)
      curvature += static_cast<double>(at.d[l]) * at.q[l];
    if (!(curvature > 0))
      return std::nullopt;
    const double alpha = rho / curvature;
    const auto step = static_cast<float>(alpha);
    for (std::size_t l = 0; l < at.u.size(); ++l)
      at.u[l] += scale * alpha * at.q[l];
    float largest = 0;
    for (const int l : at.local) {
      at.x[l] += step * at.d[l];
      at.r[l] -= step * at.q[l];
      largest = std::max(largest, std::abs(at.r[l]));
    }
    worst = largest;
  }
  return worst;
}

} // namespace

NormalBox::NormalBox(const InfluenceNumbers& numbers, const Parts& the_box, TransformPool* pool)
    : box(the_box), nn(numbers, box, {component_n}, {component_n}, pool), fast(nn, pool),
      inverse(numbers, box.mx(), box.ms(), {component_n}, {component_n},
              BasicPlaneOperator<float>::Form::periodic, box.boxes.front().first_s + box.ms() / 2, pool) {
  inverse.invert();
  for (auto* v : {&p, &u})
    v->assign(box.size(), 0.0);
  for (auto* v : {&x, &r, &z, &d, &q})
    v->assign(box.size(), 0.0f);
}

void NormalBox::invert() {
  const std::size_t n = box.boxes.front().size();
  for (int k = 0; k < box.count(); ++k)
    inverse.apply({&r[k * n], n}, {&q[k * n], n}, 0);
}

void NormalBox::copy_u(int grid_mx, VectorXd& field) const {
  const double* from = u.data();
  for (const Box& part : box.boxes)
    for (int is = 0; is < part.ms; ++is, from += part.mx)
      std::copy_n(from, part.mx,
                  &field[static_cast<Eigen::Index>(part.first_s + is) * grid_mx + part.first_x]);
}

void NormalSystem::spend(double elements) const {
  kept_->spend(elements);
}

NormalBox& NormalSystem::box_for(const std::vector<int>& elements) const {
  std::optional<NormalBox>& box = kept_->normal_box;
  const bool columns = !numbers->translational;
  if (!box || !serve(box->box, parts_around(elements, grid, 0, columns), elements, grid.mx)) {
    const Parts wider = parts_around(elements, grid, 1 + std::min(grid.mx, grid.ms) / 60, columns);
    spend(spectra_work(numbers->translational, 1, wider.rows(), wider.mx()));
    box.emplace(*numbers, wider, kept_->pool.get());
  }
  return *box;
}

const Parts* conjugate_gradients(const NormalSystem& system, const std::vector<int>& list,
                                 const VectorXd& rhs, double target, VectorXd& y, VectorXd& u,
                                 int& products) {
  /// As far as one run gets the residual down for certain.
  constexpr double single_run = 1e-4;
  constexpr int most_runs = 12;
  NormalBox& at = system.box_for(list);
  const int grid_mx = system.grid.mx;
  at.local.resize(list.size());
  std::fill(at.p.begin(), at.p.end(), 0.0);
  for (std::size_t a = 0; a < list.size(); ++a) {
    at.local[a] = at.box.local(list[a], grid_mx);
    at.p[at.local[a]] = y[list[a]];
  }
  bool done = false;
  double former = std::numeric_limits<double>::infinity();
  for (int run = 0; run < most_runs && !done; ++run) {
    at.nn.apply(at.p, at.u);
    double worst = 0;
    for (std::size_t a = 0; a < list.size(); ++a)
      worst = std::max(worst, std::abs(rhs[list[a]] - at.u[at.local[a]]));
    if (worst <= target || !(worst < former)) {
      done = worst <= target;
      break;
    }
    former = 0.5 * worst;
    for (auto* v : {&at.x, &at.r, &at.z, &at.d})
      std::fill(v->begin(), v->end(), 0.0f);
    for (std::size_t a = 0; a < list.size(); ++a) // of order one, so that squares are in range
      at.r[at.local[a]] = static_cast<float>((rhs[list[a]] - at.u[at.local[a]]) / worst);
    const double wanted = target / worst;
    const int before = products;
    const auto reached =
        correct(at, worst, std::max(wanted, single_run), 50 + static_cast<int>(list.size()), products);
    // of one component: a quarter of the product, and the preconditioner
    const double product = product_work(system.numbers->translational, at.box.rows());
    system.spend((0.25 * product + 0.3) * (products - before) * at.box.size());
    if (!reached)
      return nullptr;
    for (const int l : at.local)
      at.p[l] += worst * at.x[l];
    done = *reached <= wanted;
  }
  y.setZero();
  for (std::size_t a = 0; a < list.size(); ++a)
    y[list[a]] = at.p[at.local[a]];
  at.copy_u(grid_mx, u);
  return done ? &at.box : nullptr;
}

} // namespace bem_contact::contact
