#pragma once

#include "bem_contact/base/conventions.hpp"
#include "bem_contact/h5/handle.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace bem_contact {

/// One dataset of doubles, row-major. Attributes say what it is: "unit", "description", and where there are
/// some, "role", "of" and "choices".
struct H5Dataset {
  std::vector<std::size_t> shape = {}; ///< length of each dimension; empty: a single number
  std::vector<double> values = {};     ///< as many as the product of the lengths, the last dimension fastest
  std::string unit = {};               ///< of the values: mm, N, MPa ...; "1": none
  std::string description = {};        ///< in a few words
  bool whole = false;                  ///< whole numbers: stored as such, none of them nan
  std::string role = {}; ///< what a reader does with it (record/record.hpp); "": nothing special
  std::vector<std::string> choices = {}; ///< the values count these, from 0; in the file a line each
  std::string of = {}; ///< the dataset beside it whose error, say, it is: where the role asks for one

  static H5Dataset single(double value, std::string unit, std::string description) {
    return {{}, {value}, std::move(unit), std::move(description)};
  }
  static H5Dataset line(std::vector<double> values, std::string unit, std::string description) {
    const std::size_t n = values.size();
    return {{n}, std::move(values), std::move(unit), std::move(description)};
  }
  /// Rows of equal length, one or more.
  template <class Rows> static H5Dataset matrix(const Rows& rows, std::string unit, std::string description) {
    H5Dataset out{{rows.size(), rows.front().size()}, {}, std::move(unit), std::move(description)};
    for (const auto& row : rows)
      out.values.insert(out.values.end(), row.begin(), row.end());
    return out;
  }
  /// [point][y, z]
  static H5Dataset points(const std::vector<Point2>& all, std::string description) {
    H5Dataset out{{all.size(), 2}, {}, "mm", std::move(description)};
    for (const Point2& p : all)
      out.values.insert(out.values.end(), {p.y, p.z});
    return out;
  }
};

/// An attribute of a file or of a group: a text, a number, or a yes or no.
using H5Attribute = std::variant<std::string, double, bool>;

/// One text, which may be long: an attribute holds at most 64 kB.
struct H5Text {
  std::string text;        ///< UTF-8
  std::string description; ///< in a few words
  bool lines = false;      ///< several texts, each a line

  bool operator==(const H5Text&) const = default;
};

/// A whole small HDF5 file. Names are paths ("fem/p_n"); groups come into being with them. The attribute
/// "fem/model" is the attribute "model" of the group "fem", "model" one of the file.
struct H5Table {
  std::map<std::string, H5Dataset> datasets;     ///< of numbers, by path
  std::map<std::string, H5Attribute> attributes; ///< by path; those of datasets are in H5Dataset
  std::map<std::string, H5Text> texts;           ///< datasets of one text (UTF-8)
  /// Writing: whether the numbers of each dataset get a checksum, so that no changed bit is read. HDF5 before
  /// 1.10 cannot read such a file. Reading: whether all of them had one.
  bool checksums = false;
};

/// Adds all of `members` as a group, "right/" say.
void add_group(H5Table& table, const std::string& group, const H5Table& members);

/// The attribute of that name; "" where there is none, or a number.
std::string text_attribute(const H5Table& table, const std::string& name);

/// The dataset of that name in a table that was read from `file`. Throws InputError, naming both, where the
/// table lacks it, or where it has not `count` numbers (no count: at least one).
const H5Dataset& dataset_of(const H5Table& table, const std::string& name, const std::filesystem::path& file,
                            std::optional<std::size_t> count = {});

/// Writes the whole file at once. Throws what write_whole() does (base/output_file.hpp).
void write_h5(const std::filesystem::path& file, const H5Table& table);
/// What the file would hold.
std::string h5_bytes(const H5Table& table);

/// Reads every dataset of numbers or of one text, and every attribute (of the file and its groups) that is
/// text or a number. Throws InputError for a missing file or one that is not whole HDF5.
H5Table read_h5(const std::filesystem::path& file);
/// The same without the datasets that lie in groups, but for those of the group `but` ("" for none).
H5Table read_h5_top(const std::filesystem::path& file, const std::string& but = "");
/// The same with those datasets alone whose path is wanted.
H5Table read_h5_where(const std::filesystem::path& file,
                      const std::function<bool(const std::string& path)>& wanted);

/// Rows of a long line that are deflated together (H5Writer::add_line()). Who reads a line in runs of as many
/// inflates each chunk once.
inline constexpr std::size_t rows_of_a_chunk = 8192;

/// Writes a file table by table, for more than memory holds. It has a temporary name beside `file` until
/// finish() renames it: `file` is whole or absent. Throws what write_whole() does (base/output_file.hpp).
class H5Writer {
public:
  explicit H5Writer(const std::filesystem::path& file);
  ~H5Writer(); ///< removes what was not finished
  H5Writer(const H5Writer&) = delete;
  H5Writer& operator=(const H5Writer&) = delete;

  /// Names must be new to the file, but for groups.
  void add(const H5Table& table);
  /// Makes a dataset of `size` numbers, deflated and with checksums. put() appends them, run by run.
  /// `form`: all of it but shape and values.
  void add_line(const std::string& name, std::size_t size, const H5Dataset& form);
  void put(const std::string& name, std::span<const double> values);
  /// Throws Error where a line has fewer numbers than it was made for, too.
  void finish();

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// A file that is read part by part, for more than memory holds. All functions throw what read_h5() does.
class H5Reader {
public:
  explicit H5Reader(std::filesystem::path file);

  const std::filesystem::path& file() const { return file_; }
  /// What lies in a group, with the names that it has there; all groups below it, too. Empty: no such group.
  H5Table group(const std::string& path) const;
  /// The attributes of the file itself.
  H5Table attributes() const;
  /// The names of a group's members.
  std::set<std::string> members(const std::string& path) const;
  /// The text that group() has as an attribute of that name; "" where there is none.
  std::string text(const std::string& path, const std::string& name) const;
  /// A dataset of one number; nan where there is none.
  double number(const std::string& name) const;
  /// How many numbers a dataset has; 0 where there is none.
  std::size_t size(const std::string& name) const;
  /// Throws InputError, as dataset_of() does, unless the dataset is a line of `count` numbers.
  void require(const std::string& name, std::size_t count) const;
  /// `count` numbers of a line, from the one with number `first` on.
  std::vector<double> line(const std::string& name, std::size_t first, std::size_t count) const;

private:
  bool has(const std::string& path) const;
  [[noreturn]] void refuse() const;

  std::filesystem::path file_;
  H5Handle root_;
};

} // namespace bem_contact
