#include "bem_contact/base/counted.hpp"
#include "bem_contact/record/error_text.hpp"
#include "bem_contact/record/found_parts.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fmt/format.h>

/// What is found in what contacts do to the steel: fatigue, shakedown, stresses.
namespace bem_contact::record {

namespace {

/// Whether and where cracks begin, after the shakedown diagram.
std::string cracks_text(const Record& r) {
  const double surface = number_at(r, "beyond_surface_limit").value_or(0),
               below = number_at(r, "beyond_limit_below").value_or(0);
  const auto all = std::ptrdiff_t(values_at(r, "patches/p0_over_k").size());
  if (surface == 0 && below == 0)
    return fmt::format("Cracks: none by shakedown. {} below both limits.",
                       all == 1 ? "The patch is" : fmt::format("All {} patches are", all));
  std::string why;
  if (surface > 0)
    why = fmt::format(
        "{} of {} {} beyond the shakedown limit of the surface (mu used less k/p0 is {} at most, 0 is "
        "the limit)",
        surface, counted(all, "patch", "patches"), surface == 1 ? "is" : "are",
        text_of(*stated_at(r, "patches/FI_surf", *largest_of(r, "patches/FI_surf"))));
  if (below > 0)
    why += fmt::format("{}{} beyond the limit below it", why.empty() ? "" : ", and ",
                       counted(std::ptrdiff_t(below), surface > 0 ? "other is" : "patch is",
                               surface > 0 ? "others are" : "patches are"));
  return fmt::format("Cracks: yes. {}: the steel flows there with every passage.", why);
}

std::string damage_text(const Record& r) {
  const double damage = number_at(r, "damage").value_or(0);
  if (damage > 0)
    return fmt::format("By T-gamma one passage does a damage of {}: a crack begins after {} passages.",
                       rounded(damage, std::nan("")), rounded(1 / damage, std::nan("")));
  const auto most = largest_of(r, "patches/T_gamma");
  return fmt::format(
      "By T-gamma ({} at most) cracks do not grow: it is too small for them, or wear is faster.",
      most ? text_of(*stated_at(r, "patches/T_gamma", *most)) : "none");
}

/// Where along the track the surface suffers most, if the cases are at several places.
std::string worst_place_text(const Record& r) {
  const std::span<const double> along = values_at(r, "patches/along");
  const auto most = largest_of(r, "patches/FI_surf"), damage = largest_of(r, "patches/damage");
  if (along.empty() || !most || !damage || std::ranges::count(along, along[0]) == std::ssize(along))
    return "";
  const auto at = [&](const char* path, std::size_t row) { return text_of(*stated_at(r, path, row)); };
  std::string of_damage;
  if (values_at(r, "patches/damage")[*damage] > 0)
    of_damage = fmt::format(", and the damage by T-gamma is largest at {} ({})", at("patches/along", *damage),
                            at("patches/damage", *damage));
  return fmt::format("Along the track the surface suffers most at {} (FI_surf {}){}.",
                     at("patches/along", *most), at("patches/FI_surf", *most), of_damage);
}

std::string as_sentence(std::string_view words) {
  std::string out(words);
  out.front() = char(std::toupper(static_cast<unsigned char>(out.front())));
  return out + ".";
}

/// What a half-space has in place of the largest von Mises stress in a body; "": it is that of one.
std::string against_halfspace(const Record& r, std::size_t row) {
  const auto flat = stated_at(r, "patches/halfspace_von_mises", row);
  return flat ? fmt::format(" in {} (a half-space has {} there)", text_at(r, "body").value_or("the body"),
                            text_of(*flat))
              : "";
}

} // namespace

Found of_fatigue(const Record& r) {
  Found found{{cracks_text(r)}, {}};
  if (const auto words = text_at(r, "in_words"))
    found.sentences[0] +=
        fmt::format(" In {} the steel {}.", text_at(r, "body").value_or("the body"), *words);
  found.sentences.push_back(damage_text(r));
  add_if(found.sentences, worst_place_text(r));
  if (const auto most = largest_of(r, "patches/von_mises"))
    found.sentences.push_back(fmt::format("The largest von Mises stress is {}, {} deep{}; k is {}.",
                                          text_of(*stated_at(r, "patches/von_mises", *most)),
                                          text_of(*stated_at(r, "patches/von_mises_depth", *most)),
                                          against_halfspace(r, *most), said(r, "yield_shear")));
  found.next = {question(r, "Does the steel below yield never, once or for ever?", "shakedown"),
                question(r, "What wears away?", "wear")};
  return found;
}

Found of_shakedown(const Record& r) {
  Found found;
  if (const auto words = text_at(r, "in_words"))
    found.sentences.push_back(has(r, "cases") ? as_sentence(*words) : fmt::format("The steel {}.", *words));
  else
    found.sentences.emplace_back("No patch has enough elements to tell whether the steel yields.");
  for (const auto& [path, name] :
       {std::pair{"patches/dang_van", "Dang Van"}, {"patches/crossland", "Crossland"}})
    if (const auto most = largest_of(r, path))
      found.sentences.push_back(fmt::format("Below the surface the largest stress of {} is {}, {} deep.",
                                            name, text_of(*stated_at(r, path, *most)),
                                            text_of(*stated_at(r, std::string(path) + "_depth", *most))));
  found.next = {question(r, "Do cracks begin at the surface?", "fatigue")};
  return found;
}

Found of_stresses(const Record& r) {
  const std::string_view body = text_at(r, "body").value_or("");
  Found found;
  for (const auto& [name, title] :
       {std::pair{"von_mises", "stress of von Mises"}, {"largest_shear", "shear stress"}}) {
    const std::string path = std::string("patches/") + name;
    if (const auto most = largest_of(r, path))
      found.sentences.push_back(
          fmt::format("The largest {} is {}, {} deep, in {}.", title, text_of(*stated_at(r, path, *most)),
                      text_of(*stated_at(r, path + "_depth", *most)), body.empty() ? "a half-space" : body));
  }
  if (found.sentences.empty())
    found.sentences.emplace_back("No patch has enough elements to tell its stresses.");
  if (const auto most = largest_of(r, "patches/von_mises"))
    if (const auto change = stated_at(r, "patches/von_mises_change", *most))
      found.sentences.push_back(fmt::format(
          "Against a half-space the body changes that of von Mises by {:+.1f} %.", 100 * change->value));
  found.next.push_back(
      {"Does the steel yield never, once or for ever?", "bem_contact shakedown STRESSES.h5"});
  return found;
}

} // namespace bem_contact::record
