// Files that others have made: their index is checked, a packed one has the numbers of the one that it was
// made of.
#include "bem_contact/base/sha256.hpp"
#include "bem_contact/influence/expand.hpp"
#include "bem_contact/influence/packed_file.hpp"
#include "bem_contact/influence/prepared_files.hpp"
#include "sample_function.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>

using namespace bem_contact;
using testing::AllOf;
using testing::HasSubstr;

namespace {

const std::filesystem::path shipped = std::filesystem::path(CONFORMAL_SOURCE_DIR) / "data" / "influence";

std::string entry(const std::string& name, const std::string& bytes, const std::string& more = "") {
  return "[[file]]\nname = \"" + name +
         "\"\nbody = \"60E1\"\nkind = \"rail\"\nstrip = \"tread\"\nfrom = -1\nto = 1\n" +
         "shortest_dx = 0.2\nestimated_error = 1e-3\nbytes = " + std::to_string(bytes.size()) +
         "\nsha256 = \"" + sha256(bytes) + "\"\nversion = \"0.2.0\"\n" + more;
}

void write_text_of(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

std::string reading_index(const std::filesystem::path& folder) {
  return message_of([&] { prepared_files(folder); });
}

} // namespace

TEST(PackedFile, InfluenceNumbersMoveByLessThanAMillionthOfSelf) {
  const TemporaryFolder folder;
  for (const char* name : {"small_rail.h5", "small_wheel.h5"}) {
    const InfluenceFunction f = read_influence_file(shipped / name);
    write_packed_influence_file(folder / "packed.h5", f);
    EXPECT_LT(std::filesystem::file_size(folder / "packed.h5"),
              std::filesystem::file_size(shipped / name) / 3);
    const InfluenceFunction g = read_influence_file(folder / "packed.h5");
    EXPECT_EQ(g.remote, f.remote);
    EXPECT_NE(g.kernel, f.kernel);
    EXPECT_GT(g.estimated_error, f.estimated_error);
    for (const auto structural : {StructuralCompliance::included, StructuralCompliance::removed}) {
      ExpandOptions options;
      options.dx = 0.5;
      options.offsets = 30;
      options.structural = structural;
      options.contact_radius = f.reference_radius;
      const auto exact = expand(f, options).values, packed = expand(g, options).values;
      const double self = *std::max_element(exact.begin(), exact.end());
      for (std::size_t i = 0; i < exact.size(); ++i)
        ASSERT_NEAR(packed[i], exact[i], 1e-6 * self);
    }
  }
}

TEST(PackedFile, RoundingTwiceIsRoundingOnceAndKeepsSymmetry) {
  InfluenceFunction f = sample_function();
  const InfluenceFunction once = rounded(f);
  EXPECT_EQ(rounded(once).kernel, once.kernel);
  EXPECT_EQ(once.remote_self, f.remote_self);
  f.estimated_error = -1; // not known
  EXPECT_EQ(rounded(f).estimated_error, -1);
}

TEST(PreparedFiles, TheIndexOfTheSourcesDescribesItsFiles) {
  const std::vector<PreparedFile> files = prepared_files(shipped);
  ASSERT_EQ(files.size(), 2u);
  for (const PreparedFile& one : files) {
    EXPECT_EQ(verified_bytes(one).size(), static_cast<std::size_t>(one.bytes));
    const InfluenceFunction f = read_influence_file(one.file);
    EXPECT_EQ(f.profile, one.body);
    EXPECT_NEAR(f.ends().first, one.from, 1e-6);
    EXPECT_NEAR(f.ends().second, one.to, 1e-6);
    EXPECT_NEAR(f.estimated_error, one.estimated_error, 0.05 * f.estimated_error);
    require_as_described(one, f);
    std::array<PreparedFile, 3> others{one, one, one};
    others[0].from += 1;
    others[1].to -= 1;
    others[2].kind = one.kind == "rail" ? "wheel" : "rail";
    for (const PreparedFile& other : others)
      EXPECT_THAT(message_of([&] { require_as_described(other, f); }), HasSubstr("not the one of its index"));
  }
}

TEST(PreparedFiles, WhatIsNotThatOfTheIndexIsRefused) {
  const TemporaryFolder folder;
  write_text_of(folder / "a.h5", "abc");
  write_text_of(folder / "index.toml", entry("a.h5", "abc"));
  EXPECT_EQ(verified_bytes(prepared_files(folder / "").front()), "abc");
  std::string capitals = entry("a.h5", "abc"); // as PowerShell's Get-FileHash writes them
  const std::size_t digest = capitals.find("sha256");
  std::transform(capitals.begin() + digest + 6, capitals.begin() + capitals.find("version"),
                 capitals.begin() + digest + 6, [](unsigned char c) { return std::toupper(c); });
  write_text_of(folder / "index.toml", capitals);
  EXPECT_EQ(verified_bytes(prepared_files(folder / "").front()), "abc");
  write_text_of(folder / "a.h5", "abd");
  EXPECT_THAT(message_of([&] { verified_bytes(prepared_files(folder / "").front()); }),
              AllOf(HasSubstr("a.h5"), HasSubstr("SHA-256")));
  write_text_of(folder / "a.h5", "ab");
  EXPECT_THAT(message_of([&] { verified_bytes(prepared_files(folder / "").front()); }),
              HasSubstr("2 bytes, not 3"));
  std::filesystem::remove(folder / "a.h5");
  EXPECT_THAT(message_of([&] { verified_bytes(prepared_files(folder / "").front()); }), HasSubstr("a.h5"));
}

TEST(PreparedFiles, AWrongIndexIsRefused) {
  const TemporaryFolder folder;
  EXPECT_THAT(reading_index(folder / ""), HasSubstr("index.toml"));
  write_text_of(folder / "index.toml", entry("../a.h5", "abc"));
  EXPECT_THAT(reading_index(folder / ""),
              AllOf(HasSubstr("../a.h5"), HasSubstr("in the folder of their index")));
  write_text_of(folder / "index.toml", entry("/etc/passwd", "abc"));
  EXPECT_THAT(reading_index(folder / ""), HasSubstr("in the folder of their index"));
  write_text_of(folder / "index.toml", entry("..", "abc"));
  EXPECT_THAT(reading_index(folder / ""), HasSubstr("in the folder of their index"));
  write_text_of(folder / "index.toml", entry("a.h5", "abc", "stripe = 1\n"));
  EXPECT_THAT(reading_index(folder / ""), AllOf(HasSubstr("file.stripe"), HasSubstr("file.strip")));
  write_text_of(folder / "index.toml", "[[file]]\nname = \"a.h5\"\n");
  EXPECT_THAT(reading_index(folder / ""), HasSubstr("file.body"));
  const auto with = [&](const std::string& text, const std::string& of, const std::string& is) {
    std::string other = text;
    other.replace(other.find(of), of.size(), is);
    write_text_of(folder / "index.toml", other);
    return reading_index(folder / "");
  };
  const std::string good = entry("a.h5", "abc");
  EXPECT_THAT(with(good, "\"rail\"", "\"rale\""), HasSubstr("'rale', not rail or wheel"));
  EXPECT_THAT(with(good, "to = 1", "to = -3"), HasSubstr("from s = -1 to -3 mm"));
  EXPECT_THAT(with(good + good, "tread", "flange"), HasSubstr("'a.h5' twice"));
  EXPECT_THAT(with("# none", "none", "nothing"), HasSubstr("names none"));
  EXPECT_THAT(with(good, "version", "verse = 1\nversion"),
              HasSubstr("a prepared influence file has no such key"));
}

TEST(PreparedFiles, TheVariableNamesTheFolder) {
  setenv(prepared_variable, "/somewhere", 1);
  EXPECT_EQ(prepared_folder(), "/somewhere");
  setenv(prepared_variable, "", 1); // as if it were not set
  EXPECT_NE(prepared_folder(), "/somewhere");
  unsetenv(prepared_variable);
}
