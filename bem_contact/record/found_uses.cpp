#include "bem_contact/base/counted.hpp"
#include "bem_contact/record/error_text.hpp"
#include "bem_contact/record/found.hpp"
#include "bem_contact/record/found_parts.hpp"
#include "bem_contact/record/outcome.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>

/// What is found in what follows from contacts.
namespace bem_contact::record {

namespace {

/// mm, the amplitude of EN 15302.
constexpr double rated_by_standard = 3;

double count_at(const Record& r, const char* name) {
  return number_at(r, name).value_or(0);
}

/// "21 of 22 cases are certified; refused: 1."
std::string cases_text(const Record& r) {
  std::array<std::size_t, outcomes_of_cases> counts{};
  for (std::size_t k = 0; k < counts.size(); ++k)
    counts[k] = static_cast<std::size_t>(count_at(r, count_name(static_cast<Outcome>(k)).c_str()));
  return counts_text(counts);
}

/// A number with its unit, or the text for which it stands.
std::string text_at(const Field& field, std::size_t at) {
  const double value = field.values[at];
  return value >= 0 && value < static_cast<double>(field.choices.size())
             ? fmt::format("'{}'", field.choices[static_cast<std::size_t>(value)])
             : text_of({value, std::nan(""), field.unit});
}

/// "position.lateral 5 mm (case 3)": keys that were swept over have a dot. Of more than two only the case's
/// number.
std::string case_text(const Record& r, std::size_t at) {
  constexpr int most_keys = 2;
  std::string out;
  int keys = 0;
  for (const Entry& entry : r.entries())
    if (const auto* field = std::get_if<Field>(&entry.content);
        field && entry.name.find('.') != std::string::npos && at < field->values.size() &&
        ++keys <= most_keys)
      out += fmt::format("{}{} {}", out.empty() ? "" : ", ", entry.name, text_at(*field, at));
  return keys == 0 || keys > most_keys ? fmt::format("case {}", at) : fmt::format("{} (case {})", out, at);
}

/// From the smallest to the largest of a column, and where it is largest.
std::string range_text(const Record& r, const char* path, const std::string& words) {
  const auto least = smallest_of(r, path), most = largest_of(r, path);
  if (!least || !most)
    return "";
  const auto low = *stated_at(r, path, *least), high = *stated_at(r, path, *most);
  if (text_of(low) == text_of(high)) // as they are shown
    return fmt::format("{} is {} in all cases.", words, text_of(high));
  return fmt::format("{} goes from {} to {}; it is largest at {}.", words, text_of(low), text_of(high),
                     case_text(r, *most));
}

/// What the sentences of a sweep tell the range of.
struct RangeOfSweep {
  const char *name, *words;
  bool wheelset;
};
constexpr RangeOfSweep ranges_of_sweeps[] = {
    {"pmax", "The largest pressure", false},
    {"T_gamma", "The work of friction (T-gamma)", false},
    {"Fy", "The lateral force Fy", false},
    {"right_pmax", "The largest pressure of the right wheel", true},
    {"left_pmax", "That of the left wheel", true},
    {"right_T_gamma", "The work of friction (T-gamma) of the right wheel", true},
    {"left_T_gamma", "That of the left wheel", true}};

/// How far the wheel's centre moves down as it goes along the track.
std::string passage_text(const Record& r) {
  const auto least = smallest_of(r, "vertical"), most = largest_of(r, "vertical");
  if (!has(r, "position.along") || !least || !most)
    return "";
  const double lowest = stated_at(r, "vertical", *most)->value,
               highest = stated_at(r, "vertical", *least)->value;
  return fmt::format("Along the track the wheel's centre dips by {} mm, and is lowest at {}.",
                     rounded(lowest - highest, std::nan("")), case_text(r, *most));
}

/// What is worn off by one contact: `of` "The right wheel" ...
std::string rates_text(const Record& rates, const std::string& side) {
  return fmt::format(
      "At its deepest place the {}wheel loses {} by kilometre, and its rail {} by a million gross tonnes.",
      side.empty() ? "" : side + " ", said(rates, "wheel_depth_per_km"), said(rates, "rail_depth_per_mgt"));
}

/// How many sentences a study takes of a part: the first ones.
struct PartOfStudy {
  const char* name;
  std::size_t sentences;
};
constexpr PartOfStudy parts_of_study[] = {
    {"wheelset", 2}, {"solve", 2},   {"fatigue", 1}, {"shakedown", 1},    {"wear", 1},
    {"conicity", 1}, {"compare", 1}, {"sweep", 2},   {"creep_curves", 1}, {"table", 1}};
constexpr std::size_t most_of_study = 5; // sentences, besides those about parts that failed

} // namespace

bool is_found_in_sweep(const std::string& name) {
  const bool swept = name.find('.') != name.npos && name.find('/') == name.npos;
  return swept || is_of_replay(name) || name == "status" || name == "vertical" ||
         name == error_name("vertical") || (name.ends_with("_count") && name != "warning_count") ||
         std::ranges::any_of(ranges_of_sweeps, [&](const RangeOfSweep& range) {
           return name == range.name || name == error_name(range.name);
         });
}

Found of_sweep(const Record& r) {
  Found found{{cases_text(r)}, {}};
  if (is_replay(r)) {
    std::vector<std::string> of_replay = sentences_of_replay(r);
    of_replay.back() += " " + cases_text(r);
    found.sentences = std::move(of_replay);
  }
  const bool wheelsets = has(r, "right_pmax");
  for (const RangeOfSweep& range : ranges_of_sweeps)
    if (range.wheelset == wheelsets)
      add_if(found.sentences, range_text(r, range.name, range.words));
  add_if(found.sentences, passage_text(r));
  found.next = {question(r, "Do cracks begin under these loads?", "fatigue"),
                question(r, "What becomes of the profiles?", "wear")};
  if (is_replay(r)) // those take the cases of [sweep]
    found.next = {{"How do the forces go over time?", "bem_contact report R.h5 -o R.html"},
                  question(r, "Which forces can the vehicle program look up instead?", "table")};
  return found;
}

Found of_creep_curves(const Record& r) {
  Found found{{fmt::format("With {} down, friction can carry {} at most.", said(r, "Fz"), said(r, "bound"))},
              {}};
  constexpr double small = 1e-3; // creepage: a tenth of a per cent
  const auto slope = [&](const char* matrix, std::size_t at) {
    const auto found_slope = stated_at(r, matrix, at);
    return found_slope ? rounded(small * found_slope->value, small * found_slope->error) + " N"
                       : std::string("-");
  };
  found.sentences.push_back(fmt::format("Where nothing slides yet, 0.1 % of longitudinal creepage changes Fx "
                                        "by {}, and 0.1 % of lateral creepage Fs by {}.",
                                        slope("slopes", 0), slope("slopes", 4)));
  found.sentences.push_back(fmt::format("At the scene's own creepages they do it by {} and {}.",
                                        slope("sensitivities", 0), slope("sensitivities", 4)));
  if (!flag_at(r, "certified").value_or(true))
    found.sentences.insert(found.sentences.begin(), "Not all points are solutions: do not use those.");
  found.next = {question(r, "How does a vehicle model look forces up?", "table"),
                question(r, "Which part of the load does each wheel bear?", "wheelset")};
  return found;
}

Found of_conicity(const Record& r) {
  const std::span<const double> amplitude = values_at(r, "conicity/amplitude");
  Found found;
  const auto at =
      std::ranges::find_if(amplitude, [](double a) { return std::abs(a - rated_by_standard) < 1e-9; });
  const auto tan_gamma = stated_at(r, "conicity/tan_gamma", std::size_t(at - amplitude.begin()));
  if (tan_gamma) {
    const double metres = 1e-3 * values_at(r, "conicity/wavelength")[std::size_t(at - amplitude.begin())];
    found.sentences.push_back(
        fmt::format("The equivalent conicity at 3 mm is {:.3f} (EN 15302): the wheelset swings "
                    "with a wavelength of {:.1f} m.",
                    tan_gamma->value, metres));
  } else
    found.sentences.emplace_back(
        "No motion has the amplitude of 3 mm at which EN 15302 asks for the conicity.");
  if (const auto slope = stated_at(r, "nonlinearity"))
    found.sentences.push_back(fmt::format("It {} with the amplitude (nonlinearity {}).",
                                          slope->value < 0 ? "falls" : "grows", text_of(*slope)));
  if (const std::string play = said(r, "play"); !play.empty())
    found.sentences.push_back(fmt::format("The play between the flanges and the rails is {}.", play));
  found.next = {question(r, "Where does it stand in a curve, and what does each wheel bear?", "wheelset")};
  return found;
}

Found of_conicity_map(const Record& r) {
  const auto count = std::ptrdiff_t(values_at(r, "map/tan_gamma").size());
  Found found{{counted(count, "wheelset was", "wheelsets were") + " looked at."}, {}};
  const auto least = smallest_of(r, "map/tan_gamma"), most = largest_of(r, "map/tan_gamma");
  if (least && most) {
    const std::span<const double> conicities = values_at(r, "map/tan_gamma");
    found.sentences.push_back(count == 1
                                  ? fmt::format("The equivalent conicity at {} is {:.3f}.",
                                                said(r, "amplitude"), conicities[*least])
                                  : fmt::format("Their equivalent conicity at {} goes from {:.3f} to {:.3f}.",
                                                said(r, "amplitude"), conicities[*least], conicities[*most]));
  }
  if (const auto play = smallest_of(r, "map/play"))
    found.sentences.push_back(
        fmt::format("The least play is {}.", text_of(*stated_at(r, "map/play", *play))));
  if (const auto spread = largest_of(r, "map/tan_gamma_spread"))
    found.sentences.push_back(
        fmt::format("The scatter of the profiles moves it by {:.3f} at most (standard deviation).",
                    values_at(r, "map/tan_gamma_spread")[*spread]));
  found.next = {question(r, "What do both wheels bear on such profiles?", "wheelset")};
  return found;
}

Found of_table(const Record& r) {
  Found found{{fmt::format("The table has {} points, for which {} contacts were solved.",
                           count_at(r, "points"), count_at(r, "solved"))},
              {}};
  const Record& columns = part(r, "columns"); // of JSON; files have a group for each kind of error
  double worst = 0;
  std::string of;
  for (const Entry& entry : (columns.empty() ? part(r, "scale") : columns).entries()) {
    const auto number = [&](const char* kind) {
      return columns.empty() ? number_at(r, fmt::format("{}/{}", kind, entry.name))
                             : number_at(columns, fmt::format("{}/{}", entry.name, kind));
    };
    const double error = number("interpolation_error").value_or(0), scale = number("scale").value_or(0);
    if (error > worst * scale) {
      worst = error / scale;
      of = entry.name;
    }
  }
  if (!of.empty())
    found.sentences.push_back(fmt::format(
        "Between them it is at most {:.1f} % of a column's scale off a solution (of {}).", 100 * worst, of));
  found.sentences.push_back(fmt::format("{:.3g} % was asked for.", 100 * count_at(r, "tolerance")));
  found.next = {{"How is it read? data/tutorial/table.md says it for C, Fortran, Python and Matlab."}};
  return found;
}

Found of_wear(const Record& r) {
  const std::span<const double> mileage = values_at(r, "mileage");
  if (mileage.empty())
    return {};
  const std::size_t last = mileage.size() - 1;
  const auto at = [&](const char* name) {
    const auto number = stated_at(r, name, last);
    return number ? text_of(*number) : std::string("nothing");
  };
  Found found{{fmt::format("After {} the rail has lost {} at its deepest place, and the wheel {}.",
                           at("mileage"), at("rail_depth"), at("wheel_depth")),
               fmt::format("{} of the rail's section are gone, and {} of the wheel's.", at("rail_area"),
                           at("wheel_area")),
               fmt::format("This was computed in {}.", counted(std::ptrdiff_t(last), "step", "steps"))},
              {}};
  if (const auto most = largest_of(r, "stretch/depth")) { // along the track
    found.sentences[0] += " Along the rail that is at " + text_of(*stated_at(r, "stretch/at", *most)) + ".";
    found.next = {{"What does the next wheel do there?", "bem_contact sweep scene_NNNN.toml -o S.h5"}};
    return found;
  }
  found.next = {{"Where do the worn profiles touch? Give rail_NNNN.txt and wheel_NNNN.txt to bem_contact new "
                 "or profile."}};
  return found;
}

Found of_contact_wear(const Record& r) {
  Found found;
  if (has(r, "wheel_depth_per_km"))
    found.sentences.push_back(rates_text(r, ""));
  for (const char* side : {"right", "left"})
    if (has(r, side))
      found.sentences.push_back(rates_text(part(r, side), side));
  found.sentences.emplace_back("That is the rate of these profiles: as they wear, it changes.");
  found.next = {question(r, "What becomes of the profiles? (add [sweep])", "wear")};
  return found;
}

Found of_study(const Record& r) {
  Found found;
  const Record& parts = part(r, "parts");
  for (const Entry& entry : parts.entries()) {
    const Record& one = part(parts, entry.name);
    const std::span<const double> code = values_at(one, "study_code");
    if (number_at(one, "study_code").value_or(code.empty() ? 0 : code[0]) != 0)
      found.sentences.push_back(fmt::format("{} is {}: its part below says why.",
                                            text_at(one, "study_title").value_or(entry.name),
                                            text_at(one, "study_status").value_or("missing")));
  }
  const std::size_t failed = found.sentences.size();
  for (const auto& [name, count] : parts_of_study) {
    const Found of = found_in(part(parts, name));
    for (std::size_t i = 0; i < std::min(count, of.sentences.size()); ++i)
      if (found.sentences.size() < failed + most_of_study)
        found.sentences.push_back(of.sentences[i]);
  }
  if (failed > 0)
    found.next.push_back(question(r, "Is the scene what I mean?", "check"));
  found.next.push_back(
      {"What does the scatter of the inputs do to these numbers? Add [uncertainty] to the scene."});
  found.next.push_back(question(r, "What if I move something?", "explore"));
  return found;
}

} // namespace bem_contact::record
