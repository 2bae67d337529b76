#pragma once

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/said_by.hpp"
#include "bem_contact/base/stopped.hpp"
#include "bem_contact/c/conformal_contact.h"

#include <algorithm>
#include <cstring>
#include <exception>
#include <string>

/// What every function of the C interface does around its work.
namespace bem_contact {

/// The first 1000 characters of an error's text; none where there is no memory for them.
inline void keep_text(const std::exception& error, std::string& message) noexcept {
  try {
    message = said_by(error).substr(0, 1000);
  } catch (const std::exception&) {
    message.clear();
  }
}

/// Calls `action`. Nothing is thrown beyond here: exceptions become codes, and their text the message.
template <class Action> int guarded(std::string& message, const Action& action) noexcept {
  try {
    message.clear();
    action();
    return CONFORMAL_OK;
  } catch (const Stopped& error) {
    keep_text(error, message);
    return CONFORMAL_STOPPED;
  } catch (const ConvergenceError& error) {
    keep_text(error, message);
    return CONFORMAL_NOT_CONVERGED;
  } catch (const InputError& error) {
    keep_text(error, message);
    return CONFORMAL_WRONG_INPUT;
  } catch (const std::exception& error) {
    keep_text(error, message);
    return CONFORMAL_UNFORESEEN;
  } catch (...) {
    return CONFORMAL_UNFORESEEN;
  }
}

inline void require(bool given, const char* what) {
  if (!given)
    throw InputError(std::string(what) + " is missing", "a null pointer was given", "Give its address.");
}

/// `text` as far as there is room.
inline void copy_text(const std::string& text, char* to, int size) {
  if (!to || size <= 0)
    return;
  const std::size_t length = std::min(text.size(), static_cast<std::size_t>(size) - 1);
  std::memcpy(to, text.data(), length);
  to[length] = '\0';
}

/// guarded(), for functions that give the message to the caller's array.
template <class Action> int told(char* message, int size, const Action& action) noexcept {
  std::string text;
  const int code = guarded(text, action);
  copy_text(text, message, size);
  return code;
}

} // namespace bem_contact
