#include "bem_contact/contact/grid/larger_elements.hpp"

#include "bem_contact/base/parallel.hpp"
#include "bem_contact/contact/slip_step.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace bem_contact::contact {
namespace {

/// 1. An undeformed distance beyond this times the largest in contact means that there is no opposite
/// surface. Chosen: real distances next to a contact are below it, missing surfaces are far above it.
constexpr double distance_without_surface = 10;

ContactProblem copy_conditions(const ContactConditions& question) {
  ContactProblem coarse;
  static_cast<ContactConditions&>(coarse) = question;
  return coarse;
}

/// What the known offsets along x count for in a sum of numbers at any offsets.
struct OffsetWeight {
  int offset;
  std::array<double, 2> weight; ///< of numbers even and odd in x
};

/// Of numbers at 2 m - 1, 2 m (twice) and 2 m + 1, which are x - x' of two pairs of elements; or at m alone
/// where elements are not joined. Beyond the last offset known lies the line through the last two.
std::vector<OffsetWeight> offset_weights(int m, int factor, int last) {
  std::vector<OffsetWeight> out;
  const auto add = [&](int offset, double weight) {
    const double odd = offset < 0 ? -weight : weight;
    const int beyond = std::max(std::abs(offset) - last, 0);
    out.push_back({std::abs(offset) - beyond, {(1 + beyond) * weight, (1 + beyond) * odd}});
    if (beyond > 0)
      out.push_back({last - 1, {-beyond * weight, -beyond * odd}});
  };
  if (factor == 1) {
    add(m, 1);
  } else {
    add(2 * m - 1, 1);
    add(2 * m, 2);
    add(2 * m + 1, 1);
  }
  return out;
}

/// to += weight from, over the numbers of one offset, [..][i][j]. weight[1] is for those odd in x, and the
/// rows of their table have `width` numbers.
void add_offset(const double* from, const std::array<double, 2>& weight, std::size_t width,
                std::vector<double>& to) {
  if (weight[0] == weight[1]) {
    for (std::size_t e = 0; e < to.size(); ++e)
      to[e] += weight[0] * from[e];
    return;
  }
  for (std::size_t e = 0; e < to.size(); ++e)
    to[e] += weight[parity(static_cast<int>(e / width % 3), static_cast<int>(e % width % 3)) < 0] * from[e];
}

} // namespace

LargerElements::Joined LargerElements::join(int fine_count, int lowest, int highest) {
  if (fine_count == 1)
    return {1, 0, 1};
  const bool leave_first = fine_count % 2 == 1 && lowest > fine_count - 1 - highest;
  return {2, leave_first ? 1 : 0, fine_count / 2};
}

LargerElements::LargerElements(const ContactGrid& fine)
    : fine_(fine), x_(join(fine.mx, 0, 0)), s_(join(fine.ms, 0, 0)) {}

LargerElements::LargerElements(const ContactGrid& fine, const std::vector<double>& pn) : fine_(fine) {
  int first_x = fine.mx, last_x = 0, first_s = fine.ms, last_s = 0;
  for (int i = 0; i < fine.size(); ++i)
    if (pn[i] > 0) {
      first_x = std::min(first_x, i % fine.mx);
      last_x = std::max(last_x, i % fine.mx);
      first_s = std::min(first_s, i / fine.mx);
      last_s = std::max(last_s, i / fine.mx);
    }
  x_ = join(fine.mx, first_x, last_x);
  s_ = join(fine.ms, first_s, last_s);
}

ContactGrid LargerElements::grid() const {
  return {x_.count, s_.count, x_.factor * fine_.dx, s_.factor * fine_.ds,
          fine_.x(x_.first) + 0.5 * (x_.factor - 1) * fine_.dx};
}

std::vector<LargerElements::Interpolation> LargerElements::centres_of(const Joined& joined, int fine_count) {
  std::vector<Interpolation> out;
  for (int k = 0; k < joined.count; ++k) {
    const int at = joined.first + joined.factor * k;
    if (joined.factor == 1)
      out.push_back({at});
    else if (at == 0 || at + 2 >= fine_count)
      out.push_back({at, 2, {0.5, 0.5}});
    else
      out.push_back({at - 1, 4, {-0.0625, 0.5625, 0.5625, -0.0625}});
  }
  return out;
}

double LargerElements::mean_at(const std::vector<double>& field, int ix, int is) const {
  double sum = 0;
  for (int c = 0; c < s_.factor; ++c)
    for (int d = 0; d < x_.factor; ++d)
      sum += field[(s_.first + s_.factor * is + c) * fine_.mx + x_.first + x_.factor * ix + d];
  return sum / (s_.factor * x_.factor);
}

std::vector<double> LargerElements::mean(const std::vector<double>& field) const {
  std::vector<double> out;
  out.reserve(static_cast<std::size_t>(x_.count) * s_.count);
  for (int is = 0; is < s_.count; ++is)
    for (int ix = 0; ix < x_.count; ++ix)
      out.push_back(mean_at(field, ix, is));
  return out;
}

std::vector<double> LargerElements::between(const std::vector<double>& coarse) const {
  struct Place {
    int low, high;
    double share; ///< of high
  };
  const auto place = [](const Joined& joined, int k) {
    const double at = std::clamp((k - joined.first + 0.5) / joined.factor - 0.5, 0.0,
                                 static_cast<double>(joined.count - 1));
    const int low = static_cast<int>(at);
    return Place{low, std::min(low + 1, joined.count - 1), at - low};
  };
  std::vector<double> out;
  out.reserve(fine_.size());
  for (int is = 0; is < fine_.ms; ++is) {
    const Place s = place(s_, is);
    for (int ix = 0; ix < fine_.mx; ++ix) {
      const Place x = place(x_, ix);
      const auto line = [&](int row) {
        return (1 - x.share) * coarse[row * x_.count + x.low] + x.share * coarse[row * x_.count + x.high];
      };
      out.push_back((1 - s.share) * line(s.low) + s.share * line(s.high));
    }
  }
  return out;
}

std::vector<double> LargerElements::at_centres(const std::vector<double>& field) const {
  std::vector<double> out, line(fine_.mx);
  out.reserve(static_cast<std::size_t>(x_.count) * s_.count);
  const std::vector<Interpolation> columns = centres_of(x_, fine_.mx);
  for (const Interpolation& row : centres_of(s_, fine_.ms)) {
    std::ranges::fill(line, 0.0);
    for (int c = 0; c < row.count; ++c)
      for (int ix = 0; ix < fine_.mx; ++ix)
        line[ix] += row.weight[c] * field[(row.first + c) * fine_.mx + ix];
    for (const Interpolation& column : columns) {
      double sum = 0;
      for (int d = 0; d < column.count; ++d)
        sum += column.weight[d] * line[column.first + d];
      out.push_back(sum);
    }
  }
  return out;
}

std::vector<ContactRow> LargerElements::rows_at_centres(const std::vector<ContactRow>& rows) const {
  std::vector<ContactRow> out;
  for (const Interpolation& centre : centres_of(s_, fine_.ms)) {
    ContactRow& sum = out.emplace_back();
    for (int c = 0; c < centre.count; ++c) {
      const ContactRow& row = rows[centre.first + c];
      sum.s += centre.weight[c] * row.s;
      sum.position = sum.position + centre.weight[c] * row.position;
      sum.delta += centre.weight[c] * row.delta;
    }
  }
  return out;
}

std::vector<ContactRow> LargerElements::mean_rows(const std::vector<ContactRow>& rows) const {
  std::vector<ContactRow> out;
  for (int is = 0; is < s_.count; ++is) {
    const ContactRow &a = rows[s_.first + s_.factor * is], &b = rows[s_.first + s_.factor * (is + 1) - 1];
    out.push_back({0.5 * (a.s + b.s), 0.5 * (a.position + b.position), 0.5 * (a.delta + b.delta)});
  }
  return out;
}

std::vector<double> LargerElements::mean_of_rows(const std::vector<double>& values) const {
  std::vector<double> out;
  for (int is = 0; !values.empty() && is < s_.count; ++is) {
    double sum = 0;
    for (int c = 0; c < s_.factor; ++c)
      sum += values[s_.first + s_.factor * is + c] / s_.factor;
    out.push_back(sum);
  }
  return out;
}

std::vector<FallingFriction> LargerElements::of_rows(const std::vector<FallingFriction>& laws) const {
  if (laws.size() <= 1)
    return laws;
  const auto mean_of = [&](double FallingFriction::*number) {
    std::vector<double> values;
    for (const FallingFriction& law : laws)
      values.push_back(law.*number);
    return mean_of_rows(values);
  };
  const std::vector<double> ratios = mean_of(&FallingFriction::ratio),
                            scales = mean_of(&FallingFriction::scale);
  std::vector<FallingFriction> out;
  for (std::size_t row = 0; row < ratios.size(); ++row)
    out.push_back({ratios[row], scales[row], laws.front().fall});
  return out;
}

std::vector<double> LargerElements::gap_at_centres(const std::vector<double>& gap, double far) const {
  std::vector<double> out = at_centres(gap);
  if (std::ranges::none_of(gap, [far](double h) { return h > far; }))
    return out;
  const std::vector<Interpolation> rows = centres_of(s_, fine_.ms), columns = centres_of(x_, fine_.mx);
  const auto near_far = [&](const Interpolation& row, const Interpolation& column) {
    for (int c = 0; c < row.count; ++c)
      for (int d = 0; d < column.count; ++d)
        if (gap[(row.first + c) * fine_.mx + column.first + d] > far)
          return true;
    return false;
  };
  for (int is = 0; is < s_.count; ++is)
    for (int ix = 0; ix < x_.count; ++ix)
      if (near_far(rows[is], columns[ix]))
        out[is * x_.count + ix] = mean_at(gap, ix, is);
  return out;
}

/// All pairs of rows, [3 I + i][3 J + j].
void LargerElements::join_pairs(const std::vector<double>& fine, double share, double* coarse) const {
  const auto width = 3 * static_cast<std::size_t>(fine_.ms), count = static_cast<std::size_t>(s_.count),
             factor = static_cast<std::size_t>(s_.factor), first = static_cast<std::size_t>(s_.first);
  std::vector<double> line(width);
  for (std::size_t row = 0; row < count; ++row)
    for (std::size_t i = 0; i < 3; ++i) {
      std::ranges::fill(line, 0.0);
      for (std::size_t c = 0; c < factor; ++c) {
        const double* from = &fine[(3 * (first + factor * row + c) + i) * width];
        for (std::size_t e = 0; e < width; ++e)
          line[e] += share * from[e];
      }
      for (std::size_t column = 0; column < count; ++column)
        for (std::size_t j = 0; j < 3; ++j, ++coarse) {
          *coarse = 0;
          for (std::size_t d = 0; d < factor; ++d)
            *coarse += line[3 * (first + factor * column + d) + j];
        }
    }
}

/// Rows at each distance, [I - J][i][j].
void LargerElements::join_distances(const std::vector<double>& fine, double share, double* coarse) const {
  for (int distance = 1 - s_.count; distance < s_.count; ++distance, coarse += 9) {
    std::fill(coarse, coarse + 9, 0.0);
    for (int apart = 1 - s_.factor; apart < s_.factor; ++apart) {
      const double* from = &fine[static_cast<std::size_t>(9 * (s_.factor * distance + apart + fine_.ms - 1))];
      for (int e = 0; e < 9; ++e)
        coarse[e] += share * (s_.factor - std::abs(apart)) * from[e];
    }
  }
}

InfluenceNumbers LargerElements::numbers(const InfluenceNumbers& fine, bool only_normal, int threads) const {
  InfluenceNumbers coarse;
  coarse.offsets = only_normal ? x_.count : x_.count + rolling_columns;
  coarse.rows = s_.count;
  coarse.dx = x_.factor * fine.dx;
  coarse.ds = s_.factor * fine.ds;
  coarse.translational = fine.translational;
  coarse.values.resize(coarse.expected_values());
  const std::size_t size = fine.expected_values() / static_cast<std::size_t>(fine.offsets),
                    coarse_size = coarse.expected_values() / static_cast<std::size_t>(coarse.offsets),
                    width = fine.translational ? 3 : 3 * static_cast<std::size_t>(fine.rows);
  const double share = 1.0 / (x_.factor * s_.factor);
  in_parts(threads, coarse.offsets, [&](int m, int end, int) {
    std::vector<double> sum(size);
    for (; m < end; ++m) {
      std::ranges::fill(sum, 0.0);
      for (const auto& [offset, weight] : offset_weights(m, x_.factor, fine.offsets - 1))
        add_offset(&fine.values[static_cast<std::size_t>(offset) * size], weight, width, sum);
      double* const to = &coarse.values[static_cast<std::size_t>(m) * coarse_size];
      fine.translational ? join_distances(sum, share, to) : join_pairs(sum, share, to);
    }
  });
  return coarse;
}

std::string why_no_companion(const ContactProblem& problem, const ContactResult& result) {
  if (result.patches.empty())
    return "there is no contact";
  if (result.trust.touches_border)
    return "the contact reaches the edge of the grid. Give a larger grid";
  if (problem.grid.size() == 1)
    return "the grid is one element. Give smaller elements";
  return problem.motion == MotionKind::transient ? "they are not estimated in transient rolling" : "";
}

Companion companion_of(const ContactProblem& problem, const ContactResult& result,
                       const LargerElements& larger) {
  double far = std::abs(result.totals.approach);
  for (int i = 0; i < problem.grid.size(); ++i)
    if (result.pn[i] > 0)
      far = std::max(far, std::abs(problem.gap[i]));
  ContactProblem coarse = copy_conditions(problem);
  coarse.grid = larger.grid();
  coarse.rows = larger.rows_at_centres(problem.rows);
  coarse.friction_rows = larger.mean_of_rows(problem.friction_rows);
  coarse.falling = larger.of_rows(problem.falling);
  coarse.memory = problem.memory;
  coarse.speed = problem.speed;
  coarse.heating = problem.heating;
  coarse.gap = larger.gap_at_centres(problem.gap, distance_without_surface * far);
  if (problem.has_friction()) {
    coarse.slip_x = larger.at_centres(problem.slip_x);
    coarse.slip_s = larger.at_centres(problem.slip_s);
    for (const Tractions& former : problem.previous)
      coarse.previous.push_back({larger.at_centres(former.px), larger.at_centres(former.ps),
                                 larger.at_centres(former.pn),
                                 former.plastic.empty() ? former.plastic : larger.mean(former.plastic)});
  }
  StartingPoint start{{larger.mean(result.px), larger.mean(result.ps), larger.mean(result.pn)},
                      result.totals.approach};
  return Companion{std::move(coarse), std::move(start)};
}

ContactProblem starting_problem(const ContactProblem& problem) {
  const LargerElements larger(problem.grid);
  ContactProblem coarse = copy_conditions(problem);
  coarse.tangential =
      problem.tangential && problem.motion == MotionKind::steady && !problem.force_x && !problem.force_s;
  coarse.force_x = coarse.force_s = std::nullopt;
  coarse.motion = MotionKind::steady;
  coarse.grid = larger.grid();
  coarse.rows = larger.mean_rows(problem.rows);
  coarse.friction_rows = larger.mean_of_rows(problem.friction_rows);
  coarse.gap = larger.mean(problem.gap);
  if (coarse.tangential) {
    coarse.slip_x = larger.mean(problem.slip_x);
    coarse.slip_s = larger.mean(problem.slip_s);
  }
  return coarse;
}

int starting_row(const ContactProblem& problem) {
  if (problem.numbers.translational)
    return 0;
  return static_cast<int>(std::ranges::min_element(problem.gap) - problem.gap.begin()) / problem.grid.mx;
}

InfluenceNumbers starting_numbers(const InfluenceNumbers& fine, const ContactGrid& grid, int middle,
                                  bool only_normal) {
  const int offsets = grid.mx + rolling_columns, rows = grid.ms;
  InfluenceNumbers coarse{offsets, rows, 2 * fine.dx, 2 * fine.ds, {}, true};
  coarse.values.assign(coarse.expected_values(), 0.0);
  const int from = only_normal ? component_n : component_x;
  for (int i = from; i < 3; ++i)
    for (int j = from; j < 3; ++j) {
      const auto number = [&](int m, int d) { // offsets beyond those known repeat the last
        int row_i = std::max(d, 0);
        if (!fine.translational)
          row_i = std::clamp(middle + d / 2, row_i, fine.rows - 1 + std::min(d, 0));
        return (m < 0 ? parity(i, j) : 1) *
               fine.at(std::min(std::abs(m), fine.offsets - 1), row_i, i, row_i - d, j);
      };
      for (int m = 0; m < offsets; ++m)
        for (int d = 1 - rows; d < rows; ++d) {
          double sum = 0;
          for (const int p : {-1, 0, 1})
            for (const int q : {-1, 0, 1})
              sum += (p == 0 ? 2 : 1) * (q == 0 ? 2 : 1) * number(2 * m + p, 2 * d + q);
          coarse.at(m, std::max(d, 0), i, std::max(-d, 0), j) = 0.25 * sum;
        }
    }
  return coarse;
}

} // namespace bem_contact::contact
