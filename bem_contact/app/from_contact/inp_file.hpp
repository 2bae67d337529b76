#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace bem_contact::app {

/// The lines of an input file of the program CONTACT, read as that program does: values stand in free format,
/// what follows the last one on a line is a remark, and so is all behind %.
class InpFile {
public:
  /// Throws InputError for what cannot be read.
  explicit InpFile(const std::filesystem::path& file);
  /// The same from a text; `source` names it in messages.
  InpFile(std::string_view text, std::string source);

  /// Values of one item.
  struct Values {
    std::vector<double> numbers;
    std::string text; ///< of the type 's'
    double operator[](std::size_t k) const { return numbers.at(k); }
    std::size_t size() const { return numbers.size(); }
  };
  /// The next item; it may go on over several lines. A letter for each value: i whole, d number, a angle
  /// (radians, with the ending d degrees), s text in quotes; capitals may be missing on the line. Throws
  /// InputError naming line and item.
  Values take(const std::string& item, std::string_view types);
  /// Control digits, the first letter's first: "C-P-B-T-N-F-S" and such.
  std::vector<int> digits(const std::string& item, std::size_t count);

  bool ended() const;        ///< whether nothing but remarks is left
  int line() const;          ///< number of the line that comes next
  std::string where() const; ///< "FILE:12: "

private:
  struct Line {
    int number = 0;
    std::vector<std::string> words;
  };
  std::string source_;
  std::vector<Line> lines_;
  std::size_t next_ = 0;
};

} // namespace bem_contact::app
