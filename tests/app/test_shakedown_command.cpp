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
  const auto words = json["in_words"].get<std::string>();
  EXPECT_THAT(said.out, HasSubstr(words));
  EXPECT_EQ(said.out.find(words), said.out.rfind(words)) << "what was found is said once:\n" << said.out;
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

/// A result, its stresses in a file, and the shakedown of these: what the scene gives.
TEST_F(ShakedownCommand, TakesStressesOfAFile) {
  const std::string file = write("circle.toml", circle).string(), result = (folder_ / "r.h5").string(),
                    stresses = (folder_ / "s.h5").string();
  ASSERT_EQ(run("solve '" + file + "' -o '" + result + "'").code, 0);
  const Outcome said = run("stresses '" + result + "' -o '" + stresses + "' --csv '" +
                           (folder_ / "s.csv").string() + "' --vtu '" + (folder_ / "s.vtu").string() + "'");
  ASSERT_EQ(said.code, 0) << said.err;
  EXPECT_THAT(said.out, HasSubstr("patch 1 of the rail: von Mises"));
  EXPECT_EQ(run("stresses '" + stresses + "'").out, said.out);
  const auto of_file = nlohmann::json::parse(run("shakedown '" + stresses + "' --json").out),
             of_scene = nlohmann::json::parse(run("shakedown '" + file + "' --json").out);
  EXPECT_NEAR(of_file["shakedown"].get<double>(), of_scene["shakedown"].get<double>(), 1e-6);
  EXPECT_EQ(run("stresses '" + file + "'").code, 2);
  EXPECT_EQ(run("stresses '" + result + "' --points '" + file + "'").code, 2);
  EXPECT_EQ(run("stresses '" + result + "' --wheel").code, 2); // a patch has no wheel's profile
  EXPECT_EQ(run("stresses '" + stresses + "' --wheel").code, 2);
  EXPECT_EQ(run("stresses '" + result + "' --vtu '" + (folder_ / "s.csv").string() + "'").code, 2);
}

/// Steels, and load collectives.
TEST_F(ShakedownCommand, OfASteelAndACollective) {
  const std::string file = write("circle.toml", circle).string(),
                    many = write("many.toml", circle + "[sweep]\nload.force = [500, 1000]\n").string();
  EXPECT_THAT(run("shakedown '" + file + "' --steel ER7").out,
              HasSubstr("% of the fatigue limit in torsion of ER7, 213 MPa"));
  EXPECT_EQ(run("shakedown '" + file + "' --steel ER77").code, 2);
  const Outcome said = run("shakedown '" + many + "' --steel R260");
  EXPECT_EQ(said.code, 0) << said.err;
  EXPECT_THAT(said.out, HasSubstr("Of 2 patches"));
  const auto json = nlohmann::json::parse(run("shakedown '" + many + "' --json").out);
  EXPECT_EQ(json["patches"][1]["case"], 1);
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
