#include "bem_contact/app/error_text.hpp"

#include "bem_contact/sequence/quantities.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace bem_contact::app {

using nlohmann::json;

std::string two_digits(double error) {
  if (!(error > 0))
    return "";
  const int decimals = std::clamp(1 - static_cast<int>(std::floor(std::log10(error))), 0, 9);
  return decimals < 7 ? fmt::format("{:.{}f}", error, decimals) : fmt::format("{:.1e}", error);
}

std::string plus_minus(double error) {
  const std::string text = two_digits(error);
  return text.empty() ? "" : " +- " + text;
}

std::string plus_minus(const SceneResult& result, const char* name) {
  const Quantity& number = quantity(name);
  return number.error ? plus_minus(number.error(result)) : "";
}

std::string pressure_text(const SceneResult& r) {
  const auto& estimate = r.result.discretisation;
  std::string out = fmt::format("pmax {:.1f}{} MPa, area {:.4g}{} mm2", largest_pressure(r.result),
                                plus_minus(r, "pmax"), contact_area(r.result), plus_minus(r, "area"));
  if (r.problem.has_friction())
    out += fmt::format(", {:.1f}{} % of it in adhesion", 100 * adhesion_share(r.result),
                       estimate ? plus_minus(100 * estimate->errors.adhesion_share) : "");
  if (estimate && !estimate->converges)
    out +=
        fmt::format("\nno errors: the pressure does not converge with the size of the elements (pmax {:.0f} "
                    "MPa on elements twice as large)",
                    estimate->coarse_pmax);
  return out + "\n";
}

std::string patch_errors_text(const SceneResult& r, std::size_t patch) {
  if (!r.result.discretisation || !r.result.discretisation->converges)
    return "";
  const PatchErrors e = r.result.discretisation->patches.at(patch);
  return fmt::format("{:>5} {:>11} {:>11} {:>11} {:>10} {:>9} {:>9}\n", "+-", two_digits(e.fn),
                     two_digits(e.fx), two_digits(e.fs), two_digits(e.approach), two_digits(e.pmax),
                     two_digits(e.area));
}

void add_errors(const SceneResult& result, json& numbers) {
  for (const Quantity& number : quantities())
    if (number.error && numbers.contains(number.name))
      numbers[error_name(number.name)] = number.error(result);
}

} // namespace bem_contact::app
