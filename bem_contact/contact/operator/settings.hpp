#pragma once

#include "bem_contact/base/tuned.hpp"

/// Tuned numbers of contact/operator. For the words see contact/settings.hpp.
namespace bem_contact::contact {

/// Rows whose spectra are made at once, where numbers are not translational: two cache lines. All 140 rows of
/// a large contact at once took three times the memory, and half of the time went into its pages.
BEM_CONTACT_TUNED(int, spectra_rows, 16);
/// 1. The period of the preconditioner, in x and in s, is that of the grid times 1 + 1 / this. Of 3 to 20, 5
/// takes the fewest instructions: 2 to 3 % fewer than 3 in sequences.
BEM_CONTACT_TUNED(int, periodic_margin, 5);
/// Elements. The period has so many elements on top of periodic_margin, for small grids. Chosen.
BEM_CONTACT_TUNED(int, periodic_elements, 4);
/// 1. Eigenvalues of the preconditioner are at least this share of the largest: the ripples of the truncated
/// kernel must not change a sign. Chosen.
BEM_CONTACT_TUNED(float, least_eigenvalue, 1e-4f);
/// Elements. Products, spectra and sums over fewer stay on one thread. Threads are for contacts of some 5,000
/// elements and more (tools/BENCHMARKS.md, section 10). With 2,056 in contact a second thread gained nothing
/// (section 2).
BEM_CONTACT_TUNED(int, least_threaded, 5000);
/// Transforms of different shapes that are kept. Chosen: a sequence meets fewer.
BEM_CONTACT_TUNED(int, most_transforms, 32);
/// ns. Time of a complex transform for each value, if FFTW is quick for the length (multiples of 16), and if
/// not: measured in single precision on AVX2.
BEM_CONTACT_TUNED(double, quick_transform, 0.8);
BEM_CONTACT_TUNED(double, slow_transform, 2.0);
/// Steps of the power iteration for the norm of an operator, and the margin on its result: its largest
/// eigenvalue stands clear of the others, so that 20 steps are within 20 %. Chosen.
BEM_CONTACT_TUNED(int, power_iterations, 20);
BEM_CONTACT_TUNED(double, norm_margin, 1.2);

} // namespace bem_contact::contact
