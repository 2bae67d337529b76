#include "bem_contact/influence/stress_kernel_file.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/h5/strict.hpp"

#include <cmath>
#include <string>

namespace bem_contact {

namespace {

using strict_h5::Extent;

void write_form(H5Id root, const std::string& name, const StressForm& form, const StressKernel& kernel,
                std::size_t stations) {
  const Extent waves = form.wavenumber.size(), depths = kernel.depths.size();
  const auto write_ranks = [&](const char* side, const std::vector<int>& ranks) {
    const std::vector<double> values(ranks.begin(), ranks.end());
    write(root, strict_h5::Table{(name + side).c_str(), {depths}, values, "1"});
  };
  write(root, strict_h5::Table{(name + "_wavenumber").c_str(), {waves}, form.wavenumber, "1/mm"});
  write_ranks("_left_rank", form.left_rank);
  write_ranks("_right_rank", form.right_rank);
  write(root, strict_h5::FloatTable{
                  (name + "_left").c_str(), {form.left_columns(), kernel.places.size(), 6}, form.left, "1"});
  write(root, strict_h5::FloatTable{
                  (name + "_right").c_str(), {form.right_columns(), 3 * stations}, form.right, "1"});
  write(root,
        strict_h5::FloatTable{(name + "_core").c_str(), {waves, form.core_size()}, form.core, "MPa/MPa"});
}

std::vector<int> read_ranks(H5Id root, const std::string& name, std::size_t depths, std::size_t most) {
  std::vector<int> out;
  for (const double rank : strict_h5::read_table(root, name.c_str(), {depths})) {
    if (!(rank >= 0 && rank <= static_cast<double>(most)) || rank != std::floor(rank))
      throw InputError("The stresses of this influence file are not valid", "a number of columns is none",
                       "Compute the file again.");
    out.push_back(static_cast<int>(rank));
  }
  return out;
}

StressForm read_form(H5Id root, const std::string& name, const StressKernel& kernel, std::size_t stations) {
  StressForm out;
  const std::size_t depths = kernel.depths.size(), count = kernel.places.size();
  out.wavenumber = strict_h5::read_table(root, (name + "_wavenumber").c_str(), {0});
  out.left_rank = read_ranks(root, name + "_left_rank", depths, 6 * count);
  out.right_rank = read_ranks(root, name + "_right_rank", depths, 3 * stations);
  out.left = strict_h5::read_floats(root, (name + "_left").c_str(), {out.left_columns(), count, 6});
  out.right = strict_h5::read_floats(root, (name + "_right").c_str(), {out.right_columns(), 3 * stations});
  out.core = strict_h5::read_floats(root, (name + "_core").c_str(), {out.wavenumber.size(), out.core_size()});
  return out;
}

} // namespace

void write_stress_kernel(H5Id root, const StressKernel& kernel, std::size_t stations) {
  if (kernel.empty())
    return;
  std::vector<double> places;
  for (const ContactRow& place : kernel.places)
    places.insert(places.end(), {place.s, place.position.y, place.position.z, place.delta});
  const Extent count = kernel.places.size(), depths = kernel.depths.size();
  write(root, strict_h5::Table{"stress_places", {count, 4}, places, "mm, mm, mm, rad"});
  write(root, strict_h5::Table{"stress_depths", {depths}, kernel.depths, "mm"});
  const std::vector<double> there(kernel.there.begin(), kernel.there.end());
  write(root, strict_h5::Table{"stress_there", {count, depths}, there, "1"});
  write_form(root, "stress", kernel.remainder, kernel, stations);
  if (!kernel.error.wavenumber.empty())
    write_form(root, "stress_error", kernel.error, kernel, stations);
}

StressKernel read_stress_kernel(H5Id root, std::size_t stations) {
  StressKernel out;
  if (!strict_h5::has(root, "stress_depths"))
    return out;
  out.depths = strict_h5::read_table(root, "stress_depths", {0});
  const std::vector<double> places = strict_h5::read_table(root, "stress_places", {0, 4});
  for (std::size_t i = 0; i < places.size(); i += 4)
    out.places.push_back({places[i], {places[i + 1], places[i + 2]}, places[i + 3]});
  for (const double there :
       strict_h5::read_table(root, "stress_there", {out.places.size(), out.depths.size()}))
    out.there.push_back(there != 0);
  out.remainder = read_form(root, "stress", out, stations);
  if (strict_h5::has(root, "stress_error_wavenumber"))
    out.error = read_form(root, "stress_error", out, stations);
  validate(out, stations);
  return out;
}

} // namespace bem_contact
