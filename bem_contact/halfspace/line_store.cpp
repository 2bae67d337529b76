#include "bem_contact/halfspace/line_store.hpp"

#include "bem_contact/halfspace/element_line.hpp"

namespace bem_contact::halfspace {

namespace {

/// 1. Numbers in the lines that are kept: 16 MB, or 5,000 lines of 40 offsets (a case by influence files has
/// about a hundred). When there are more, all go. Chosen.
constexpr int most_line_values = 2000000;

} // namespace

LineStore::Line LineStore::get(const Material& material, double s, double dx, double ds,
                               std::size_t offsets) {
  if (9 * offsets * kept_.size() >= std::size_t(most_line_values))
    kept_.clear();
  std::vector<double>& values = kept_[{material.shear_modulus, material.poisson, s, dx, ds}];
  if (values.size() < 9 * offsets) {
    std::vector<Matrix3> line(offsets);
    averaged_line(material, s, dx, ds, line);
    values.resize(9 * offsets);
    for (std::size_t e = 0; e < 9; ++e)
      for (std::size_t m = 0; m < offsets; ++m)
        values[e * offsets + m] = line[m][e / 3][e % 3];
  }
  return {values.data(), values.size() / 9};
}

} // namespace bem_contact::halfspace
