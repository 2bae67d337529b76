#include "bem_contact/inside/surface_tractions.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/record/file_kinds.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <span>
#include <string>
#include <utility>

namespace bem_contact::inside {

namespace {

/// 1 (of a row's width). Rows that lie farther from each other belong to two areas.
constexpr double gap_between_areas = 0.2;

std::vector<int> connected_to(int start, const SurfaceTractions& t, std::vector<int>& seen) {
  std::vector<int> elements{start};
  seen[static_cast<std::size_t>(start)] = 1;
  for (std::size_t k = 0; k < elements.size(); ++k) {
    const int ix = elements[k] % t.columns, is = elements[k] / t.columns;
    for (int js = std::max(is - 1, 0); js <= std::min(is + 1, t.rows() - 1); ++js)
      for (int jx = std::max(ix - 1, 0); jx <= std::min(ix + 1, t.columns - 1); ++jx)
        if (const auto next = static_cast<std::size_t>(js * t.columns + jx); !seen[next] && t.pn[next] > 0) {
          seen[next] = 1;
          elements.push_back(static_cast<int>(next));
        }
  }
  return elements;
}

[[noreturn]] void refuse_result(const std::string& why) {
  throw InputError("There are no stresses below this", why, "Give a file that bem_contact solve -o wrote.");
}

std::span<const double> values_of(const record::Record& result, const char* name, std::size_t count) {
  const std::span<const double> values = record::values_at(result, name);
  if (values.empty() || (count != 0 && values.size() != count))
    refuse_result(fmt::format("it has no '{}' of its elements", name));
  return values;
}

/// Rows that are ds apart within each area, about the middle of the area.
std::vector<double> evenly_spaced(std::span<const double> s, double ds) {
  std::vector<double> out(s.begin(), s.end());
  for (std::size_t from = 0; from < s.size();) {
    std::size_t to = from + 1;
    while (to < s.size() && std::abs(s[to] - s[to - 1] - ds) < gap_between_areas * ds)
      ++to;
    const double middle = 0.5 * (s[from] + s[to - 1]);
    for (std::size_t i = from; i < to; ++i)
      out[i] = middle + (double(i - from) - 0.5 * double(to - from - 1)) * ds;
    from = to;
  }
  return out;
}

} // namespace

SurfaceTractions on_upper_body(const SurfaceTractions& rail, std::span<const double> wheel_s,
                               double poisson) {
  SurfaceTractions out = rail;
  out.poisson = poisson;
  const auto rows = static_cast<std::size_t>(rail.rows()), columns = static_cast<std::size_t>(rail.columns);
  std::vector<double> s;
  for (std::size_t row = 0; row < rows; ++row) {
    const std::size_t from = rows - 1 - row;
    s.push_back(wheel_s[from]);
    for (std::size_t c = 0; c < columns; ++c) {
      const std::size_t here = row * columns + c, there = from * columns + c;
      out.px[here] = -rail.px[there];
      out.ps[here] = rail.ps[there];
      out.pn[here] = rail.pn[there];
    }
  }
  for (std::size_t row = 0; row < rows; ++row)
    if (!std::isfinite(s[row])) { // a row without a point opposite bears nothing
      for (std::size_t c = 0; c < columns; ++c)
        if (out.pn[row * columns + c] > 0)
          refuse_result("a row in contact has no point on the wheel's profile");
    }
  while (!s.empty() && !std::isfinite(s.back()))
    s.pop_back();
  const auto first = std::ranges::find_if(s, [](double value) { return std::isfinite(value); });
  const std::size_t cut = static_cast<std::size_t>(first - s.begin()) * columns;
  for (std::vector<double>* field : {&out.px, &out.ps, &out.pn}) {
    field->resize(s.size() * columns);
    field->erase(field->begin(), field->begin() + static_cast<std::ptrdiff_t>(cut));
  }
  s.erase(s.begin(), first);
  if (!std::ranges::all_of(s, [](double value) { return std::isfinite(value); }) ||
      !std::ranges::is_sorted(s))
    refuse_result("the rows have no rising arc length on the wheel's profile");
  out.s = evenly_spaced(s, rail.ds);
  return out;
}

bool SurfaceTractions::has_shear() const {
  const auto any = [](const std::vector<double>& field) {
    return std::ranges::any_of(field, [](double p) { return p != 0; });
  };
  return any(px) || any(ps);
}

std::array<double, 3> SurfaceTractions::force() const {
  std::array<double, 3> sum{};
  for (std::size_t i = 0; i < pn.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      sum[c] += at(i)[c] * dx * ds;
  return sum;
}

std::vector<std::vector<int>> loaded_patches(const SurfaceTractions& tractions) {
  std::vector<std::pair<double, std::vector<int>>> patches;
  std::vector<int> seen(tractions.pn.size(), 0);
  for (std::size_t start = 0; start < seen.size(); ++start) {
    if (seen[start] || !(tractions.pn[start] > 0))
      continue;
    std::vector<int> elements = connected_to(static_cast<int>(start), tractions, seen);
    double force = 0;
    for (const int i : elements)
      force += tractions.pn[static_cast<std::size_t>(i)];
    patches.emplace_back(force, std::move(elements));
  }
  std::ranges::stable_sort(patches, std::greater<>(), &std::pair<double, std::vector<int>>::first);
  std::vector<std::vector<int>> out;
  for (auto& [force, elements] : patches)
    out.push_back(std::move(elements));
  return out;
}

SurfaceTractions read_tractions(const record::Record& result, Side side) {
  if (kind_name(record::text_at(result, "format").value_or("")) != kind_name(result_format))
    refuse_result("it is no result of one scene");
  if (!record::flag_at(result, "certified").value_or(false))
    refuse_result("the result is not certified, so its tractions are no solution");
  SurfaceTractions out;
  const auto number = [&](const std::string& path) {
    const std::optional<double> value = record::number_at(result, path);
    if (!value || !std::isfinite(*value))
      refuse_result(fmt::format("it has no number '{}'", path));
    return *value;
  };
  const std::span<const double> s = values_of(result, "s", 0), x = values_of(result, "x", 0);
  const std::size_t elements = s.size() * x.size();
  out.dx = number("quantities/dx");
  out.ds = number("quantities/ds");
  if (!(out.dx > 0))
    refuse_result("in plane strain nothing passes: its elements are endless along x");
  out.x0 = x.front();
  out.columns = static_cast<int>(x.size());
  out.s.assign(s.begin(), s.end());
  for (const auto& [name, field] : {std::pair{"p_x", &out.px}, {"p_s", &out.ps}, {"p_n", &out.pn}}) {
    const std::span<const double> values = values_of(result, name, elements);
    field->assign(values.begin(), values.end());
  }
  out.poisson = number(fmt::format("materials/{}_poisson", name_of(side)));
  if (side == Side::wheel)
    return on_upper_body(out, values_of(result, "wheel_s", s.size()), out.poisson);
  if (record::has(result, "rail_s")) { // a patch given directly has its own s
    const std::span<const double> own = values_of(result, "rail_s", s.size());
    out.s.assign(own.begin(), own.end());
  }
  return out;
}

Side side_of(const record::Record& result, std::uint64_t profile_digest) {
  const std::string digest = fmt::format("{:016x}", profile_digest);
  const auto rail = record::text_at(result, "geometry/rail"),
             wheel = record::text_at(result, "geometry/wheel");
  if (!rail && !wheel)
    return Side::rail;
  if (rail == digest)
    return Side::rail;
  if (wheel == digest)
    return Side::wheel;
  throw InputError("The body does not belong to this result",
                   "the result has another profile of the rail and another one of the wheel",
                   "Give the body file of one of them.");
}

double traction_error(const record::Record& result) {
  const double pmax = record::number_at(result, "quantities/pmax").value_or(0),
               error = record::number_at(result, "quantities/pmax_error").value_or(0);
  return pmax > 0 && std::isfinite(error) ? error / pmax : 0;
}

} // namespace bem_contact::inside
