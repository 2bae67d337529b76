#pragma once

#include "bem_contact/record/record.hpp"

#include <cstddef>
#include <iosfwd>
#include <string>
#include <string_view>

/// Tables as CSV files have them: a head of names with units, then one line a row.
namespace bem_contact::record {

/// The head of a column: "Mz_Nmm" of the name "Mz" and the unit "N mm", without a unit the name alone.
std::string csv_name(std::string_view name, std::string_view unit);
/// A number with so many digits; an empty cell for nan.
std::string csv_cell(double value, int digits);
/// Whether a spreadsheet takes a text as a formula, which it computes when the table is opened.
bool is_formula(std::string_view text);
/// A text in quotes (RFC 4180): doubled quotes. For people: in one line, and no formula.
std::string csv_text(std::string_view text);
/// The heads of all columns, and the cells of one row, with commas between them.
std::string csv_head(const Table& table);
std::string csv_line(const Table& table, std::size_t row, int digits = 17);
/// Head and rows. `digits`: at most so many of each number.
void write_csv(std::ostream& out, const Table& table, int digits = 17);

/// Throws InputError for a name that csv_text() would change, and that nobody would find again then. `what`
/// has this name.
void require_cell(std::string_view name, std::string_view what);

} // namespace bem_contact::record
