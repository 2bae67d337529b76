#pragma once

#include <string>

namespace bem_contact::record {

/// An error with two digits, "4.2", without an exponent where that is short; "" for one that is zero, because
/// the number is prescribed, and for one that is not known.
std::string two_digits(double error);

/// " +- 4.2", or "" where two_digits() are.
std::string plus_minus(double error);

/// A number with so many decimals, or with as many as two_digits() has of its error if these are more. Never
/// "-0.0".
std::string fixed_fine(double value, double error, int decimals);
/// The same with so many digits; without a known error as "{:g}" prints numbers, but large ones in full.
std::string digits_fine(double value, double error, int digits);

/// The same, and no finer than one digit more than two_digits() has.
std::string fixed_within(double value, double error, int decimals);
std::string digits_within(double value, double error, int digits);

/// "2630 +- 32": number and error, both rounded to two digits of the error, also in front of the decimal
/// point
/// ("34790 +- 220"). Without a known error four digits of the number.
std::string rounded(double value, double error);

} // namespace bem_contact::record
