#pragma once

#include "bem_contact/influence/influence_function.hpp"

#include <array>
#include <optional>

namespace bem_contact {

/// Holds six numbers along and about x, y, z of the section: a small rigid motion (mm; rad), or a force and a
/// moment (N; N mm).
using SixNumbers = std::array<double, 6>;
/// [m][m']; row-major.
using SixBySix = std::array<SixNumbers, 6>;

/// How a body gives way as a whole around x = 0 of its strip: the motion m of the strip about `point` (of the
/// section, mm) under a unit force or moment m' at that point; mm/N, 1/N, 1/(N mm). Symmetric by Maxwell and
/// Betti, and zero where a motion along the section meets one across it.
///
/// It is of the structural part of the kernel alone, remote^T remote_self^-1 remote: of what `removed` takes
/// away. The motion is the rigid one nearest to the displacements of that part in the mean over the strip and
/// structure_length along x; the force is spread in the way that makes the matrix symmetric. x of a body of
/// revolution is the arc at the radius of `point`.
///
/// Nothing for a function that does not hold the structural part (a table), nor where it is for plane strain
/// alone. Throws InputError where remote_self is not positive definite.
std::optional<SixBySix> structural_compliance(const InfluenceStrip& strip, Point2 point);

/// matrix^-1, symmetric; nothing where it is singular (a body that does not give way).
std::optional<SixBySix> inverse(const SixBySix& matrix);

SixNumbers product(const SixBySix& matrix, const SixNumbers& vector);

} // namespace bem_contact
