#include "bem_contact/record/outcome.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/stopped.hpp"

#include <new>

namespace bem_contact::record {

Outcome outcome_of(const std::exception& error) {
  if (dynamic_cast<const Stopped*>(&error))
    return Outcome::replaced;
  if (dynamic_cast<const InputError*>(&error))
    return Outcome::refused;
  if (dynamic_cast<const ConvergenceError*>(&error))
    return Outcome::not_certified;
  if (dynamic_cast<const std::bad_alloc*>(&error)) // says nothing of the input: more memory may do
    return Outcome::died;
  return Outcome::failed;
}

} // namespace bem_contact::record
