#include "bem_contact/base/conventions.hpp"
#include "bem_contact/base/counted.hpp"
#include "bem_contact/record/error_text.hpp"
#include "bem_contact/record/found_parts.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

/// What is found in one contact, in several models of it, and in both contacts of a wheelset.
namespace bem_contact::record {

namespace {

/// rad. On a 60E1 the arc of radius 13 mm begins at this inclination.
constexpr double gauge_corner = 0.23;
/// rad. The flank of a flange is steeper than 60 degrees (EN 13715: 70).
constexpr double flange = 1.05;

/// Where on the rail a surface of this inclination lies. delta: in the frame of the wheel's side, < 0 towards
/// the gauge.
std::string place_of(double delta) {
  const char* name = delta > gauge_corner    ? "the field side of the rail"
                     : delta > -gauge_corner ? "the top of the rail"
                     : delta > -flange       ? "the gauge corner"
                                             : "the flank of the flange";
  const double steep = std::round(degrees(std::abs(delta)));
  return fmt::format("{} ({:.0f} {} steep)", name, steep, steep == 1 ? "degree" : "degrees");
}

/// "in one place, the gauge corner (31 degrees steep)"; the share of each of several.
std::string places_text(const Record& result) {
  const std::span<const double> forces = values_at(result, "patches/Fn"),
                                delta = values_at(result, "patches/delta");
  if (forces.size() == 1)
    return "at " + place_of(delta[0]);
  double sum = 0;
  for (const double force : forces)
    sum += force;
  std::string out = fmt::format("in {} places:", forces.size());
  for (std::size_t i = 0; i < forces.size(); ++i)
    out += fmt::format("{} {:.0f} % of the normal force at {}", i == 0 ? "" : ",", 100 * forces[i] / sum,
                       place_of(delta[i]));
  return out;
}

bool has_bodies(const Record& result) {
  return stated_at(result, "patches/wheel_y").has_value();
}

/// What makes numbers useless comes first.
void add_uncertified(Found& found, const Record& result, const std::string& whose) {
  if (!flag_at(result, "certified").value_or(true))
    found.sentences.push_back(
        fmt::format("{} no solution: {}. Do not use its numbers.", whose,
                    text_at(result, "why_not_certified").value_or("a contact condition is violated")));
}

/// "Friction dissipates 182.4 +- 1.8 N (T-gamma), and 34 % of the contact adheres."
std::string friction_text(const Record& result) {
  if (const auto friction = number_at(result, "friction"); friction && *friction == 0)
    return "There is no friction.";
  const std::string power = said(result, "quantities/T_gamma");
  const auto adhesion = stated_at(result, "quantities/adhesion_share");
  if (power.empty() || !adhesion)
    return "";
  return fmt::format("Friction dissipates {} (T-gamma), and {} % of the area in contact adheres.", power,
                     rounded(100 * adhesion->value, 100 * adhesion->error));
}

std::string forces_text(const Record& result) {
  const std::string lateral = said(result, "quantities/lateral");
  const auto force = [&](const char* name) { return said(result, std::string("quantities/") + name); };
  return fmt::format("On the rail act Fx {}, Fy {} and Fz {}{}.", force("Fx"), force("Fy"), force("Fz"),
                     lateral.empty() ? ""
                                     : fmt::format(", where the wheelset stands {} to the right", lateral));
}

constexpr double least_shown = 5e-4; // 1: less prints as 0.0 %

/// " (fem less this -1.3 %)": as the table of the comparison has it; "" where that is nothing, or no share.
std::string difference_text(const Record& set, const std::string& model, const std::string& reference,
                            const char* quantity) {
  const auto difference = number_at(set, fmt::format("difference/{}/{}", model, quantity));
  return difference && std::abs(*difference) >= least_shown
             ? fmt::format(" ({} less this: {:+.1f} %)", reference, 100 * *difference)
             : "";
}

/// "The largest pressure is 1861 +- 19 MPa by fem, 1885 +- 38 MPa by halfspace (fem less this: -1.3 %)": the
/// reference first. `shares`: whether the differences are shares of the value.
std::string models_text(const Record& set, const std::vector<std::string>& models, const char* quantity,
                        const char* words, bool shares = true) {
  std::string out;
  for (const std::string& model : models) {
    const std::string value = said(set, fmt::format("{}/quantities/{}", model, quantity));
    if (!value.empty())
      out += fmt::format("{} {} by {}{}", out.empty() ? fmt::format("{} is", words) : ",", value, model,
                         shares ? difference_text(set, model, models.front(), quantity) : "");
  }
  return out.empty() ? "" : out + ".";
}

std::string wheel_text(const Record& wheel) {
  const Record& result = part(wheel, "result");
  if (values_at(result, "patches/Fn").empty())
    return "does not touch";
  return fmt::format("touches {}, with a largest pressure of {}", places_text(result),
                     said(wheel, "track/pmax"));
}

std::string shares_text(const Record& answer) {
  const auto of = [&](const char* side, const char* name) {
    return number_at(answer, fmt::format("{}/track/{}", side, name)).value_or(0);
  };
  return fmt::format(
      "The right wheel bears {:.0f} % of the load; Y/Q is {:.2f} on the right and {:.2f} on the left.",
      100 * of("right", "share"), of("right", "Y_over_Q"), of("left", "Y_over_Q"));
}

} // namespace

Found of_result(const Record& r) {
  Found found;
  add_uncertified(found, r, "This is");
  const std::span<const double> patches = values_at(r, "patches/Fn");
  if (patches.empty()) {
    found.sentences.emplace_back("Nothing is in contact: all forces are zero.");
    return found;
  }
  found.sentences.push_back(has_bodies(r)
                                ? fmt::format("The wheel touches the rail {}.", places_text(r))
                                : fmt::format("The bodies touch in {}.",
                                              counted(std::ptrdiff_t(patches.size()), "patch", "patches")));
  found.sentences.push_back(fmt::format("The largest pressure is {}, and {} are in contact.",
                                        said(r, "quantities/pmax"), said(r, "quantities/area")));
  add_if(found.sentences, friction_text(r));
  found.sentences.push_back(forces_text(r));
  if (has_bodies(r))
    found.next.push_back(question(r, "Would finite elements say the same?", "compare"));
  found.next.push_back(question(r, "Does the steel below yield?", "shakedown"));
  if (has_bodies(r) && number_at(r, "friction").value_or(0) > 0)
    found.next.push_back(question(r, "What wears away?", "wear"));
  return found;
}

Found of_comparison(const Record& r) {
  Found found;
  const bool forces = has(r, "at_equal_forces/difference");
  const Record& set = part(r, forces ? "at_equal_forces" : "at_equal_position");
  std::vector<std::string> models{std::string(text_at(r, "reference").value_or(""))};
  for (const Entry& entry : set.entries())
    if (entry.name != "difference" && entry.name != models.front())
      models.push_back(entry.name);
  for (const std::string& model : models)
    add_uncertified(found, part(set, model), model + " is");
  const std::string where =
      forces ? "At equal forces the largest pressure" : "At equal position the largest pressure";
  add_if(found.sentences, models_text(set, models, "pmax", where.c_str()));
  add_if(found.sentences, models_text(set, models, "area", "The area in contact"));
  add_if(found.sentences, models_text(set, models, "T_gamma", "The work of friction (T-gamma)"));
  add_if(found.sentences,
         models_text(set, models, "free_rolling_radius", "The rolling radius of free rolling", false));
  found.next.push_back(question(r, "What happens as a key varies?", "sweep"));
  found.next.push_back(question(r, "Does the steel below yield?", "shakedown"));
  return found;
}

Found of_wheelset(const Record& r) {
  Found found;
  for (const char* side : {"right", "left"})
    add_uncertified(found, part(part(r, side), "result"), fmt::format("The {} wheel's contact is", side));
  found.sentences.push_back(fmt::format("The right wheel {}.", wheel_text(part(r, "right"))));
  found.sentences.push_back(fmt::format("The left wheel {}.", wheel_text(part(r, "left"))));
  const std::string radius = said(r, "wheelset/rolling_radius");
  found.sentences.push_back(
      fmt::format("The wheelset stands {} to the right{}.", said(r, "wheelset/lateral"),
                  radius.empty() ? "" : fmt::format(" and rolls on a radius of {}", radius)));
  found.sentences.push_back(shares_text(r));
  found.sentences.push_back(fmt::format("Friction dissipates {} on the right and {} on the left (T-gamma).",
                                        said(r, "right/track/T_gamma"), said(r, "left/track/T_gamma")));
  found.next.push_back(question(r, "What wears away?", "wear"));
  found.next.push_back(question(r, "How does the wheelset steer itself?", "conicity"));
  found.next.push_back(question(r, "All of it at once, as a page?", "study"));
  return found;
}

} // namespace bem_contact::record
