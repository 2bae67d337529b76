#pragma once

#include "bem_contact/base/error.hpp"

#include <string>

/// The message of the InputError that `action` throws; "no error" where it throws none.
template <class Action> std::string message_of(Action&& action) {
  try {
    action();
  } catch (const bem_contact::InputError& error) {
    return error.what();
  }
  return "no error";
}

/// The message of the Error that `action` throws although its input is right; "no error" where it throws
/// none.
template <class Action> std::string fault_of(Action&& action) {
  try {
    action();
  } catch (const bem_contact::InputError& error) {
    return std::string("wrong input: ") + error.what();
  } catch (const bem_contact::Error& error) {
    return error.what();
  }
  return "no error";
}
