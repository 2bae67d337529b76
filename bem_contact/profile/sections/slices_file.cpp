#include "bem_contact/profile/sections/slices_file.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/place_in_table.hpp"
#include "bem_contact/profile/formats/text_lines.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "bem_contact/profile/standard_profiles.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace bem_contact {

namespace {

/// 1. Most sections that a file may have. A bound.
constexpr double most_slices = 100000;
/// 1. Most features.
constexpr double most_features = 1000;
/// mm. Places along the track, as `at` of a scene's sections. A bound.
constexpr double farthest_place = 1e7;

/// The words of a slices file, line by line. A group of values may go on in the next line; what follows them
/// in their last line is a remark.
class SliceLines {
public:
  explicit SliceLines(const std::filesystem::path& file)
      : source_(file.string()), text_(read_text_file(source_, "slices file")), lines_(lines_of(text_)) {}

  int line() const { return line_; }
  [[noreturn]] void refuse(const std::string& why, const std::string& advice) const {
    throw InputError(fmt::format("{}:{}: this is no slices file that can be used", source_, line_), why,
                     advice);
  }
  /// Begins a group of values in the next line that has one.
  void begin() {
    words_.clear();
    while (words_.empty())
      words_ = next_line();
    word_ = 0;
  }
  double number(const char* what) {
    const std::string_view word = next_word(what);
    const auto value = parse_number(word);
    if (!value || !std::isfinite(*value))
      refuse(fmt::format("'{}' stands where {} is expected", word, what), "Correct the line.");
    return *value;
  }
  /// The same of one that may be missing in its line.
  double number_or(double none) {
    const auto value = word_ < words_.size() ? parse_number(words_[word_]) : std::nullopt;
    word_ += value ? 1 : 0;
    return value.value_or(none);
  }
  std::string text(const char* what) { return std::string(next_word(what)); }
  /// After the last value of a group: another number in its line is one that no count knows.
  void end(const char* what, int count) const {
    if (word_ < words_.size() && parse_number(words_[word_]))
      refuse(fmt::format("'{}' follows {}, and the head of the file counts {}", words_[word_], what, count),
             "Correct the count or the line.");
  }
  /// After the last group.
  void end_of_file(int sections, int features) {
    while (next_ < lines_.size())
      if (const auto words = next_line(); !words.empty() && parse_number(words.front()))
        refuse(fmt::format("the file goes on with '{}', and its head counts {} sections and {} features",
                           words.front(), sections, features),
               "Correct the counts, or mark what follows as a remark with %.");
  }

private:
  std::string_view next_word(const char* what) {
    while (word_ == words_.size()) {
      if (next_ >= lines_.size())
        refuse(fmt::format("the file ends where {} is expected", what), "Complete the file.");
      words_ = next_line();
      word_ = 0;
    }
    return words_[word_++];
  }
  std::vector<std::string_view> next_line() {
    if (next_ >= lines_.size())
      refuse("the file ends too early", "Complete the file.");
    std::string_view line = lines_[next_++];
    line_ = static_cast<int>(next_);
    std::vector<std::string_view> words;
    for (std::size_t i = 0; i < line.size();) {
      const char c = line[i];
      if (c == '%' || c == '!')
        break;
      if (c == ' ' || c == '\t' || c == ',' || c == '\r') {
        ++i;
        continue;
      }
      const bool quoted = c == '\'' || c == '"';
      const std::size_t from = quoted ? i + 1 : i;
      std::size_t to = quoted ? line.find(c, from) : line.find_first_of(" \t,\r%!", from);
      if (to == std::string_view::npos)
        to = line.size();
      const std::string_view whole = line.substr(from, line.find_first_of(" \t\r%!", from) - from);
      if (!quoted && !(from > 0 && line[from - 1] == ',') && has_decimal_comma(whole))
        refuse(fmt::format("'{}' may be one number or two", whole),
               "Write decimal points, and a blank behind a comma between two numbers.");
      words.push_back(line.substr(from, to - from));
      i = quoted ? to + 1 : to;
    }
    return words;
  }

  std::string source_, text_;
  std::vector<std::string_view> lines_, words_;
  std::size_t next_ = 0, word_ = 0;
  int line_ = 0;
};

struct SlicesHeader {
  double offset = 0, scale = 1;
  int slices = 0, features = 0, kinks = 0, jumps = 0;
  bool approximated = false;
};

int whole_number(SliceLines& in, double value, double most, const char* what, double least = 0) {
  if (value != std::round(value) || value < least || value > most)
    in.refuse(fmt::format("{} is {:g}", what, value),
              fmt::format("Give a whole number from {:g} to {:g}.", least, most));
  return static_cast<int>(value);
}

SlicesHeader read_header(SliceLines& in) {
  SlicesHeader out;
  in.begin();
  out.offset = in.number("the offset of the places");
  out.scale = in.number("the scale of the places");
  if (!(out.scale > 0))
    in.refuse(fmt::format("the scale of the places is {:g}", out.scale), "Give mm for each unit, above 0.");
  in.begin();
  out.slices =
      whole_number(in, in.number("the number of sections"), most_slices, "the number of sections", 1);
  in.begin();
  out.features =
      whole_number(in, in.number("the number of features"), most_features, "the number of features");
  out.kinks = whole_number(in, in.number_or(0), most_features, "the number of kinks");
  out.jumps = whole_number(in, in.number_or(0), most_features, "the number of jumps of the curvature");
  in.begin();
  const double way = in.number("the way of interpolation");
  if (way != 1 && way != 2)
    in.refuse(fmt::format("{:g} is no way of interpolation", way),
              "Give 1: the surface goes through the sections; or 2: it is smoother than they are.");
  out.approximated = way == 2;
  if (in.number_or(0) != 0)
    in.refuse("perturbations of the surface are not known here", "Give 0, or leave the number out.");
  return out;
}

/// Where the lengths along the chords of a profile's points lie on its curve.
class ChordLength {
public:
  explicit ChordLength(const ProfileCurve& curve) : s_(curve.joints()) {
    for (const double s : s_) {
      const Point2 p = curve.at(s).position;
      chord_.push_back(chord_.empty() ? 0.0 : chord_.back() + norm(p - last_));
      last_ = p;
    }
  }
  double arc_length(double chord) const {
    const PlaceInTable at(chord_, chord);
    return s_[at.line] + at.share * (s_[at.line + 1] - s_[at.line]);
  }

private:
  std::vector<double> s_, chord_;
  Point2 last_{};
};

/// Errors name the line of the slices file.
ProfileCurve profile_of(const std::filesystem::path& file, const Slice& slice, ProfileKind kind,
                        const ProfileReading& reading) {
  try {
    if (names_slices(slice.profile))
      throw InputError(fmt::format("'{}' is a slices file", slice.profile.string()),
                       "each section is one profile", "Name a profile file.");
    return named_profile(slice.profile.string(), kind, {}, reading);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}:{}: {}", file.string(), slice.line, error.what()));
  }
}

/// Its place and its file, which may be named as on Windows.
Slice read_slice(SliceLines& in, const SlicesHeader& header, const std::filesystem::path& folder) {
  in.begin();
  const double place = in.number("the place of a section");
  const int line = in.line();
  std::string profile = in.text("the file of a section");
  std::ranges::replace(profile, '\\', '/');
  return {header.scale * (header.offset + place),
          is_standard_profile(profile) ? std::filesystem::path(profile) : folder / profile,
          {},
          line};
}

} // namespace

std::optional<ProfileKind> kind_of_slices(const std::filesystem::path& name) {
  const std::string ending = lower_ending(name);
  return ending == ".slcs"   ? std::optional(ProfileKind::rail)
         : ending == ".slcw" ? std::optional(ProfileKind::wheel)
                             : std::nullopt;
}

SlicesFile read_slices(const std::filesystem::path& file) {
  const char* unit = kind_of_slices(file) == ProfileKind::wheel ? "rad" : "mm";
  SliceLines in(file);
  const SlicesHeader header = read_header(in);
  SlicesFile all{{}, header.approximated};
  std::vector<Slice>& out = all.slices;
  for (int i = 0; i < header.slices; ++i) {
    out.push_back(read_slice(in, header, file.parent_path()));
    if (!(std::abs(out[i].at) <= farthest_place))
      in.refuse(fmt::format("section {} is at {:g} {}", i + 1, out[i].at, unit),
                fmt::format("Correct offset, scale or place: at most {:g} {}.", farthest_place, unit));
    if (i > 0 && !(out[i].at > out[i - 1].at))
      in.refuse(fmt::format("section {0} is at {1:g} {3} and the one before it at {2:g} {3}", i + 1,
                            out[i].at, out[i - 1].at, unit),
                "Give the sections by rising place.");
  }
  for (const int parts : {header.kinks, header.jumps})
    if (parts > 0) {
      in.begin();
      const double most = std::max(header.features, 2);
      for (int k = 0; k < parts; ++k)
        whole_number(in, in.number("the number of a part"), most, "the number of a part", -most);
      in.end("the numbers of parts", parts);
    }
  for (int i = 0; i < header.slices && header.features > 1; ++i) {
    in.begin();
    const double at = header.scale * (header.offset + in.number("the place of a section"));
    if (std::abs(at - out[i].at) > 1e-3)
      in.refuse(fmt::format("the features of section {} are those of a place at {:g} {}", i + 1, at, unit),
                fmt::format("Give them for {:g} {}, in the order of the sections.", out[i].at, unit));
    for (int k = 0; k < header.features; ++k) {
      const double s = in.number("a feature");
      out[i].features.push_back(s < 0 ? std::numeric_limits<double>::quiet_NaN() : s);
    }
    in.end("the features of a section", header.features);
  }
  in.end_of_file(header.slices, header.features);
  return all;
}

SlicedBody sections_of_slices(const std::filesystem::path& file, ProfileKind kind,
                              const ProfileReading& reading) {
  const bool wheel = kind == ProfileKind::wheel;
  if ((kind_of_slices(file) == ProfileKind::wheel) != wheel)
    throw InputError(fmt::format("{} gives the sections of a {}", file.string(), wheel ? "rail" : "wheel"),
                     fmt::format("the sections of a {} are asked for", wheel ? "wheel" : "rail"),
                     fmt::format("Give a file that ends with {}.", wheel ? ".slcw" : ".slcs"));
  const SlicesFile given = read_slices(file);
  SlicedBody out{{}, given.approximated};
  for (const Slice& slice : given.slices) {
    BodySection& section =
        out.sections.emplace_back(BodySection{slice.at, profile_of(file, slice, kind, reading)});
    if (slice.features.empty())
      continue;
    const ChordLength lengths(section.profile);
    for (const double chord : slice.features)
      section.features.push_back(std::isnan(chord) ? chord : lengths.arc_length(chord));
  }
  return out;
}

} // namespace bem_contact
