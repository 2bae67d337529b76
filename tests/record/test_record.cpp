#include "bem_contact/record/column.hpp"
#include "bem_contact/record/csv.hpp"
#include "bem_contact/record/file_kinds.hpp"
#include "bem_contact/record/hdf5.hpp"
#include "bem_contact/record/json.hpp"
#include "bem_contact/record/text.hpp"

#include "bem_contact/base/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <limits>
#include <sstream>
#include <unistd.h>

namespace {

using namespace bem_contact;
using namespace bem_contact::record;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using json = nlohmann::json;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// One of each kind of entry.
Record sample() {
  Table patches{"patch",
                {{"Fn", "N", "normal force", {5.5, 2.5}}, {"contact", "1", "elements", {7, 3}, true}},
                Layout::rows};
  Table curve{"creepage", {{"xi", "1", "varied", {0, 1}}, {"Fx", "N", "force", {0.5, nan}}}};
  return {{"model", Text{"fem"}},
          {"certified", true},
          {"scene", Text{"a = 1\n", "as it was given"}},
          {"warnings", Texts{{"one", "two"}, "one line for each"}},
          {"structure", Record::Nothing{}},
          {"quantities", Record{{"Fx", Number{3.25, "N", "on the rail", 0.5}},
                                {"mx", Number{12, "1", "columns", {}, true}},
                                {"lateral", Number{nan, "mm", "displacement", nan}}}},
          {"patches", patches},
          {"curve", curve},
          {"p_n", field({1, 2, 3, 4, 5, 6}, "MPa", "pressure", {2, 3})}};
}

TEST(Record, IsAskedByPath) {
  const Record r = sample();
  EXPECT_EQ(number_at(r, "quantities/Fx"), 3.25);
  EXPECT_EQ(number_at(r, "quantities/Fx_error"), 0.5);
  EXPECT_EQ(number_at(r, "quantities/mx_error"), std::nullopt);
  EXPECT_EQ(number_at(r, "patches/1/Fn"), 2.5);
  EXPECT_EQ(number_at(r, "certified"), 1);
  EXPECT_EQ(text_at(r, "model"), "fem");
  EXPECT_EQ(flag_at(r, "certified"), true);
  EXPECT_THAT(values_at(r, "patches/Fn"), ElementsAre(5.5, 2.5));
  EXPECT_EQ(values_at(r, "p_n").size(), 6u);
  for (const char* wrong :
       {"", "/", "Fx", "quantities", "quantities/", "patches/2/Fn", "patches/x/Fn", "patches/-1/Fn",
        "patches/0/Fz", "p_n/0", "model/0", "structure", "quantities/Fx/0"})
    EXPECT_EQ(number_at(r, wrong), std::nullopt) << wrong;
}

TEST(Record, KnowsItsPathsAndTheNearestOnes) {
  const Record r = sample();
  for (const std::string& path : paths_of(r))
    EXPECT_TRUE(has(r, path)) << path;
  const auto refusal = [&](const char* path) { return std::string(unknown_path(r, path, "result").what()); };
  EXPECT_FALSE(has(r, "quantities/Fxx"));
  EXPECT_THAT(paths_of(r),
              testing::IsSupersetOf({"quantities/Fx", "quantities/Fx_error", "patches/0/Fn", "p_n"}));
  EXPECT_THAT(refusal("quantities/Fxx"), HasSubstr("Did you mean quantities/Fx"));
  EXPECT_THAT(refusal("Fn"), HasSubstr("Did you mean patches/0/Fn?"));
  EXPECT_THAT(refusal(std::string(3000, 'x').c_str()), HasSubstr("has nothing there"));
}

TEST(Record, AsJsonSaysEachNumberOnceWithItsErrorAndUnit) {
  const json j = json::parse(to_json(sample()));
  EXPECT_EQ(j["quantities"]["Fx"], 3.25);
  EXPECT_EQ(j["quantities"]["Fx_error"], 0.5);
  EXPECT_TRUE(j["quantities"]["mx"].is_number_integer());
  EXPECT_TRUE(j["quantities"]["lateral"].is_null());
  EXPECT_TRUE(j["quantities"]["lateral_error"].is_null());
  EXPECT_TRUE(j["structure"].is_null());
  EXPECT_EQ(j["certified"], true);
  EXPECT_EQ(j["patches"][1]["contact"], 3);
  EXPECT_EQ(j["curve"]["xi"], json({0.0, 1.0}));
  EXPECT_TRUE(j["curve"]["Fx"][1].is_null());
  EXPECT_EQ(j["p_n"][1], json({4.0, 5.0, 6.0}));
  EXPECT_EQ(j["warnings"], json({"one", "two"}));
  EXPECT_EQ(j["units"]["Fx"], "N");
  EXPECT_EQ(j["units"]["p_n"], "MPa");
}

/// A name with two units is there with its path.
TEST(Record, AsJsonTellsUnitsOfOneNameApart) {
  const Record r{{"a", Record{{"x", Number{1, "mm"}}}}, {"b", Record{{"x", Number{1, "N"}}}}};
  EXPECT_EQ(json::parse(to_json(r))["units"], json({{"x", "mm"}, {"b/x", "N"}}));
}

/// Whatever a file may hold: no text ends the writing.
TEST(Record, AsJsonTakesAnyText) {
  EXPECT_NO_THROW(json::parse(to_json(Record{{"text", Text{"\xff \" \n"}}})));
}

TEST(Record, ComesBackFromHdf5) {
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("record_" + std::to_string(getpid()) + ".h5");
  write_hdf5(file, sample());
  EXPECT_TRUE(read_h5(file).checksums);
  const Record back = read_hdf5(file);
  std::filesystem::remove(file);
  json before = json::parse(to_json(sample()));
  before.erase("structure"); // what an answer does not have is not written
  EXPECT_EQ(json::parse(to_json(back)), before);
  const auto* number = std::get_if<Number>(find(back, "quantities/Fx"));
  ASSERT_TRUE(number);
  EXPECT_EQ(number->meaning, "on the rail");
  const auto* table = std::get_if<Table>(find(back, "patches"));
  ASSERT_TRUE(table);
  EXPECT_EQ(table->row, "patch");
  EXPECT_EQ(std::get<Text>(*find(back, "scene")).meaning, "as it was given");
}

/// What a page does with numbers is a value of the record, and no word of their meaning.
TEST(Record, RolesAndChoicesComeBack) {
  const TemporaryFolder folder;
  Field keys = field({1, 0, 1}, "1", "which rail");
  keys.role = Role::swept;
  keys.choices = {"60E1", "worn rail.txt"};
  write_hdf5(folder / "s.h5", Record{{"rail.profile", keys}, {"Fx", field({1, 2, 3}, "N", "swept over")}});
  const Record back = read_hdf5(folder / "s.h5");
  EXPECT_EQ(std::get<Field>(*find(back, "rail.profile")).role, Role::swept);
  EXPECT_EQ(std::get<Field>(*find(back, "rail.profile")).choices, keys.choices);
  EXPECT_EQ(std::get<Field>(*find(back, "Fx")).role, Role::other);
  const json j = json::parse(to_described_json(back, [](std::string_view) { return false; }));
  EXPECT_EQ(j["rail.profile"]["role"], "swept");
  EXPECT_EQ(j["rail.profile"]["choices"], json({"60E1", "worn rail.txt"}));
  EXPECT_FALSE(j["Fx"].contains("role"));
}

TEST(Record, IsSaidInWords) {
  const std::string text = to_text(sample());
  EXPECT_THAT(text, HasSubstr("  certified: yes\n"));
  EXPECT_THAT(text, HasSubstr("  quantities/Fx = 3.250 +- 0.50 N: on the rail\n"));
  EXPECT_THAT(text, HasSubstr("  patches/Fn [2] N: normal force\n"));
  EXPECT_THAT(text, HasSubstr("  p_n [2][3] MPa: pressure\n"));
}

/// A page finds errors beside their values, whether they are those of a number, a column or a field.
TEST(Record, SaysErrorsToPagesBesideTheValues) {
  const auto error_of = [](const char* name, std::vector<double> values) {
    Field out = field(std::move(values), "N", "");
    out.role = Role::error;
    out.of = name;
    return out;
  };
  const Column fn{"Fn", "N", "", {5, 6}},
      error{.name = "Fn_error", .unit = "N", .values = {0.5, 0.6}, .role = Role::error, .of = "Fn"};
  const Record r{{"Fx", field({1, 2}, "N", "")},
                 {"how_wrong", error_of("Fx", {0.1, 0.2})},
                 {"Fx_error", field({3, 4}, "N", "its name says nothing")},
                 {"area_error", error_of("area", {1})}, // of nothing here
                 {"rows", Table{"row", {fn, error}}}};
  const TemporaryFolder folder;
  write_hdf5(folder / "r.h5", r);
  for (const Record& one : {r, read_hdf5(folder / "r.h5")}) {
    const json j = json::parse(to_described_json(one, [](std::string_view) { return false; }));
    EXPECT_EQ(j["Fx"]["errors"], json({0.1, 0.2}));
    EXPECT_EQ(j["rows"]["Fn"]["errors"], json({0.5, 0.6}));
    EXPECT_FALSE(j.contains("how_wrong") || j["rows"].contains("Fn_error"));
    EXPECT_EQ(j["Fx_error"]["values"], json({3, 4}));
    EXPECT_TRUE(j.contains("area_error"));
  }
}

/// The page's form: everything of a field beside its numbers; what is left out is left out.
TEST(Record, IsDescribedForPages) {
  const json j =
      json::parse(to_described_json(sample(), [](std::string_view path) { return path == "quantities/mx"; }));
  EXPECT_EQ(j["attributes"]["model"], "fem");
  EXPECT_EQ(j["attributes"]["certified"], 1);
  EXPECT_EQ(j["quantities"]["Fx"], json({{"unit", "N"},
                                         {"description", "on the rail"},
                                         {"shape", json::array()},
                                         {"values", {3.25}},
                                         {"errors", {0.5}}}));
  EXPECT_FALSE(j["quantities"].contains("Fx_error"));
  EXPECT_FALSE(j["quantities"].contains("mx"));
  EXPECT_EQ(j["patches"]["Fn"]["values"], json({5.5, 2.5}));
  EXPECT_EQ(j["p_n"]["shape"], json({2, 3}));
}

struct Load {
  double moment, share;
};

TEST(Csv, HasUnitsInItsHeadAndAnEmptyCellForNan) {
  const std::vector<ColumnOf<Load>> columns{{"Mz", "N mm", "", [](const Load& load) { return load.moment; }},
                                            {"share", "1", "", [](const Load& load) {
                                               return Measured{load.share, 0.0123456};
                                             }}};
  const std::vector<Load> rows{{1.5, 0.25}, {nan, 1.0 / 3}};
  std::ostringstream out;
  write_csv(out, table_of("load", columns, rows), 4);
  EXPECT_EQ(out.str(), "Mz_Nmm,share,share_error\n1.5,0.25,0.0123\n,0.3333,0.0123\n");
}

TEST(FileKind, IsFoundByAFormatOfAnyNumber) {
  EXPECT_EQ(kind_of("bem_contact result 2"), kind_of(result_format));
  EXPECT_EQ(kind_of("bem_contact wear"), kind_of(wear_format));
  EXPECT_NE(kind_of(result_format), nullptr);
  EXPECT_EQ(kind_of("bem_contact resultant 2"), nullptr);
  EXPECT_EQ(kind_of(""), nullptr);
  for (const FileKind& one : file_kinds)
    EXPECT_EQ(kind_of(one.format), &one);
}

} // namespace
