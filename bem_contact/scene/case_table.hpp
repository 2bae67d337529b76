#pragma once

#include "bem_contact/base/schema.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace bem_contact {

/// Cases of a scene, one a line: values of its keys, and how often each case occurs.
struct CaseTable {
  struct Column {
    std::string key;                 ///< dotted: "position.lateral"; "note.time": carried along
    std::vector<SchemaValue> values; ///< one a case

    bool is_note() const { return key.starts_with(note_prefix); }
    static constexpr std::string_view note_prefix = "note.";
  };
  std::vector<Column> columns;
  std::vector<int> lines;      ///< of each case, in the file
  std::vector<double> weights; ///< positive; empty: no column `weight`, all cases occur alike
};

/// Reads a CSV file (csv_lines()). Its first line names keys of a scene, and
/// `weight` if there are weights. Cells are numbers, true or false; texts in quotes.
///
/// A column that begins with "note." is no key: its cells, of any text, are carried along. `renamed`: what a
/// column of another name is: a key, "weight", or "note".
///
/// Columns of results are not cases: of a table that `bem_contact sweep --csv` wrote (its first column is
/// `case`) only those columns are taken whose names are keys, and `weight`. Whether a scene has such keys is
/// seen when a case is made of them. Throws InputError, naming file and line, for a missing file, a line of
/// another length, cells without a value, weights that are not positive, a column that occurs twice, and a
/// column of `renamed` that the file does not have.
CaseTable read_case_table(const std::filesystem::path& file,
                          const std::map<std::string, std::string>& renamed = {});

} // namespace bem_contact
