#include "bem_contact/base/output_folder.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/printable.hpp"
#include "bem_contact/base/toml.hpp"
#include "tests/base/message.hpp"
#include "tests/base/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>

namespace bem_contact {

namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

class OutputFolderOf : public ::testing::Test {
protected:
  TemporaryFolder folder_;
  fs::path place() const { return folder_ / "out"; }
  OutputFolder opened(bool alone = false, std::vector<fs::path> inputs = {}) const {
    return {place(), {.maker = "study", .alone = alone, .inputs = std::move(inputs)}};
  }
  static void put(const fs::path& file, const std::string& text) { std::ofstream(file) << text; }
  static std::string at(const fs::path& file) { return read_text_file(file.string(), "file"); }
  static void write(OutputFolder& to, const std::string& name, const std::string& text) {
    to.write(name, [&](std::ostream& out) { out << text; });
  }
};

TEST_F(OutputFolderOf, replaces_and_removes_what_it_has_written) {
  {
    OutputFolder first = opened();
    write(first, "a.csv", "1");
    write(first, "b.csv", "2");
  }
  OutputFolder next = opened();
  write(next, "a.csv", "3");
  next.remove_others({"a.csv"});
  EXPECT_EQ(at(place() / "a.csv"), "3");
  EXPECT_FALSE(fs::exists(place() / "b.csv"));
  next.remove_all();
  EXPECT_FALSE(fs::exists(place()));
}

TEST_F(OutputFolderOf, refuses_files_of_others_and_changed_ones) {
  fs::create_directory(place());
  put(place() / "mine.csv", "mine");
  {
    OutputFolder first = opened();
    write(first, "a.csv", "1");
    EXPECT_THAT(message_of([&] { first.take("mine.csv"); }), HasSubstr("bem_contact study has not made it"));
  }
  put(place() / "a.csv", "edited");
  OutputFolder next = opened();
  EXPECT_THAT(message_of([&] { next.take("a.csv"); }), HasSubstr("it has changed since it was written"));
  EXPECT_THAT(message_of([&] { next.require_unchanged(); }), HasSubstr("has changed since"));
  next.remove("a.csv");
  next.remove("mine.csv");
  EXPECT_EQ(at(place() / "a.csv"), "edited");
  EXPECT_EQ(at(place() / "mine.csv"), "mine");
}

TEST_F(OutputFolderOf, goes_on_where_writing_was_interrupted) {
  opened().take("a.csv");
  put(place() / "a.csv", "half");
  OutputFolder next = opened();
  EXPECT_TRUE(next.owns("a.csv"));
  write(next, "a.csv", "whole");
  EXPECT_EQ(at(place() / "a.csv"), "whole");
}

TEST_F(OutputFolderOf, follows_no_link_and_replaces_no_input) {
  fs::create_directory(place());
  put(folder_ / "elsewhere", "mine");
  put(folder_ / "input", "mine");
  fs::create_symlink(folder_ / "elsewhere", place() / "a.csv");
  fs::create_hard_link(folder_ / "input", place() / "b.csv");
  OutputFolder out = opened(false, {folder_ / "input"});
  EXPECT_THAT(message_of([&] { out.take("a.csv"); }), HasSubstr("it is a link"));
  EXPECT_THAT(message_of([&] { out.take("b.csv"); }), HasSubstr("would overwrite"));
  EXPECT_THAT(message_of([&] { out.take("two\nlines"); }), HasSubstr("more than one line"));
  EXPECT_EQ(at(folder_ / "elsewhere"), "mine");
}

TEST_F(OutputFolderOf, has_a_folder_alone) {
  fs::create_directory(place());
  put(place() / "notes", "mine");
  EXPECT_THAT(message_of([&] { opened(true); }), HasSubstr("it is not empty ('notes')"));
  fs::remove(place() / "notes");
  opened(true);
  put(place() / "notes", "mine"); // the folder is known by its mark
  opened(true).remove_all();
  EXPECT_TRUE(fs::exists(place() / "notes"));
}

TEST_F(OutputFolderOf, refuses_a_damaged_list) {
  {
    OutputFolder first = opened();
    write(first, "a.csv", "1");
  }
  const std::string whole = at(place() / ".made_by_study");
  const std::size_t digest = whole.rfind("  a.csv") - 64;
  for (std::size_t byte = 0; byte < whole.size(); ++byte) {
    std::string damaged = whole;
    damaged[byte] ^= 4;
    put(place() / ".made_by_study", damaged);
    std::string said;
    try {
      OutputFolder next = opened();
      next.take("a.csv");
    } catch (const InputError& error) {
      said = error.what();
    }
    // The line before a file is written says no more than that it may be ours.
    const bool counts = byte <= whole.find('\n') || (byte >= digest && byte < digest + 64);
    EXPECT_TRUE(!counts || !said.empty()) << byte;
    EXPECT_EQ(at(place() / "a.csv"), "1");
  }
}

TEST(Printable, LeavesNoOrderForATerminal) {
  EXPECT_EQ(printable("a\x1b]0;evil\a\x1b[31m\tb\n"), "a?]0;evil??[31m\tb\n");
  EXPECT_EQ(printable("over\rwritten\r\n"), "over?written\r\n");
  EXPECT_EQ(printable("\xc2\x9b"
                      "31m \xc3\xa9 \xff \x7f"),
            "?31m \xc3\xa9 ? ?");
}

TEST(DeepToml, IsRefusedBeforeItIsRead) {
  const auto dotted = [](int levels) {
    std::string key;
    for (int k = 0; k < levels; ++k)
      key += "a.";
    return key + "b";
  };
  EXPECT_NO_THROW(parse_toml(dotted(900) + " = 1"));
  EXPECT_NO_THROW(parse_toml("a = \"" + dotted(5000) + "\" # " + dotted(5000) + "\nb = [1.5, 2.5]"));
  std::string many = "a = [";
  for (int k = 0; k < 5000; ++k)
    many += "1.5, ";
  EXPECT_NO_THROW(parse_toml(many + "]"));
  EXPECT_THROW(parse_toml(dotted(100000) + " = 1"), toml::parse_error);
  EXPECT_THROW(parse_toml("[" + dotted(100000) + "]"), toml::parse_error);
  EXPECT_THROW(parse_toml(dotted(800) + " = { " + dotted(800) + " = 1 }"), toml::parse_error);
  EXPECT_THROW(parse_toml(dotted(800) + " = [\n{ " + dotted(800) + " = 1 } ]"), toml::parse_error);
}

} // namespace

} // namespace bem_contact
