#pragma once

#include "bem_contact/contact/solve.hpp"
#include "bem_contact/scene/sweep_file.hpp"

#include <cstddef>
#include <vector>

namespace cases {

/// What a case is compared with: the same on elements `finer` times as short and narrow as those chosen for
/// grid.accuracy = 2 %.
struct Reference {
  int finer = 0; ///< how many times shorter its elements are along x; 0: there is none
  double Fx = 0, Fs = 0, Fy = 0, approach = 0, load = 0, friction = 0;
};

/// Of every `every`th case. `by`: the same cases, perhaps with the influence files of finer stations and
/// shorter elements; it is solved. Where its files have no numbers for elements so short, longer ones are
/// taken; stderr says how many cases have which reference.
std::vector<Reference> references(const bem_contact::SweepFile& sweep, const bem_contact::SweepFile& by,
                                  int finer = 4, std::size_t every = 1);

/// The largest of the errors of the approach (relative), of the shear force over mu Fz, and of Fy over Fz.
double error_of(const bem_contact::ContactResult& result, const Reference& exact);

} // namespace cases
