#pragma once

#include "bem_contact/contact_input/blocks.hpp"

#include <span>

namespace bem_contact::contact_input {

/// What a value of a digit does with data.
enum class Effect {
  reads,  ///< from the lines that follow
  keeps,  ///< those of the case before, which must have some
  removes ///< there are none from here on
};

/// A digit with values of it; '*' stands for every case.
struct Condition {
  char digit;
  std::string_view values;
};

/// One row of the table: in these modules, where the digits have these values, these data are read, kept or
/// removed.
struct DataRule {
  Modules modules;
  Condition when, also; ///< both hold
  Effect effect;
  Data data;
  std::string_view format;                                  ///< of one item (see fields_of())
  void (*read)(InputLines& in, CaseState& state) = nullptr; ///< instead of `format`, for what is not one item
};

/// The table, in the order of the file.
std::span<const DataRule> data_rules();

/// Reads, keeps and removes the data of a case by its digits. Throws InputError for what cannot be read, and
/// for data that are kept and have never been given.
void apply_rules(InputLines& in, CaseState& state);

} // namespace bem_contact::contact_input
