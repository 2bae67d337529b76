#pragma once

#include "bem_contact/contact_input/input_lines.hpp"

#include <map>
#include <span>
#include <string_view>

namespace bem_contact::contact_input {

/// Modules of CONTACT, as bits: a wheel on a rail, a patch, or both.
enum Modules : unsigned { module_1 = 1, module_3 = 2, both_modules = 3 };

constexpr Modules bit_of(int module) {
  return module == 1 ? module_1 : module_3;
}

/// A control digit: its letter, what it is about, the values that CONTACT accepts.
struct DigitRule {
  char letter; ///< m is M2, which stands alone behind V-L-D-C-M-Z-E
  Modules modules;
  std::string_view values; ///< "0123"
  std::string_view about;
};

/// Lists the digits in the order in which they stand in the file.
std::span<const DigitRule> digit_rules();

/// The control digits of one case.
class Digits {
public:
  int operator[](char letter) const { return values_.at(letter); }
  /// Whether the digit is one of `values`, as in is('T', "23").
  bool is(char letter, std::string_view values) const {
    return values.find(static_cast<char>('0' + (*this)[letter])) != std::string_view::npos;
  }
  void set(char letter, int value) { values_[letter] = value; }

private:
  std::map<char, int> values_;
};

/// Reads the three lines of digits. Throws InputError with the line and the digit that CONTACT does not
/// accept.
Digits read_digits(InputLines& in, int module);

} // namespace bem_contact::contact_input
