// A file with a dataset that is too short, empty or gone is refused by every reader, or does not matter to
// it.
#include "bem_contact/h5/handle.hpp"
#include "bem_contact/scene/choices.hpp"
#include "tests/app/run_program.hpp"

#include <gmock/gmock.h>

#include <cstddef>
#include <functional>
#include <hdf5.h>
#include <limits>
#include <vector>

namespace {

using namespace bem_contact;
using ::testing::AnyOf;
using ::testing::HasSubstr;

constexpr const char* swept_patch = R"(kind = "patch"
motion = { friction = 0.3, xi = 1e-3 }
solver.model = "halfspace"
gap = { a = 1e-3, b = 2e-3 }
grid = { dx = 0.8, ds = 0.8, mx = 12, ms = 12 }
)";
constexpr const char* worn_wheel = R"(rail.profile = "60E1"
wheel.profile = "S1002"
solver.model = "halfspace"
load.force = 8e4
motion = { xi = 2e-3, free_rolling = false }
grid = { dx = 2, ds = 1 }
sweep.position.lateral = [0.0]
)";

H5Handle opened(const std::filesystem::path& file) {
  H5Handle h5(H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
  EXPECT_GE(h5, 0) << file;
  return h5;
}

/// Names of all datasets of floating-point numbers that are not of single cases.
std::vector<std::string> datasets_of(hid_t file) {
  std::vector<std::string> names;
  const auto look = [](hid_t root, const char* name, const auto* info, void* found) -> herr_t {
    if (info->type != H5O_TYPE_DATASET || std::string(name).starts_with("cases/"))
      return 0;
    const H5Handle dataset(H5Dopen2(root, name, H5P_DEFAULT), H5Dclose), type(H5Dget_type(dataset), H5Tclose);
    if (H5Tget_class(type) == H5T_FLOAT)
      static_cast<std::vector<std::string>*>(found)->push_back(name);
    return 0;
  };
  EXPECT_GE(H5Ovisit2(file, H5_INDEX_NAME, H5_ITER_INC, look, &names, H5O_INFO_BASIC), 0);
  return names;
}

/// All numbers of a dataset, one after the other.
std::vector<double> numbers_of(hid_t file, const std::string& name) {
  const H5Handle dataset(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose),
      space(H5Dget_space(dataset), H5Sclose);
  std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  EXPECT_GE(H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
  return values;
}

/// A dataset of one axis and another length; 0: one without numbers. Its attributes stay.
void cut(hid_t file, const std::string& name, std::size_t length) {
  std::vector<double> values = numbers_of(file, name);
  values.resize(length);
  {
    const H5Handle old(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose), type(H5Dget_type(old), H5Tclose);
    const hsize_t extent = length;
    const H5Handle space(length > 0 ? H5Screate_simple(1, &extent, nullptr) : H5Screate(H5S_NULL), H5Sclose),
        now(H5Dcreate2(file, "now", type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose);
    if (length > 0) {
      EXPECT_GE(H5Dwrite(now, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
    }
    const auto copy = [](hid_t from, const char* attribute, const H5A_info_t* /*info*/, void* to) -> herr_t {
      const H5Handle before(H5Aopen(from, attribute, H5P_DEFAULT), H5Aclose),
          kind(H5Aget_type(before), H5Tclose), where(H5Aget_space(before), H5Sclose);
      const H5Handle after(
          H5Acreate2(*static_cast<hid_t*>(to), attribute, kind, where, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
      std::vector<std::byte> value(H5Tget_size(kind) *
                                   static_cast<std::size_t>(H5Sget_simple_extent_npoints(where)));
      EXPECT_GE(H5Aread(before, kind, value.data()), 0);
      EXPECT_GE(H5Awrite(after, kind, value.data()), 0);
      return H5Dvlen_reclaim(kind, where, H5P_DEFAULT, value.data()) < 0; // texts of any length
    };
    hid_t to = now;
    EXPECT_GE(H5Aiterate2(old, H5_INDEX_NAME, H5_ITER_INC, nullptr, copy, &to), 0);
  }
  EXPECT_GE(H5Ldelete(file, name.c_str(), H5P_DEFAULT), 0);
  EXPECT_GE(H5Lmove(file, "now", file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT), 0);
}

using Must = std::function<bool(const std::string& dataset)>;
const Must nothing = [](const std::string& /*dataset*/) { return false; };

class DamagedFiles : public ProgramTest {
protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("sweep.toml", std::string(swept_patch) + "sweep.load.force = [1e3, 2e3]\n");
    write("table.toml", std::string(swept_patch) + "table.load.force = [2e3, 3e3]\n");
    write("wear.toml", worn_wheel);
  }
  std::string path(const std::string& name) const { return "'" + (folder_ / name).string() + "'"; }
  void make(const std::string& arguments) const {
    const Outcome done = run(arguments);
    ASSERT_EQ(done.code, 0) << done.err;
  }
  std::string sweep() const {
    return "sweep " + path("sweep.toml") + " -o " + path("sweep.h5") + " --csv " + path("s.csv");
  }
  std::string wear_goes_on() const {
    return "wear " + path("wear.toml") + " -o " + path("worn") + " --depth 0.02";
  }

  /// Damages one dataset after the other. `must`: those that the command cannot do without.
  void check(const std::string& file, const std::string& command, const Must& must,
             std::vector<std::string> datasets = {}) const {
    const std::filesystem::path damaged = folder_ / file, whole = folder_ / "whole";
    const auto restore = [&] {
      std::filesystem::copy_file(whole, damaged, std::filesystem::copy_options::overwrite_existing);
    };
    std::filesystem::copy_file(damaged, whole, std::filesystem::copy_options::overwrite_existing);
    if (datasets.empty())
      datasets = datasets_of(opened(damaged));
    ASSERT_GT(datasets.size(), 3U);
    for (const std::string& name : datasets)
      for (const bool gone : {false, true}) {
        SCOPED_TRACE(command.substr(0, command.find(' ')) + ": " + name + (gone ? " gone" : " one less"));
        restore();
        if (const H5Handle h5 = opened(damaged); gone) {
          EXPECT_GE(H5Ldelete(h5, name.c_str(), H5P_DEFAULT), 0);
        } else {
          cut(h5, name, numbers_of(h5, name).size() - 1);
        }
        const Outcome done = run(command);
        EXPECT_THAT(done.code, AnyOf(0, 2)) << done.err;
        if (must(name)) {
          EXPECT_EQ(done.code, 2) << done.out;
          EXPECT_THAT(done.err, HasSubstr(file));
          EXPECT_THAT(done.err,
                      AnyOf(HasSubstr("'" + name + "'"), HasSubstr("has changed since it was written")));
        }
      }
    restore();
  }
};

TEST_F(DamagedFiles, OfASweepThatGoesOn) {
  make(sweep());
  check(
      "sweep.h5", sweep(),
      [](const std::string& name) { return name != "patches/case"; }, // as long as it is, the others must be
      {"status", "seconds", "cpu_seconds", "Fx", "warning_count", "model", "patches/case", "patches/patch",
       "patches/Fn"});
}

/// A status or a model that there is none of.
TEST_F(DamagedFiles, WithNumbersThatStandForNoWord) {
  make(sweep());
  const std::filesystem::path file = folder_ / "sweep.h5", whole = folder_ / "whole";
  std::filesystem::copy_file(file, whole);
  const std::pair<const char*, double> wrong[] = {{"status", 6},
                                                  {"status", std::numeric_limits<double>::quiet_NaN()},
                                                  {"model", double(model_words.size())},
                                                  {"model", -1},
                                                  {"patches/case", 2}};
  for (const auto& [name, value] : wrong) {
    SCOPED_TRACE(testing::Message() << name << " " << value);
    std::filesystem::copy_file(whole, file, std::filesystem::copy_options::overwrite_existing);
    {
      const H5Handle h5 = opened(file), dataset(H5Dopen2(h5, name, H5P_DEFAULT), H5Dclose);
      std::vector<double> values = numbers_of(h5, name);
      values[0] = value;
      EXPECT_GE(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
    }
    const Outcome done = run(sweep());
    EXPECT_EQ(done.code, 2) << done.out;
    EXPECT_THAT(done.err, HasSubstr(std::string("is damaged (its dataset '") + name + "'"));
  }
}

TEST_F(DamagedFiles, OfTables) {
  make("table " + path("table.toml") + " --tolerance 1 -o " + path("table.h5"));
  make("table --creep-forces --tolerance 0.28 --elements 6 --ratio 1:1.2 -o " + path("creep.h5"));
  const std::pair<const char*, const char*> tables[] = {{"table.h5", "2500"},
                                                        {"creep.h5", "1,1,82000,1000,0.001,0,0"}};
  for (const auto& [file, at] : tables)
    // a shorter axis is a table of which the values are too many; C11 says what kind of table it is
    check(file, "table " + path(file) + " --at=" + at, [](const std::string& name) {
      const std::string group = name.substr(0, name.find('/'));
      return (group == "values" || group == "scale" || group == "interpolation_error" ||
              group == "element_error" || group == "creep_scale") &&
             name != "creep_scale/C11";
    });
  // One number that is none was read beyond its end.
  check("table.h5", "info " + path("table.h5"), nothing);
}

TEST_F(DamagedFiles, OfWear) {
  make(wear_goes_on());
  check("worn/wear.h5", wear_goes_on(), [](const std::string& name) { // as long as these, others must be
    return name != "step" && name != "rail/depth" && name != "wheel/depth";
  });
  check("worn/wear.h5", "report " + path("worn/wear.h5") + " -o " + path("page.html"), nothing,
        {"step", "mileage", "rail/depth", "rail/profile"});
}

} // namespace
