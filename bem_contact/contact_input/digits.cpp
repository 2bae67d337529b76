#include "bem_contact/contact_input/digits.hpp"

#include "bem_contact/base/error.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <string>

namespace bem_contact::contact_input {

namespace {

std::string with_spaces(std::string_view values) {
  std::string out;
  for (const char c : values)
    out += (out.empty() ? "" : ", ") + std::string(1, c);
  return out;
}

/// Sets the digit of `letter`. Throws where CONTACT does not accept it.
void set_digit(Digits& digits, char letter, int value, int module, const std::string& where) {
  const auto rule = std::ranges::find_if(digit_rules(), [&](const DigitRule& r) {
    return r.letter == letter && (r.modules & bit_of(module)) != 0;
  });
  if (rule != digit_rules().end() &&
      rule->values.find(static_cast<char>('0' + value)) == std::string_view::npos)
    throw InputError(fmt::format("{}The digit {} ({}) is {}", where,
                                 letter == 'm' ? "M2" : std::string(1, letter), rule->about, value),
                     fmt::format("CONTACT takes {} in module {}", with_spaces(rule->values), module),
                     "Correct the line.");
  digits.set(letter, value);
}

/// One line of digits: `letters` in the order of the line. Digits in front that are not written are 0.
Item read_line(InputLines& in, std::string_view format, std::string_view letters, int module,
               Digits& digits) {
  const Item item = in.take(format);
  const double given = item.numbers[0];
  std::string text = given >= 0 && given < 1e9 ? fmt::format("{:.0f}", given) : "";
  if (text.empty() || text.size() > letters.size())
    throw InputError(fmt::format("{}The control digits cannot be read", in.where(item.line)),
                     fmt::format("{:.0f} does not have the {} digits {}", given, letters.size(), letters),
                     "Correct the line.");
  text.insert(0, letters.size() - text.size(), '0');
  for (std::size_t k = 0; k < letters.size(); ++k)
    set_digit(digits, letters[k], text[k] - '0', module, in.where(item.line));
  return item;
}

} // namespace

std::span<const DigitRule> digit_rules() {
  static constexpr DigitRule rules[] = {
      {'1', module_1, "0145", "configuration"},
      {'P', both_modules, "0123", "previous case"},
      {'B', module_1, "0156", "bound of the pressure"},
      {'B', module_3, "0123456", "bound of the pressure"},
      {'T', both_modules, "0123", "tangential problem"},
      {'N', both_modules, "01", "normal problem"},
      {'F', module_1, "013", "tangential forces"},
      {'F', module_3, "012", "tangential forces"},
      {'S', both_modules, "0123", "stresses below the surface"},
      {'V', module_1, "012", "variation of friction"},
      {'V', module_3, "03", "variation of friction"},
      {'L', both_modules, "012346", "law of friction"},
      {'D', module_1, "0123456789", "potential contact"},
      {'D', module_3, "012", "potential contact"},
      {'C', module_1, "01234", "influence coefficients"},
      {'C', module_3, "012349", "influence coefficients"},
      {'M', both_modules, "01234567", "material"},
      {'Z', module_1, "0123", "track"},
      {'Z', module_3, "012", "undeformed distance"},
      {'E', module_1, "012345", "wheelset"},
      {'E', module_3, "01239", "extra rigid slip"},
      {'m', both_modules, "012", "damping"},
      {'X', both_modules, "01", "output for debugging"},
      {'H', both_modules, "013", "heat"},
      {'G', both_modules, "012345", "solvers"},
      {'I', both_modules, "0123", "initial estimate"},
      {'A', both_modules, "012", "file for Matlab"},
      {'O', both_modules, "012345", "output"},
      {'W', both_modules, "0123456789", "trace"},
      {'R', both_modules, "0123", "return"},
  };
  return rules;
}

Digits read_digits(InputLines& in, int module) {
  Digits digits;
  read_line(in, "C-P-B-T-N-F-S i", "1PBTNFS", module, digits);
  const Item second = read_line(in, "V-L-D-C-M-Z-E i, M2 I", "VLDCMZE", module, digits);
  // CONTACT has the weight of the gap (0 to 2) in front of M2 in one number.
  const int two = second.numbers.size() > 1 ? static_cast<int>(second.numbers[1]) : 1;
  digits.set('g', two / 10);
  set_digit(digits, 'm', two % 10, module, in.where(second.line));
  read_line(in, "X-H-G-I-A-O-W-R i", "XHGIAOWR", module, digits);
  if (digits['X'] == 1)
    in.take("P-S-F-L-C-I-N i, R I");
  return digits;
}

} // namespace bem_contact::contact_input
