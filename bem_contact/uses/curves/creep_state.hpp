#pragma once

#include "bem_contact/base/enum_names.hpp"
#include "bem_contact/sequence/scene_result.hpp"

#include <array>

namespace bem_contact {

/// The three creepages, in the order of every array here: longitudinal xi and lateral eta (1), spin phi
/// (1/mm). Signs: base/conventions.hpp.
enum class CreepKind { xi, eta, phi };
template <> struct EnumNames<CreepKind> {
  static constexpr std::array<std::string_view, 3> names{"xi", "eta", "phi"};
};

/// The three forces on the rail that they cause: Fx along x (N), Fs along the tangent e_s at the reference
/// point (N), and the moment Mz about the vertical through that point (N mm).
enum class CreepForce { Fx, Fs, Mz };
template <> struct EnumNames<CreepForce> {
  static constexpr std::array<std::string_view, 3> names{"Fx", "Fs", "Mz"};
};

inline constexpr CreepKind creep_kinds[] = {CreepKind::xi, CreepKind::eta, CreepKind::phi};
constexpr std::size_t index(CreepKind kind) {
  return static_cast<std::size_t>(kind);
}

/// Indexed by CreepKind: xi, eta (1) and phi (1/mm).
using Creepages = std::array<double, 3>;
/// Indexed by CreepForce: N, N, N mm.
using CreepForceValues = std::array<double, 3>;
using MeasuredCreepForces = std::array<Measured, 3>; ///< with their stated errors
/// [CreepForce][CreepKind]: derivatives of forces by creepages. Fx, Fs: N, N, N mm; Mz: N mm, N mm, N mm^2.
using CreepMatrix = std::array<std::array<double, 3>, 3>;

/// The forces of a result, with the errors that the size of the elements is estimated to cause.
MeasuredCreepForces forces_of(const SceneResult& result);

/// The same forces on elements twice as large; nan where those have no solution.
CreepForceValues coarse_forces_of(const SceneResult& result);

/// The creepages whose rigid slip is nearest to that of the result, in the mean square over the contact,
/// weighted by the pressure. Those that a scene gives are among them, and those of the geometry.
Creepages rigid_creepages(const SceneResult& result);

} // namespace bem_contact
