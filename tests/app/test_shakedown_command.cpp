// `bem_contact shakedown` as a user runs it.
#include "bem_contact/h5/table.hpp"
#include "bem_contact/record/hdf5.hpp"
#include "tests/app/run_program.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace {

using namespace bem_contact;
using ::testing::HasSubstr;

/// A Hertz circle with half of the friction used.
const std::string circle =
    "kind = \"patch\"\nsolver.model = \"halfspace\"\n[motion]\nxi = 1e-3\n[load]\nforce = 1000\n"
    "[grid]\ndx = 0.1\nds = 0.1\nmx = 18\nms = 18\n[gap]\na = 0.01\nb = 0.01\n";

class ShakedownCommand : public ProgramTest {};

/// Text, JSON and HDF5 say the same.
TEST_F(ShakedownCommand, EveryDoorSaysTheSame) {
  const std::string file = write("circle.toml", circle).string(), out = (folder_ / "out.h5").string();
  const Outcome said = run("shakedown '" + file + "' --yield-shear 250 -o '" + out + "'");
  ASSERT_EQ(said.code, 0) << said.err;
  const auto json = nlohmann::json::parse(run("shakedown '" + file + "' --yield-shear 250 --json").out);
  EXPECT_THAT(said.out, HasSubstr(json["in_words"].get<std::string>()));
  EXPECT_THAT(said.out, HasSubstr("yields once (shakedown factor"));
  const record::Record stored = record::read_hdf5(out);
  for (const char* name : {"shakedown", "shakedown_upper", "first_yield"})
    EXPECT_EQ(record::number_at(stored, name).value(), json[name].get<double>()) << name;
  EXPECT_EQ(json["patches"][0]["yields"], 1);
  EXPECT_LT(json["first_yield"], 1);
  EXPECT_GT(json["shakedown"], 1);
  EXPECT_EQ(json["residual"], "all");
  EXPECT_EQ(json["sections"]["1"]["cycle"].size(), json["sections"]["1"]["s"].size());
}

TEST_F(ShakedownCommand, RefusesWhatItCannotAnswer) {
  const std::string file = write("circle.toml", circle).string();
  EXPECT_EQ(run("shakedown '" + file + "' --yield-shear 0").code, 2);
  EXPECT_EQ(run("shakedown '" + file + "' --yield-shear nan").code, 2);
  const std::string flat = CONFORMAL_SOURCE_DIR "/data/scenes/persson.toml";
  const Outcome plane = run("shakedown '" + flat + "'");
  EXPECT_EQ(plane.code, 2);
  EXPECT_THAT(plane.err, HasSubstr("There is no shakedown in plane strain"));
}

} // namespace
