#include "bem_contact/app/from_contact/histories.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <utility>

namespace bem_contact::app::from_contact {

namespace {

/// The keys that may change from step to step, as columns of the table.
constexpr std::pair<const char*, const char*> step_columns[] = {
    {"load.force", "load"}, {"load.approach", "load"},   {"motion.xi", "xi"},        {"motion.eta", "eta"},
    {"motion.phi", "phi"},  {"load.force_x", "force_x"}, {"load.force_s", "force_s"}};

using Keys = std::map<std::string, std::string>;

Keys fixed_keys(Keys keys) {
  for (const auto& [key, column] : step_columns)
    keys.erase(key);
  keys.erase("grid.mx");            // the grids of shifts may lie beside each other
  keys.erase("motion.first_shift"); // of the first step alone
  return keys;
}

bool same_columns(const Keys& one, const Keys& other) {
  return std::ranges::all_of(step_columns,
                             [&](const auto& c) { return one.contains(c.first) == other.contains(c.first); });
}

Keys step_keys(const ContactCase& one) {
  Keys out;
  for (const auto& [key, column] : step_columns)
    if (const auto found = one.keys.find(key); found != one.keys.end())
      out.insert(*found);
  return out;
}

bool nearly(double a, double b, double scale) {
  return std::abs(a - b) < 1e-6 * scale;
}

/// Whether the wheelset of a shift is where the next step has it: in its place, or rolled over one element.
bool is_next_place(const ContactCase& before, const ContactCase& next) {
  if (!before.place || !next.place)
    return before.place.has_value() == next.place.has_value();
  const double dx = before.number("grid.dx");
  return nearly(*next.place - *before.place, next.is_shift() ? 0 : dx, dx) &&
         !next.keys.contains("motion.first_shift");
}

bool same_repeated(const ContactCase& one) {
  return std::ranges::all_of(one.steps,
                             [&](const auto& step) { return step.keys == one.steps.front().keys; });
}

bool lies_elsewhere(const ContactCase& one) {
  return one.gap_x && (one.moves || !nearly(*one.gap_x, one.grid->x, one.grid->dx));
}

/// Whether both lie on one larger grid. The contact of a shift may then lie anywhere on it.
bool on_one_grid(const ContactCase& before, const ContactCase& next) {
  const PatchGrid &a = *before.grid, &b = *next.grid;
  if (!nearly(a.dx, b.dx, a.dx) || !nearly(a.ds, b.ds, a.ds) || a.ms != b.ms || a.turned != b.turned ||
      !nearly(a.y, b.y, a.ds))
    return false;
  const double columns = (b.x - a.x) / a.dx + 0.5 * (static_cast<double>(b.mx) - static_cast<double>(a.mx));
  const bool same = a.mx == b.mx && nearly(a.x, b.x, a.dx);
  return same ||
         (before.gap_x && next.gap_x && before.is_shift() && nearly(columns, std::round(columns), 1e3));
}

/// Whether the elements and the place of the contact are those of one history.
bool on_one_history(const ContactCase& before, const ContactCase& next) {
  if (!before.grid || !next.grid) // a wheel on a rail
    return !before.grid && !next.grid && is_next_place(before, next);
  if (before.gap_x.has_value() != next.gap_x.has_value() || !on_one_grid(before, next))
    return false;
  return before.is_shift() ||
         !(before.gap_x && (!nearly(*before.gap_x, *next.gap_x, before.grid->dx) || before.moves));
}

/// The smallest grid that holds both.
PatchGrid grid_of_both(const PatchGrid& a, const PatchGrid& b) {
  const auto half = [](const PatchGrid& g) { return 0.5 * static_cast<double>(g.mx) * g.dx; };
  const double from = std::min(a.x - half(a), b.x - half(b)), to = std::max(a.x + half(a), b.x + half(b));
  PatchGrid out = a;
  out.mx = static_cast<std::size_t>(std::lround((to - from) / a.dx));
  out.x = (from + to) / 2;
  return out;
}

/// Whether both have the same tables, but for the tractions from which the first one starts.
bool same_tables(const ContactCase& before, const ContactCase& next) {
  const auto starts = [](const SceneTableFile& table) { return table.key == "motion.start_table"; };
  std::vector<SceneTableFile> tables = before.tables;
  std::erase_if(tables, starts);
  return std::ranges::equal(tables, next.tables, [](const SceneTableFile& a, const SceneTableFile& b) {
    return a.key == b.key && a.text == b.text;
  });
}

} // namespace

bool join(ContactCase& before, const ContactCase& next) {
  if (!same_tables(before, next) || fixed_keys(before.keys) != fixed_keys(next.keys) ||
      !same_columns(before.keys, next.keys) || !on_one_history(before, next))
    return false;
  if (before.steps.empty())
    before.steps.push_back({step_keys(before), before.gap_x.value_or(0)});
  before.steps.push_back({step_keys(next), next.gap_x.value_or(0)});
  before.place = next.place;
  if (before.grid) {
    before.moves = before.moves || (before.gap_x && !nearly(*before.gap_x, *next.gap_x, before.grid->dx));
    before.grid = grid_of_both(*before.grid, *next.grid);
    before.set("grid.mx", static_cast<double>(before.grid->mx));
  }
  before.last = next.last;
  for (const std::string& sentence : next.left_out)
    if (std::ranges::find(before.left_out, sentence) == before.left_out.end())
      before.left_out.push_back(sentence);
  return true;
}

std::string other_than(const ContactCase& before, const ContactCase& next) {
  const Keys was = fixed_keys(before.keys), is = fixed_keys(next.keys);
  for (const auto* keys : {&is, &was})
    for (const auto& [key, value] : *keys)
      if (const bool both = was.contains(key) && is.contains(key); !both || was.at(key) != is.at(key))
        return fmt::format("another {}", key);
  if (!same_tables(before, next))
    return "another friction table";
  return next.keys.contains("motion.first_shift") ? "a shift of another length"
                                                  : "the wheelset is not one element further on";
}

bool needs_step_table(const ContactCase& one) {
  return lies_elsewhere(one) || !same_repeated(one);
}

std::string step_table(const ContactCase& one) {
  std::vector<ContactCase::Step> steps = one.steps;
  if (steps.empty())
    steps.push_back({step_keys(one), one.gap_x.value_or(0)});
  const bool moves = lies_elsewhere(one);
  std::string out;
  for (const auto& [key, column] : step_columns)
    if (one.keys.contains(key))
      out += fmt::format("{}{}", out.empty() ? "" : ",", column);
  out += moves ? ",x\n" : "\n";
  for (const ContactCase::Step& step : steps) {
    std::string line;
    for (const auto& [key, column] : step_columns)
      if (one.keys.contains(key))
        line += fmt::format("{}{}", line.empty() ? "" : ",", step.keys.at(key));
    out += line + (moves ? fmt::format(",{:.12g}\n", one.grid->sign() * (step.gap_x - one.grid->x)) : "\n");
  }
  return out;
}

} // namespace bem_contact::app::from_contact
