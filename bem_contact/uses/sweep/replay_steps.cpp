#include "bem_contact/uses/sweep/replay_steps.hpp"

#include "bem_contact/record/record.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <set>
#include <utility>

namespace bem_contact {

namespace {

/// 1. Of a number whose error is not known, or smaller than this share of it, this share counts as its error.
/// Chosen: finer than any stated error of a contact with the usual elements.
constexpr double least_share = 1e-3;

/// A number and where its stated error is.
struct Judged {
  std::size_t value, error;
};

std::vector<Judged> judged_of(const std::vector<SweepColumn>& columns) {
  std::vector<Judged> out;
  for (std::size_t k = 0; k + 1 < columns.size(); ++k)
    if (columns[k + 1].role == record::Role::error && columns[k + 1].of == columns[k].name)
      out.push_back({k, k + 1});
  return out;
}

/// A key that varies.
struct Input {
  std::vector<double> values; ///< one a step
  double range;               ///< the largest less the smallest of the run
};

std::vector<Input> inputs_of(const SweepFile& sweep) {
  std::vector<Input> out;
  for (const SweepFile::Axis& axis : sweep.axes) {
    if (axis.is_note() || !std::holds_alternative<double>(axis.values.front()))
      continue;
    std::vector<double> values;
    for (const SchemaValue& value : axis.values)
      values.push_back(std::get<double>(value));
    const auto [least, most] = std::ranges::minmax(values);
    if (most > least)
      out.push_back({std::move(values), most - least});
  }
  return out;
}

bool is_whole(double value) {
  return value == std::round(value);
}

/// On the line from `a` to `b`; of counts, the nearest.
double on_line(double a, double b, double share) {
  if (a == b)
    return a;
  if ((is_whole(a) && is_whole(b)) || !std::isfinite(a) || !std::isfinite(b))
    return share < 0.5 ? a : b;
  return a + share * (b - a);
}

class Steps {
public:
  Steps(const SweepFile& sweep, CaseRange steps, const std::function<SweepCase(std::size_t)>& solve)
      : first_(steps.first), tolerance_(sweep.replay->tolerance), inputs_(inputs_of(sweep)),
        columns_(columns_of_contacts(sweep)), judged_(judged_of(columns_.cases)),
        patch_errors_(judged_of(columns_.patches)), solve_(solve), steps_(steps.size()) {}

  void answer() {
    solve_step(first_);
    const std::size_t last = first_ + steps_.size() - 1;
    if (last > first_ && alike(first_, last))
      fill(first_, last);
    else if (last > first_) {
      solve_step(last);
      between(first_, last);
    }
  }

  std::vector<SweepCase> take() { return std::move(steps_); }
  bool is_solved(std::size_t i) const { return solved_.contains(i); }

private:
  SweepCase& at(std::size_t i) { return steps_[i - first_]; }

  void solve_step(std::size_t i) {
    at(i) = solve_(i);
    solved_.insert(i);
  }

  /// All inputs of the steps from `a` to `b` are those of `a`.
  bool alike(std::size_t a, std::size_t b) const {
    return std::ranges::all_of(inputs_, [&](const Input& input) {
      return std::all_of(input.values.begin() + std::ptrdiff_t(a),
                         input.values.begin() + std::ptrdiff_t(b) + 1,
                         [&](double one) { return one == input.values[a]; });
    });
  }

  /// The step between two whose inputs lie farthest off the line between theirs; the middle one if all lie on
  /// it.
  std::size_t farthest(std::size_t a, std::size_t b) const {
    constexpr double on_it = 1e-9; // of the range: rounding
    std::size_t out = (a + b) / 2;
    double most = on_it;
    for (std::size_t i = a + 1; i < b; ++i) {
      const double share = double(i - a) / double(b - a);
      double off = 0;
      for (const auto& [x, range] : inputs_)
        off = std::max(off, std::abs(x[i] - x[a] - share * (x[b] - x[a])) / range);
      if (off > most) {
        most = off;
        out = i;
      }
    }
    return out;
  }

  /// Both ends are solved.
  void between(std::size_t a, std::size_t b) {
    if (b - a < 2)
      return;
    if (alike(a, b))
      return fill(a, b - 1);
    const std::size_t c = farthest(a, b);
    std::optional<SweepCase> expected;
    if (comparable(at(a), at(b)))
      expected = on_lines(a, b, c);
    solve_step(c);
    if (expected && comparable(at(a), at(c)) && agrees(*expected, at(c))) {
      draw_line(a, c);
      draw_line(c, b);
    } else {
      between(a, c);
      between(c, b);
    }
  }

  /// Steps after `a` up to `b` are the same as it.
  void fill(std::size_t a, std::size_t b) {
    for (std::size_t i = a + 1; i <= b; ++i)
      at(i) = taken_from(a, i);
  }
  void draw_line(std::size_t a, std::size_t b) {
    for (std::size_t i = a + 1; i < b; ++i)
      at(i) = on_lines(a, b, i);
  }

  SweepCase taken_from(std::size_t from, std::size_t i) {
    SweepCase out = at(from);
    out.index = i;
    out.seconds = out.cpu_seconds = std::nan("");
    return out;
  }

  SweepCase on_lines(std::size_t a, std::size_t b, std::size_t i) {
    const double share = double(i - a) / double(b - a);
    const SweepCase& one = at(a);
    const SweepCase& other = at(b);
    SweepCase out = taken_from(share < 0.5 ? a : b, i);
    const auto draw = [&](std::vector<double>& to, const std::vector<double>& from,
                          const std::vector<double>& until, const std::vector<Judged>& judged) {
      for (std::size_t k = 0; k < to.size(); ++k)
        to[k] = on_line(from[k], until[k], share);
      for (const auto& [value, error] : judged)
        to[error] =
            (1 + tolerance_) * (std::isnan(from[error]) ? from[error] : std::max(until[error], from[error]));
    };
    draw(out.summary, one.summary, other.summary, judged_);
    for (const auto& [value, error] : judged_)
      if (!(one.summary[error] > 0 || other.summary[error] > 0))
        if (const Input* input = prescribed(a, one.summary[value], b, other.summary[value]))
          out.summary[value] = input->values[i];
    for (std::size_t k = 0; k < out.patches.size(); ++k)
      draw(out.patches[k], one.patches[k], other.patches[k], patch_errors_);
    return out;
  }

  /// The input that a number is, such as Fz of load.force; null: none.
  const Input* prescribed(std::size_t a, double at_a, std::size_t b, double at_b) const {
    constexpr double same = 1e-6; // 1, as solutions agree
    const auto is = [](double one, double other) { return std::abs(one - other) <= same * std::abs(other); };
    const auto found = std::ranges::find_if(
        inputs_, [&](const Input& input) { return is(at_a, input.values[a]) && is(at_b, input.values[b]); });
    return found == inputs_.end() ? nullptr : &*found;
  }

  bool comparable(const SweepCase& a, const SweepCase& b) const {
    if (a.status != record::Outcome::certified || b.status != record::Outcome::certified ||
        a.patches.size() != b.patches.size())
      return false;
    for (std::size_t k = 0; k < columns_.cases.size(); ++k)
      if (is_model(columns_.cases[k]) && a.summary[k] != b.summary[k])
        return false;
    return true;
  }

  bool agrees(const SweepCase& expected, const SweepCase& found) const {
    return std::ranges::all_of(judged_, [&](const Judged& one) {
      const double value = found.summary[one.value], stated = found.summary[one.error],
                   error = std::isnan(stated) ? 0 : stated,
                   off = std::abs(expected.summary[one.value] - value);
      if (std::isnan(value)) // this contact has no such number
        return std::isnan(expected.summary[one.value]);
      return off <= tolerance_ * std::max(error, least_share * std::abs(value));
    });
  }

  std::size_t first_;
  double tolerance_;
  std::vector<Input> inputs_;
  SweepColumns columns_;
  std::vector<Judged> judged_, patch_errors_;
  const std::function<SweepCase(std::size_t)>& solve_;
  std::vector<SweepCase> steps_;
  std::set<std::size_t> solved_;
};

} // namespace

std::vector<SweepColumn> replay_columns(const SweepFile::Replay& replay) {
  std::vector<SweepColumn> out{
      {"solved", "1", "1: the step was solved; 0: it lies within the tolerance between two that were"}};
  for (const SweepFile::Replay::Compared& one : replay.compared) {
    out.push_back({one.quantity + "_of_run", one.unit, "as the run's own contact model has it",
                   record::Role::of_run, one.quantity});
    const std::string difference = one.quantity + "_difference";
    out.push_back({difference, one.unit, "the run's own less ours", record::Role::difference, one.quantity});
    out.push_back({record::error_name(difference), one.unit, "estimated error of ours; nan: not known",
                   record::Role::error, difference});
  }
  return out;
}

void replay_steps(const SweepFile& sweep, CaseRange steps, const std::function<SweepCase(std::size_t)>& solve,
                  const std::function<bool(SweepCase)>& kept) {
  Steps all(sweep, steps, solve);
  all.answer();
  const std::vector<SweepColumn> columns = columns_of_contacts(sweep).cases;
  const auto place = [&](const auto& is) {
    return static_cast<std::size_t>(std::ranges::find_if(columns, is) - columns.begin());
  };
  const std::vector<SweepFile::Replay::Compared>& compared = sweep.replay->compared;
  std::vector<Judged> places; // the error of some numbers is not stated
  for (const SweepFile::Replay::Compared& one : compared)
    places.push_back(
        {place([&](const SweepColumn& c) { return c.name == one.quantity; }),
         place([&](const SweepColumn& c) { return c.role == record::Role::error && c.of == one.quantity; })});
  for (SweepCase& step : all.take()) {
    if (!step.summary.empty()) {
      step.summary.push_back(all.is_solved(step.index) ? 1 : 0);
      for (std::size_t k = 0; k < places.size(); ++k) {
        const double of_run = compared[k].of_run[step.index], ours = step.summary.at(places[k].value),
                     error = places[k].error < columns.size() ? step.summary[places[k].error] : std::nan("");
        step.summary.insert(step.summary.end(), {of_run, of_run - ours, error});
      }
    }
    if (!kept(std::move(step)))
      return;
  }
}

} // namespace bem_contact
