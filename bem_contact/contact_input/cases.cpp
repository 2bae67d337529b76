#include "bem_contact/contact_input/cases.hpp"

#include "bem_contact/contact_input/rules.hpp"

#include <fmt/format.h>
#include <map>
#include <tuple>

namespace bem_contact::contact_input {

namespace {

struct Where {
  int module = 0, element = 0, patch = 1;
};

/// The line "3 1 2 MODULE": module, result element, contact patch. 0 ends the file.
Where read_module(InputLines& in) {
  const Item item = in.take("MODULE i, REID I, CPID I");
  const auto number = [&](std::size_t k, int otherwise) {
    return item.numbers.size() > k ? static_cast<int>(item.numbers[k]) : otherwise;
  };
  const int module = number(0, 0);
  if (module != 0 && module != 1 && module != 3)
    throw InputError(fmt::format("{}MODULE is {}", in.where(item.line), module),
                     "a wheel on a rail is module 1, a patch module 3, and 0 ends the file",
                     "Correct the line.");
  return {module, number(1, 0), module == 1 ? -1 : number(2, 1)};
}

/// What the digits C, D, L and V say until others do.
void set_effective(CaseState& state) {
  const Digits& d = state.digits;
  for (const auto& [letter, kept] : {std::pair{'C', "01"}, {'D', "01"}, {'L', "1"}, {'V', ""}})
    if (letter == 'D' && state.module == 3)
      state.effective.set('D', d['D']);
    else if (letter == 'V' ? d['L'] != 1 : !d.is(letter, kept))
      state.effective.set(letter, d[letter]);
}

void read_all(InputLines& in, std::vector<CaseState>& cases) {
  std::map<std::tuple<int, int, int>, CaseState> states;
  Where where;
  bool stays = false; // R = 0, 2: the next case has no line MODULE
  while (true) {
    const int line = in.line();
    if (!stays)
      where = read_module(in);
    if (where.module == 0)
      return;
    CaseState& state = states[{where.module, where.element, where.patch}];
    state.module = where.module, state.element = where.element, state.patch = where.patch;
    state.line = line;
    state.first = state.number == 0 || !state.has(Data::friction);
    state.number = static_cast<int>(cases.size()) + 1;
    in.beyond().clear();
    state.digits = read_digits(in, where.module);
    apply_rules(in, state);
    set_effective(state);
    if (where.module == 3 && state.digits['D'] != 0) {
      state.grid_load = state.shared(Data::kinematics);
      state.grid_material = state.shared(Data::material);
    }
    state.remarks = in.beyond();
    cases.push_back(state);
    stays = state.digits.is('R', "02");
  }
}

} // namespace

CasesRead read_cases(std::string_view text, const std::string& source) {
  InputLines in(text, source);
  CasesRead out;
  try {
    read_all(in, out.cases);
  } catch (const InputError& error) {
    out.broken = error;
  }
  if (out.cases.empty() && !out.broken)
    out.broken = InputError(fmt::format("'{}' has no case", source), "no line says 1 MODULE or 3 MODULE",
                            "Give an input file (.inp) of CONTACT.");
  return out;
}

} // namespace bem_contact::contact_input
