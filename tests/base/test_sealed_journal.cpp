#include "bem_contact/base/sealed_journal.hpp"
#include "bem_contact/base/sha256.hpp"
#include "message.hpp"
#include "temporary_folder.hpp"

#include <gmock/gmock.h>

namespace bem_contact {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr JournalKind diaries{.magic = "diary 1\n",
                              .owner = "person",
                              .of_another = "somebody else wrote it",
                              .of_nobody = "it is no diary",
                              .what_to_do = "Buy one.",
                              .if_in_use = "Wait."};

class Journals : public testing::Test {
protected:
  std::vector<std::string> records(const std::string& whose = "mine") const {
    std::vector<std::string> found;
    read_journal(file, diaries, sha256(whose), [&](std::string_view record) { found.emplace_back(record); });
    return found;
  }
  void append(const std::string& record, const std::string& whose = "mine") const {
    SealedJournal(file, diaries, sha256(whose), [](std::string_view) {}).append(record);
  }

  TemporaryFolder folder;
  std::filesystem::path file = folder / "journal";
};

/// Each write goes on after the records that are whole.
TEST_F(Journals, SurviveAKillAtAnyByte) {
  for (const char* record : {"one", "", "three"})
    append(record);
  const std::string whole = text_of(file);
  const std::size_t header = std::string_view("diary 1\n").size() + sha256_size + 1, seal = 8 + sha256_size;
  const std::size_t ends[] = {header + seal + 3, header + 2 * seal + 3, header + 3 * seal + 8};
  ASSERT_EQ(whole.size(), ends[2]);
  for (std::size_t size = 0; size <= whole.size(); ++size) {
    folder.write("journal", whole.substr(0, size));
    std::vector<std::string> left;
    for (int i = 0; i < 3; ++i)
      if (size >= ends[i])
        left.emplace_back(i == 0 ? "one" : i == 1 ? "" : "three");
    EXPECT_EQ(records(), left) << size;
    append("next");
    left.emplace_back("next");
    EXPECT_EQ(records(), left) << size;
  }
}

TEST_F(Journals, EndBeforeAnAlteredRecord) {
  append("one");
  append("two");
  std::string altered = text_of(file);
  altered[altered.size() - sha256_size - 1] = '0';
  folder.write("journal", altered);
  EXPECT_THAT(records(), ElementsAre("one"));
}

TEST_F(Journals, OfAnotherAreRefusedIfTheyHoldAnything) {
  append("one");
  const std::string before = text_of(file);
  EXPECT_EQ(message_of([&] { append("two", "yours"); }),
            "The file '" + file.string() + "' belongs to another person (somebody else wrote it) Buy one.");
  EXPECT_EQ(message_of([&] { records("yours"); }), message_of([&] { append("two", "yours"); }));
  EXPECT_EQ(text_of(file), before);
  folder.write("journal", before.substr(0, before.find("\n", 10) + 1)); // nothing was finished
  append("two", "yours");
  EXPECT_THAT(records("yours"), ElementsAre("two"));
  folder.write("journal", "my notes");
  EXPECT_THAT(message_of([&] { append("three"); }), HasSubstr("(it is no diary)"));
  EXPECT_EQ(text_of(file), "my notes");
}

TEST_F(Journals, HaveOneWriter) {
  const auto ignore = [](std::string_view) {};
  const SealedJournal first(file, diaries, sha256("mine"), ignore);
  EXPECT_EQ(message_of([&] { append("one"); }),
            "The file '" + file.string() + "' is in use (another process writes it) Wait.");
}

TEST_F(Journals, SayWhereTheyCannotBeWritten) {
  file = folder / "none" / "journal";
  EXPECT_THAT(message_of([&] { append("one"); }), HasSubstr("cannot be written"));
  EXPECT_TRUE(records().empty());
}

} // namespace
} // namespace bem_contact
