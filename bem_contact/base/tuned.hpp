#pragma once

/// Tuned numbers: limits, tolerances and sizes that somebody chose, and that could be chosen otherwise.
///
/// All of a room stand in its settings.hpp, one entry each:
///
///     /// mm. Two minima of the distance that differ by less are elastically one.
///     BEM_CONTACT_TUNED(double, flat_distance, 2e-5);
///
/// The comment gives the unit first ("1" for a pure number) and then the reason: the source, or the
/// measurement that set the number. In a normal build an entry is a constexpr. In a build with
/// CONFORMAL_TUNABLE its value can be replaced when the program starts:
///
///     CONFORMAL_TUNED="contact/settings.hpp:flat_distance=1e-5" bem_contact solve ...
///
/// tools/benchmarks/sensitivity uses that to halve and double each of them.
#ifdef CONFORMAL_TUNABLE

namespace bem_contact {

/// `value`, or what the environment says instead. `file` is the path of the settings, as __FILE__ has it.
double tuned(const char* file, const char* name, double value);

} // namespace bem_contact

#define BEM_CONTACT_TUNED(Type, name, value)                                                                 \
  inline const Type name = static_cast<Type>(::bem_contact::tuned(__FILE__, #name, value))

#else

#define BEM_CONTACT_TUNED(Type, name, value) inline constexpr Type name = value

#endif
