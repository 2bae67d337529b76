#include "bem_contact/influence/stress_kernel.hpp"

#include "bem_contact/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace bem_contact {

StressForm::Place StressForm::place_of(std::size_t depth) const {
  Place out;
  for (std::size_t d = 0; d < depth; ++d) {
    const auto l = static_cast<std::size_t>(left_rank[d]), r = static_cast<std::size_t>(right_rank[d]);
    out.left += l;
    out.right += r;
    out.core += l * r;
  }
  return out;
}

std::size_t StressForm::left_columns() const {
  return place_of(left_rank.size()).left;
}
std::size_t StressForm::right_columns() const {
  return place_of(left_rank.size()).right;
}
std::size_t StressForm::core_size() const {
  return place_of(left_rank.size()).core;
}

namespace {

[[noreturn]] void refuse(const std::string& why) {
  throw InputError("The stresses of this influence file are not valid", why, "Compute the file again.");
}

template <class Number> bool all_finite(const std::vector<Number>& values) {
  return std::ranges::all_of(values, [](Number v) { return std::isfinite(v); });
}

bool ascends(const std::vector<double>& values, double above) {
  return all_finite(values) && (values.empty() || values.front() > above) &&
         std::ranges::adjacent_find(values, std::ranges::greater_equal()) == values.end();
}

void validate(const StressForm& form, const StressKernel& kernel, std::size_t stations) {
  if (form.wavenumber.empty() && form.left_rank.empty())
    return;
  if (!ascends(form.wavenumber, -1) || form.wavenumber.front() != 0)
    refuse("wavenumbers do not ascend from 0");
  const auto fit = [&](const std::vector<int>& ranks, std::size_t most) {
    return ranks.size() == kernel.depths.size() &&
           std::ranges::all_of(ranks, [&](int r) { return r >= 0 && static_cast<std::size_t>(r) <= most; });
  };
  if (!fit(form.left_rank, 6 * kernel.places.size()) || !fit(form.right_rank, 3 * stations))
    refuse("the numbers of columns do not fit its depths");
  if (form.left.size() != form.left_columns() * 6 * kernel.places.size() ||
      form.right.size() != form.right_columns() * 3 * stations ||
      form.core.size() != form.wavenumber.size() * form.core_size())
    refuse("the columns do not fit its places, stations and wavenumbers");
  if (!all_finite(form.left) || !all_finite(form.right) || !all_finite(form.core))
    refuse("a number is not finite");
}

} // namespace

void validate(const StressKernel& kernel, std::size_t stations) {
  if (kernel.empty())
    return;
  std::vector<double> s;
  for (const ContactRow& place : kernel.places) {
    s.push_back(place.s);
    if (!std::isfinite(place.position.y + place.position.z + place.delta))
      refuse("a place is not finite");
  }
  if (s.size() < 2 || !ascends(s, -1e9) || !ascends(kernel.depths, 0))
    refuse("places or depths do not ascend");
  if (kernel.there.size() != s.size() * kernel.depths.size())
    refuse("it does not say of each point whether the body is there");
  if (kernel.remainder.wavenumber.size() < 2)
    refuse("it has no wavenumbers");
  validate(kernel.remainder, kernel, stations);
  validate(kernel.error, kernel, stations);
}

} // namespace bem_contact
