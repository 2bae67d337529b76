#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace bem_contact::contact_input {

/// One value of an item: its name in CONTACT's guide, and how it is read.
struct Field {
  std::string name;
  /// i whole number, d number, a angle, s text in quotes. As a capital it may be missing: the line then ends,
  /// or goes on with a remark.
  char type = 'd';
};

/// Fields of "FBDIST d, FBPOS d, NOMRAD d, YTAPE D".
std::vector<Field> fields_of(std::string_view format);

/// What an item gave.
struct Item {
  int line = 0;                ///< where it began
  std::vector<double> numbers; ///< in the order of the fields, as many as are given
  std::vector<std::string> texts;
};

/// The lines of an input file that say something, and how items are taken from them: values stand in free
/// format, an item begins on a line of its own and goes on over as many as it needs, and what follows its
/// last value on a line is a remark.
class InputLines {
public:
  /// `source` names the text in messages. A byte order mark is left out.
  InputLines(std::string_view text, std::string source);

  /// The next item. Throws InputError with line, name and word of a value that cannot be read.
  Item take(std::string_view format);
  /// So many numbers (type d or a), which may stand on many lines.
  Item take_array(const std::string& name, char type, std::size_t count);
  /// The type of one letter, of control digits and counts: take("NVF i").numbers[0], from `least` to `most`.
  long take_count(std::string_view format, long least, long most);

  bool ended() const;                ///< whether nothing but remarks is left
  int line() const;                  ///< number of the line that comes next
  std::string where(int line) const; ///< "FILE:12: "

  /// Numbers that stand where nothing more is read: a sentence for each.
  std::vector<std::string>& beyond() { return beyond_; }

private:
  struct Line {
    int number = 0;
    std::vector<std::string> words;
  };
  void note_numbers_beyond(const std::vector<Field>& fields, std::size_t word);

  std::string source_;
  std::vector<Line> lines_;
  std::size_t next_ = 0;
  std::vector<std::string> beyond_;
};

} // namespace bem_contact::contact_input
