#include "bem_contact/contact/check/discretisation.hpp"

#include "bem_contact/contact/rolling_step.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bem_contact::contact {
namespace {

/// Which fine elements of one direction the coarse ones join: coarse k is fine first + factor k and the next.
struct Joined {
  int factor = 1, first = 0, count = 0;
};

/// `lowest` .. `highest` is in contact.
Joined join(int fine_count, int lowest, int highest) {
  if (fine_count == 1)
    return {1, 0, 1};
  const bool leave_first = fine_count % 2 == 1 && lowest > fine_count - 1 - highest;
  return {2, leave_first ? 1 : 0, fine_count / 2};
}

InfluenceNumbers coarsen(const InfluenceNumbers& fine, const Joined& x, const Joined& s, bool only_normal) {
  InfluenceNumbers coarse;
  coarse.offsets = only_normal ? x.count : x.count + rolling_columns;
  coarse.rows = s.count;
  coarse.dx = x.factor * fine.dx;
  coarse.ds = s.factor * fine.ds;
  coarse.translational = fine.translational;
  coarse.values.assign(coarse.expected_values(), 0.0);
  // x - x' of two pairs of elements: 2 m - 1, 2 m twice, 2 m + 1
  const auto along_x = [&](int m, int row_i, int i, int row_j, int j) {
    const auto number = [&](int offset) {
      const int m_fine = std::abs(offset), known = fine.offsets - 1;
      double value = fine.at(std::min(m_fine, known), row_i, i, row_j, j);
      if (m_fine > known)
        value += (m_fine - known) * (value - fine.at(known - 1, row_i, i, row_j, j));
      return (offset < 0 ? parity(i, j) : 1) * value;
    };
    return x.factor == 1 ? number(m) : number(2 * m - 1) + 2 * number(2 * m) + number(2 * m + 1);
  };
  const double weight = 1.0 / (x.factor * s.factor);
  const int from = only_normal ? component_n : component_x;
  for (int m = 0; m < coarse.offsets; ++m)
    for (const auto& [row_i, row_j] : coarse.stored_rows())
      for (int i = from; i <= component_n; ++i)
        for (int j = from; j <= component_n; ++j) {
          double sum = 0;
          for (int c = 0; c < s.factor; ++c)
            for (int d = 0; d < s.factor; ++d)
              sum += along_x(m, s.first + s.factor * row_i + c, i, s.first + s.factor * row_j + d, j);
          coarse.at(m, row_i, i, row_j, j) = weight * sum;
        }
  return coarse;
}

struct Weight {
  int index;
  double value;
};

/// Weights of the fine elements that give the value at the centre of coarse element k: cubic interpolation,
/// linear at the ends of the grid.
std::vector<Weight> centre_weights(const Joined& joined, int k, int fine_count) {
  const int at = joined.first + joined.factor * k;
  if (joined.factor == 1)
    return {{at, 1.0}};
  if (at == 0 || at + 2 >= fine_count)
    return {{at, 0.5}, {at + 1, 0.5}};
  return {{at - 1, -0.0625}, {at, 0.5625}, {at + 1, 0.5625}, {at + 2, -0.0625}};
}

/// Totals of p_n or of p_t, and of p_t in the local frames.
struct Sums {
  double fx = 0, fy = 0, fz = 0, mz = 0; ///< frame of the rows
  double fs = 0, moment = 0;             ///< along s; about the point (x, s)
};

struct Parts {
  Sums normal, shear;
  double pressure = 0;        ///< sum p_n dS
  double friction = 0;        ///< sum mu p_n dS
  double friction_moment = 0; ///< sum mu p_n r dS, r from the point (x, s)
};

Parts sum_up(const ContactProblem& problem, const ContactResult& result, double x_at, double s_at) {
  Parts parts;
  const double area = problem.element_area();
  for (int i = 0; i < problem.grid.size(); ++i) {
    if (!(result.pn[i] > 0))
      continue;
    const ContactRow& row = problem.rows[i / problem.grid.mx];
    const double cosine = std::cos(row.delta), sine = std::sin(row.delta);
    const double x = problem.grid.x(i % problem.grid.mx);
    const double fn = result.pn[i] * area, fx = result.px[i] * area, fs = result.ps[i] * area;
    parts.normal.fy -= fn * sine;
    parts.normal.fz += fn * cosine;
    parts.normal.mz -= x * fn * sine;
    parts.shear.fx += fx;
    parts.shear.fy += fs * cosine;
    parts.shear.fz += fs * sine;
    parts.shear.mz += x * fs * cosine - row.position.y * fx;
    parts.shear.fs += fs;
    parts.shear.moment += (x - x_at) * fs - (row.s - s_at) * fx;
    parts.pressure += fn;
    const double friction = problem.friction_of(i / problem.grid.mx) * fn;
    parts.friction += friction;
    parts.friction_moment += friction * std::hypot(x - x_at, row.s - s_at);
  }
  return parts;
}

ContactTotals totals(const ContactResult& result) {
  return {result.Fx, result.Fy, result.Fz, result.Mz, result.approach, result.creepage_x, result.creepage_s};
}

double largest_approach(const ContactResult& result) {
  double largest = 0;
  for (const PatchSummary& patch : result.patches)
    largest = std::max(largest, patch.approach);
  return largest;
}

} // namespace

std::optional<Companion> coarse_companion(const ContactProblem& problem, const ContactResult& result) {
  const ContactGrid& grid = problem.grid;
  if (result.patches.empty() || result.touches_border || grid.size() == 1 ||
      problem.motion == MotionKind::transient) // which rolls on by dx, another step on larger elements
    return std::nullopt;
  int first_x = grid.mx, last_x = 0, first_s = grid.ms, last_s = 0;
  for (int i = 0; i < grid.size(); ++i)
    if (result.pn[i] > 0) {
      first_x = std::min(first_x, i % grid.mx);
      last_x = std::max(last_x, i % grid.mx);
      first_s = std::min(first_s, i / grid.mx);
      last_s = std::max(last_s, i / grid.mx);
    }
  const Joined x = join(grid.mx, first_x, last_x), s = join(grid.ms, first_s, last_s);

  ContactProblem coarse;
  coarse.grid = {x.count, s.count, x.factor * grid.dx, s.factor * grid.ds,
                 grid.x(x.first) + 0.5 * (x.factor - 1) * grid.dx};
  coarse.load = problem.load;
  coarse.approach = problem.approach;
  coarse.force = problem.force;
  coarse.tangential = problem.tangential;
  coarse.friction = problem.friction;
  coarse.kinetic = problem.kinetic;
  coarse.force_x = problem.force_x;
  coarse.force_s = problem.force_s;
  coarse.reference_delta = problem.reference_delta;
  coarse.motion = problem.motion;
  coarse.numbers = coarsen(problem.numbers, x, s, !problem.has_friction());
  coarse.rows.resize(s.count);
  for (int is = 0; is < s.count; ++is)
    for (const Weight& w : centre_weights(s, is, grid.ms)) {
      const ContactRow& row = problem.rows[w.index];
      coarse.rows[is].s += w.value * row.s;
      coarse.rows[is].position = coarse.rows[is].position + w.value * row.position;
      coarse.rows[is].delta += w.value * row.delta;
    }
  if (!problem.friction_rows.empty())
    for (int is = 0; is < s.count; ++is) {
      double mu = 0;
      for (int c = 0; c < s.factor; ++c)
        mu += problem.friction_rows[s.first + s.factor * is + c] / s.factor;
      coarse.friction_rows.push_back(mu);
    }
  const auto at_centres = [&](const std::vector<double>& field) {
    std::vector<double> out;
    out.reserve(coarse.grid.size());
    for (int is = 0; is < s.count; ++is)
      for (int ix = 0; ix < x.count; ++ix) {
        double sum = 0;
        for (const Weight& row : centre_weights(s, is, grid.ms))
          for (const Weight& column : centre_weights(x, ix, grid.mx))
            sum += row.value * column.value * field[row.index * grid.mx + column.index];
        out.push_back(sum);
      }
    return out;
  };
  coarse.gap = at_centres(problem.gap);
  // Elements without an opposite surface have a distance far beyond the others', beside which a cubic would
  // dig a hole: there it is linear.
  double far = std::abs(result.approach);
  for (int i = 0; i < grid.size(); ++i)
    if (result.pn[i] > 0)
      far = std::max(far, std::abs(problem.gap[i]));
  for (int is = 0; is < s.count; ++is)
    for (int ix = 0; ix < x.count; ++ix) {
      double largest = 0, mean = 0;
      for (const Weight& row : centre_weights(s, is, grid.ms))
        for (const Weight& column : centre_weights(x, ix, grid.mx))
          largest = std::max(largest, problem.gap[row.index * grid.mx + column.index]);
      if (largest <= 10 * far)
        continue;
      for (int c = 0; c < s.factor; ++c)
        for (int d = 0; d < x.factor; ++d)
          mean += problem.gap[(s.first + s.factor * is + c) * grid.mx + x.first + x.factor * ix + d];
      coarse.gap[is * x.count + ix] = mean / (s.factor * x.factor);
    }
  if (problem.has_friction()) {
    coarse.slip_x = at_centres(problem.slip_x);
    coarse.slip_s = at_centres(problem.slip_s);
    for (const Tractions& former : problem.previous)
      coarse.previous.push_back({at_centres(former.px), at_centres(former.ps), at_centres(former.pn)});
  }
  const auto mean = [&](const std::vector<double>& field) {
    std::vector<double> out(coarse.grid.size());
    for (int is = 0; is < s.count; ++is)
      for (int c = 0; c < s.factor; ++c)
        for (int ix = 0; ix < x.count; ++ix)
          for (int d = 0; d < x.factor; ++d)
            out[is * x.count + ix] +=
                field[(s.first + s.factor * is + c) * grid.mx + x.first + x.factor * ix + d] /
                (s.factor * x.factor);
    return out;
  };
  StartingPoint start{mean(result.px), mean(result.ps), mean(result.pn), result.approach};
  return Companion{std::move(coarse), std::move(start)};
}

std::optional<Discretisation> compare(const ContactProblem& problem, const ContactResult& result,
                                      const ContactProblem& coarse_problem, const ContactResult& coarse) {
  // fewer elements say nothing: on Hertz contacts 12 across (28 in the companion) the two agree by chance
  const int least = coarse_problem.grid.mx > 1 && coarse_problem.grid.ms > 1 ? 40 : 7;
  const auto contact = std::count_if(coarse.pn.begin(), coarse.pn.end(), [](double v) { return v > 0; });
  if (!(coarse.certificate.worst() <= companion_violation) || contact < least)
    return std::nullopt;
  double x_at = 0, s_at = 0, fn = 0;
  for (const PatchSummary& patch : result.patches) {
    x_at += patch.fn * patch.x;
    s_at += patch.fn * patch.s;
    fn += patch.fn;
  }
  const Parts fine = sum_up(problem, result, x_at / fn, s_at / fn);
  const Parts rough = sum_up(coarse_problem, coarse, x_at / fn, s_at / fn);

  // what is added to a result of error C h^2 to remove it
  constexpr double second_order = 1.0 / 3.0;
  const auto normal = [&](double Sums::*q) { return second_order * (fine.normal.*q - rough.normal.*q); };
  const auto shear = [&](double Sums::*q) { return second_order * (fine.shear.*q - rough.shear.*q); };
  Discretisation out;
  out.contact = static_cast<int>(contact);
  out.coarse = totals(coarse);
  out.extrapolated = totals(result);
  out.extrapolated.Fx += shear(&Sums::fx);
  out.extrapolated.Fy += normal(&Sums::fy) + shear(&Sums::fy);
  out.extrapolated.Mz += normal(&Sums::mz) + shear(&Sums::mz);
  const double approach = second_order * (result.approach - coarse.approach);
  if (problem.load == LoadKind::force) {
    out.extrapolated.approach += approach;
    out.approach = std::abs(approach) / largest_approach(result);
  } else
    out.extrapolated.Fz += normal(&Sums::fz) + shear(&Sums::fz);
  out.normal = std::hypot(normal(&Sums::fy), normal(&Sums::fz)) / fine.pressure;
  out.extrapolated.creepage_x += second_order * (result.creepage_x - coarse.creepage_x);
  out.extrapolated.creepage_s += second_order * (result.creepage_s - coarse.creepage_s);
  if (problem.has_friction()) {
    out.tangential =
        std::hypot(fine.shear.fx - rough.shear.fx, fine.shear.fs - rough.shear.fs) / fine.friction;
    if (fine.friction_moment > 0)
      out.moment = std::abs(fine.shear.moment - rough.shear.moment) / fine.friction_moment;
  }
  return out;
}

} // namespace bem_contact::contact
