#pragma once

/// Tuned numbers: limits, tolerances and sizes that somebody chose, and that could be chosen otherwise.
///
/// A room is a folder of bem_contact, such as contact or geometry. The numbers of a room that change results,
/// or what they cost, and those that several sources use stand in its settings.hpp, one entry each. A
/// rounding floor, or a limit that hardly anything reaches, stands at its only use, with the same comment.
///
///     /// mm. Two minima with a lower barrier between them are one: a load closes a thousand times as much.
///     BEM_CONTACT_TUNED(double, flat_distance, 2e-5);
///
/// The comment gives the unit first ("1" for a pure number) and then the reason: the source, or the
/// measurement that set the number. In a normal build an entry is a constexpr. In a build with the CMake
/// option CONFORMAL_TUNABLE an environment variable replaces the value of one entry when the program starts:
///
///     CONFORMAL_TUNED="contact/settings.hpp:flat_distance=1e-5" bem_contact solve ...
///
/// tools/benchmarks/sensitivity uses that to halve and double each of them.
///
/// Where numbers must keep a relation, BEM_CONTACT_RELATION(finest <= coarsest) beside them says so: a normal
/// build in which it does not hold does not compile.
#ifdef CONFORMAL_TUNABLE

namespace bem_contact {

/// `value`, unless CONFORMAL_TUNED replaces it: what stands before its "=" must be the end of "file:name".
/// `file` is the path of the settings as __FILE__ has it. A replaced value is told on the error output; if
/// nothing is told, no entry fits and the variable has no effect.
/// Throws std::invalid_argument, which ends the program before main(), if no number follows the "=".
double tuned(const char* file, const char* name, double value);

} // namespace bem_contact

#define BEM_CONTACT_TUNED(Type, name, value)                                                                 \
  inline const Type name = static_cast<Type>(::bem_contact::tuned(__FILE__, #name, value))
#define BEM_CONTACT_RELATION(holds) static_assert(true)

#else

#define BEM_CONTACT_TUNED(Type, name, value) inline constexpr Type name = value
#define BEM_CONTACT_RELATION(holds) static_assert(holds)

#endif
