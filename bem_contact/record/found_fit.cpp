#include "bem_contact/record/found_parts.hpp"

#include <cmath>
#include <fmt/format.h>

namespace bem_contact::record {

namespace {

constexpr std::size_t most_sentences = 5; // of any answer

std::string with_unit(double value, const std::string& unit) {
  return fmt::format("{:.3g}", value) + (unit == "1" ? "" : " " + unit);
}

/// "layer.compliance is 0.000152 mm3/N; 95 %: from 0.000131 to 0.000176 mm3/N."
std::string key_text(const std::string& key, const Record& found) {
  const auto value = stated_at(found, "value"), low = stated_at(found, "low"),
             high = stated_at(found, "high");
  if (!value)
    return "";
  const std::string text = fmt::format("{} is {}", key, with_unit(value->value, value->unit));
  return low && high ? fmt::format("{}; in 95 of 100 cases it lies between {:.3g} and {}.", text, low->value,
                                   with_unit(high->value, value->unit))
                     : text + ".";
}

/// "With this the 13 points of Fx over xi are 1.55e+03 N off (root of the mean square)."; "" of other parts.
std::string misfit_text(const Record& measured) {
  const auto misfit = stated_at(measured, "misfit");
  const auto creepage = text_at(measured, "creepage"), over = text_at(measured, "over");
  if (!misfit || !(creepage || over))
    return "";
  return fmt::format("With this the {} points of {} over {} are {:.3g} {} off (root of the mean square).",
                     values_at(measured, "points/measured").size(),
                     text_at(measured, "force").value_or("pressure"), creepage ? *creepage : *over,
                     misfit->value, misfit->unit);
}

} // namespace

Found of_fit(const Record& r) {
  Found found;
  if (!flag_at(r, "certified").value_or(true))
    found.sentences.emplace_back("The search did not end, or not all points are solutions: do not use it.");
  for (const Entry& entry : part(r, "parameters").entries())
    if (const auto* key = std::get_if<Record>(&entry.content))
      add_if(found.sentences, key_text(entry.name, *key));
  for (const Entry& entry : r.entries())
    if (const auto* measured = std::get_if<Record>(&entry.content))
      add_if(found.sentences, misfit_text(*measured));
  const auto creepage = text_at(r, "measured/creepage");
  const auto slope = stated_at(r, "slopes", 0), kalker = stated_at(r, "kalker", 0);
  if (slope && kalker && creepage == "xi")
    found.sentences.push_back(fmt::format("Where nothing slides yet Fx grows with {:.2f} of Kalker's slope.",
                                          slope->value / kalker->value));
  if (const Content* open = find(r, "not_determined"))
    if (const auto* texts = std::get_if<Texts>(open))
      found.sentences.insert(found.sentences.end(), texts->lines.begin(), texts->lines.end());
  if (found.sentences.size() > most_sentences) // "not_determined" has all
    found.sentences.resize(most_sentences);
  found.next = {question(r, "How do the forces grow with the other creepages?", "creep-curves"),
                question(r, "How does a vehicle model look forces up?", "table")};
  return found;
}

} // namespace bem_contact::record
