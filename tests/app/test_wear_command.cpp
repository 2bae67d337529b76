// `bem_contact wear` and `bem_contact fatigue` as a user runs them.
#include "bem_contact/base/file_lock.hpp"
#include "bem_contact/base/output_folder.hpp"
#include "bem_contact/h5/table.hpp"
#include "bem_contact/influence/influence_file.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "tests/app/run_program.hpp"

#include <cmath>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace {

using namespace bem_contact;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string scene =
    "kind = \"wheel_rail\"\nrail.profile = \"60E1\"\nwheel.profile = \"S1002\"\n"
    "solver.model = \"halfspace\"\nload.force = 8e4\n[motion]\nxi = 2e-3\nfree_rolling = "
    "false\n[grid]\ndx = 1\nds = 0.5\n[sweep]\nposition.lateral = [0.0, 1.0]\n";

/// A wheel at the gauge corner, with influence files.
const std::string small_files = CONFORMAL_SOURCE_DIR "/data/influence/",
                  corner = "rail = { profile = \"60E1\", influence = \"" + small_files +
                           "small_rail.h5\" }\nwheel = { profile = \"S1002\", influence = \"" + small_files +
                           "small_wheel.h5\" }\nsolver.model = \"fem\"\nload.force = 1e5\n[motion]\n"
                           "free_rolling = false\n[grid]\ndx = 0.5\nds = 0.5\n[sweep]\n"
                           "position.lateral = [6.6]\n";

class WearCommand : public ProgramTest {
protected:
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string text(const std::string& name) const {
    std::ifstream in(folder_ / name);
    return {std::istreambuf_iterator<char>(in), {}};
  }
};

/// One contact and both wheels of a wheelset, without a load collective: the record of the library, in words
/// and as JSON.
TEST_F(WearCommand, OneContactByKilometreAxlesAndTonnes) {
  const std::string one = write("one.toml", scene.substr(0, scene.find("[sweep]"))).string();
  const Outcome said = run("wear " + one);
  ASSERT_EQ(said.code, 0) << said.err;
  EXPECT_THAT(said.out, HasSubstr("per million axles"));
  EXPECT_THAT(said.out, HasSubstr("per MGT (axles of 16.32 t)"));
  const auto j = nlohmann::json::parse(run("wear " + one + " --json").out);
  const auto solved = nlohmann::json::parse(run("solve " + one + " --json").out);
  EXPECT_EQ(j["T_gamma"], solved["quantities"]["T_gamma"]);
  EXPECT_NEAR(j["axle_load"].get<double>(), 2 * 8e4 / 9806.65, 1e-3);
  EXPECT_NEAR(j["rail_area_per_mgt"].get<double>() * j["axle_load"].get<double>(),
              j["rail_area_per_million_axles"].get<double>(), 1e-9);
  const Outcome harder = run("wear " + one + " --law archard --hardness 1e6 --json");
  EXPECT_LT(nlohmann::json::parse(harder.out)["wheel_depth_per_km"], j["wheel_depth_per_km"]);

  std::string axle = scene.substr(0, scene.find("[sweep]"));
  axle.replace(axle.find("load.force = 8e4"), 16,
               "wheelset.force = 2e5\nposition = { lateral = 5, rail_inclination = 0.025 }");
  axle.replace(axle.find("xi = 2e-3\n"), 10, "");
  const auto both = nlohmann::json::parse(run("wear " + write("axle.toml", axle).string() + " --json").out);
  for (const char* side : {"right", "left"}) {
    EXPECT_GT(both[side]["rail_depth_per_mgt"].get<double>(), 0) << side;
    EXPECT_NEAR(both[side]["axle_load"].get<double>(), 2e5 / 9806.65, 1e-3) << side;
  }
}

TEST_F(WearCommand, AStudyHasAFolderAndOneContactHasNone) {
  const std::string one = write("one.toml", scene.substr(0, scene.find("[sweep]"))).string();
  const Outcome folder = run("wear " + one + " -o " + path("worn"));
  EXPECT_EQ(folder.code, 2);
  EXPECT_THAT(folder.err, HasSubstr("no table [sweep] with a load collective"));
  const Outcome study = run("wear " + write("scene.toml", scene).string());
  EXPECT_EQ(study.code, 2);
  EXPECT_THAT(study.err, HasSubstr("--output is not given"));
}

/// Whoever stops and goes on has the same profiles as who does not. Going on deeper needs no new beginning.
TEST_F(WearCommand, GoesOnAfterTheLastStep) {
  write("scene.toml", scene + "weight = [3, 1]\n");
  ASSERT_EQ(run("wear " + path("scene.toml") + " -o " + path("one") + " --depth 0.06").code, 0);
  ASSERT_EQ(run("wear " + path("scene.toml") + " -o " + path("two") + " --depth 0.06").code, 0);
  const auto state = [&](const char* folder) {
    std::map<std::string, std::vector<double>> values;
    for (const auto& [name, data] : read_h5(path(folder) + "/wear.h5").datasets)
      values[name] = data.values;
    return values;
  };
  EXPECT_EQ(state("one"), state("two"));
  const Outcome nothing = run("wear " + path("scene.toml") + " -o " + path("one") + " --depth 0.06");
  EXPECT_EQ(nothing.code, 0);
  EXPECT_THAT(nothing.out, HasSubstr("0 steps, 0 contact problems"));
  const Outcome deeper = run("wear " + path("scene.toml") + " -o " + path("one") + " --depth 0.07");
  EXPECT_EQ(deeper.code, 0);
  EXPECT_THAT(deeper.out, HasSubstr("continued after step"));
  EXPECT_THAT(text("one/wear.csv"), HasSubstr(",0.07,"));
  // going on from the state that the file holds is the same as never having stopped: to the last bit
  ASSERT_EQ(run("wear " + path("scene.toml") + " -o " + path("three") + " --depth 0.07").code, 0);
  ASSERT_EQ(run("wear " + path("scene.toml") + " -o " + path("four") + " --depth 0.02").code, 0);
  ASSERT_EQ(run("wear " + path("scene.toml") + " -o " + path("four") + " --depth 0.07").code, 0);
  EXPECT_EQ(state("three"), state("four"));
}

TEST_F(WearCommand, RefusesAFolderOfAnotherWear) {
  write("scene.toml", scene);
  ASSERT_EQ(run("wear " + path("scene.toml") + " -o " + path("worn") + " --depth 0.01").code, 0);
  const Outcome other =
      run("wear " + path("scene.toml") + " -o " + path("worn") + " --depth 0.01 --cap 0.005");
  EXPECT_EQ(other.code, 2);
  EXPECT_THAT(other.err, HasSubstr("exists and is not of this wear"));
  EXPECT_THAT(run("info '" + path("worn/wear.h5") + "'").out, HasSubstr("Wear of a rail and a wheel"));
  const H5Table whole = read_h5(path("worn/wear.h5"));
  const auto damaged = [&](const H5Table& state) {
    write_h5(path("worn/wear.h5"), state);
    OutputFolder(folder_ / "worn", {.maker = "wear"}).adopt("wear.h5"); // as if wear had written it
    const Outcome again = run("wear " + path("scene.toml") + " -o " + path("worn") + " --depth 0.01");
    EXPECT_EQ(again.code, 2);
    return again.err;
  };
  for (const char* lost : {"rail/depth", "wheel/profile", "mileage", "step"}) {
    H5Table less = whole;
    less.datasets.erase(lost);
    EXPECT_THAT(damaged(less),
                HasSubstr("worn/wear.h5' is damaged (it has no dataset '" + std::string(lost) + "')"));
  }
  for (const char* name : {"rail/depth", "wheel/profile", "mileage", "revolutions", "smoothing", "rail_area"})
    for (const double value : {std::nan(""), HUGE_VAL}) {
      H5Table wrong = whole;
      wrong.datasets.at(name).values.back() = value;
      EXPECT_THAT(damaged(wrong), HasSubstr("has a number that is none")) << name;
    }
  write("worn/wear.h5", text("worn/wear.h5").substr(0, 2000));
  const Outcome cut = run("wear " + path("scene.toml") + " -o " + path("worn") + " --depth 0.01");
  EXPECT_EQ(cut.code, 2);
  EXPECT_THAT(cut.err, HasSubstr("wear.h5' has changed since it was written"));
}

/// Files that no wear study wrote stay as they are.
TEST_F(WearCommand, RefusesAFolderOfOtherFiles) {
  write("scene.toml", scene);
  std::filesystem::create_directory(folder_ / "mine");
  write("mine/wear.csv", "years of measurements");
  const std::string command = "wear " + path("scene.toml") + " --depth 0.01 -o ";
  const Outcome refused = run(command + path("mine"));
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(
      refused.err,
      HasSubstr("is not one of bem_contact wear (it is not empty ('wear.csv'), and has no list "
                ".made_by_wear: its files might be overwritten) Give a new folder, or an empty one."));
  EXPECT_EQ(text("mine/wear.csv"), "years of measurements");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "mine/rail_0000.txt"));
  std::filesystem::create_directory(folder_ / "empty");
  EXPECT_EQ(run(command + path("empty")).code, 0);
}

/// A second run would overwrite what the first has finished since.
TEST_F(WearCommand, OneRunAtATimeWritesAFolder) {
  write("scene.toml", scene);
  const std::string command = "wear " + path("scene.toml") + " --depth 0.01 -o " + path("worn");
  {
    const OutputFolder begun(folder_ / "worn", {.maker = "wear"});
    const LockFile first(folder_ / "worn/wear.lock", "");
    const Outcome refused = run(command);
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.err, HasSubstr("wear.lock' is in use (another process writes it) Wait for it"));
  }
  EXPECT_EQ(run(command).code, 0);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "worn/wear.lock"));
}

/// A kill while the first state is written leaves some of its files, perhaps under a temporary name, and the
/// lock. The same command goes on.
TEST_F(WearCommand, GoesOnAfterAStopInTheFirstStep) {
  write("scene.toml", scene);
  const std::string command = "wear " + path("scene.toml") + " --depth 0.01 -o ";
  {
    OutputFolder begun(folder_ / "worn", {.maker = "wear"});
    begun.take("rail_0000.txt");
    begun.take("wheel_0000.txt");
  }
  write("worn/wear.lock", "");
  for (const char* left : {"rail_0000.txt", "wheel_0000.txt.tmp123"})
    write(std::string("worn/") + left, "0 0");
  EXPECT_EQ(run(command + path("worn")).code, 0);
  std::filesystem::create_directory(folder_ / "later");
  for (const char* left : {"rail_0000.txt", "wheel_0000.txt", "wear.csv", "rail_0001.txt"})
    write(std::string("later/") + left, "0 0");
  EXPECT_THAT(run(command + path("later")).err, HasSubstr("is not one of bem_contact wear"));
}

/// Chunks of the cases of a step start cold, however many processes share them.
TEST_F(WearCommand, SeveralProcessesShareTheCasesOfAStep) {
  std::string many = scene;
  many.replace(many.find("[0.0, 1.0]"), 10, "[0, 0.5, 1, 1.5, 2, 2.5]");
  write("scene.toml", many);
  const auto depths = [&](const std::string& jobs) {
    const Outcome said =
        run("wear " + path("scene.toml") + " --depth 0.03 -o " + path(jobs) + " --jobs " + jobs);
    EXPECT_EQ(said.code, 0) << said.err;
    return read_h5(path(jobs + "/wear.h5")).datasets.at("rail_depth").values;
  };
  const std::vector<double> alone = depths("1"), two = depths("2");
  EXPECT_EQ(two, depths("3"));
  EXPECT_EQ(text("2/rail_0001.txt"), text("3/rail_0001.txt"));
  ASSERT_EQ(two.size(), alone.size());
  for (std::size_t i = 0; i < alone.size(); ++i)
    EXPECT_NEAR(two[i], alone[i], 1e-7) << i;
  // What a process says of its case comes back.
  many.replace(many.find("2.5]"), 4, "900]");
  write("bad.toml", many);
  const Outcome refused = run("wear " + path("bad.toml") + " -o " + path("bad") + " --jobs 2");
  EXPECT_EQ(refused.code, 2);
  EXPECT_EQ(refused.err, run("wear " + path("bad.toml") + " -o " + path("bad") + " --jobs 1").err);
}

/// Text, CSV and HDF5 say how each step was smoothed; too much of it is a warning.
TEST_F(WearCommand, SaysWhatSmoothingTook) {
  write("scene.toml", scene);
  const Outcome fine = run("wear " + path("scene.toml") + " --depth 0.01 -o " + path("fine"));
  EXPECT_THAT(fine.out, HasSubstr("% off the deepest place"));
  const Outcome coarse =
      run("wear " + path("scene.toml") + " --depth 0.01 --smoothing 9 -o " + path("coarse"));
  EXPECT_THAT(coarse.out, HasSubstr("smoothed at 9.00 mm"));
  EXPECT_THAT(coarse.err, HasSubstr("give a smaller --smoothing"));
  const std::vector<double> taken = read_h5(path("coarse/wear.h5")).datasets.at("smoothed_off").values;
  EXPECT_EQ(taken.front(), 0);
  EXPECT_GT(taken.back(), 0.05);
  EXPECT_THAT(text("coarse/wear.csv"), HasSubstr("smoothing_mm,smoothed_off"));
}

/// A table of the same cases wears the same, and so does the table that a sweep writes of them.
TEST_F(WearCommand, TakesTheCollectiveOfATable) {
  const std::string alone = scene.substr(0, scene.find("position.lateral"));
  write("scene.toml", scene + "weight = [3, 1]\n");
  write("own.toml", alone + "table = \"own.csv\"\n");
  write("own.csv", "position.lateral,weight\n0,3\n1,1\n");
  write("sweep.toml", alone + "table = \"sweep.csv\"\n");
  ASSERT_EQ(run("sweep " + path("scene.toml") + " -o " + path("s.h5") + " --csv " + path("sweep.csv")).code,
            0);
  for (const char* name : {"scene", "own", "sweep"})
    ASSERT_EQ(run("wear " + path(std::string(name) + ".toml") + " -o " + path(name) + " --depth 0.01").code,
              0);
  EXPECT_EQ(text("scene/wear.csv"), text("own/wear.csv"));
  EXPECT_EQ(text("scene/wear.csv"), text("sweep/wear.csv"));
  write("own.csv", "position.lateral,weight\n0,2\n1,1\n");
  EXPECT_THAT(run("wear " + path("own.toml") + " -o " + path("own") + " --depth 0.01").err,
              HasSubstr("exists and is not of this wear"));
}

TEST_F(WearCommand, TakesTheWearMapOfTheScene) {
  const std::string kth = "[wear]\nspeeds = [200, 700]\npressures = [2400]\n"
                          "coefficients = [5.5e-4, 35e-4, 5.5e-4, 350e-4, 350e-4, 350e-4]\n";
  const auto worn = [&](const std::string& name, const std::string& map) {
    write(name + ".toml", scene + map);
    return run("wear " + path(name + ".toml") + " --law archard --depth 0.01 -o " + path(name));
  };
  const Outcome plain = worn("without", "");
  ASSERT_EQ(plain.code, 0);
  EXPECT_THAT(plain.err, Not(HasSubstr("walking pace")));
  EXPECT_THAT(
      run("wear " + path("without.toml") + " --law archard --speed 30 --depth 0.01 -o " + path("slow")).err,
      HasSubstr("--speed 30 mm/s is below walking pace: give it in mm/s"));
  ASSERT_EQ(worn("kth", kth).code, 0);
  EXPECT_EQ(text("kth/wear.csv"), text("without/wear.csv"));
  const Outcome wrong = worn("wrong", "[wear]\nspeeds = [200]\ncoefficients = [1e-4]\n");
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("1 borders of speed and 0 of pressure make 2 regions"));
  write("energy.toml", scene + kth);
  EXPECT_THAT(run("wear " + path("energy.toml") + " -o " + path("energy")).err,
              HasSubstr("There is a wear map, and the law does not use it"));
}

/// Influence functions of the unworn shape are kept for a while. Then the program says how to make new ones,
/// and takes no others.
TEST_F(WearCommand, AsksForInfluenceFunctionsOfTheWornShape) {
  write("scene.toml", corner);
  const std::string command =
      "wear " + path("scene.toml") + " -o " + path("worn") + " --depth 0.02 --cap 0.01 --kept-turn 1e-5";
  const Outcome asked = run(command);
  EXPECT_EQ(asked.code, 2) << asked.err;
  EXPECT_THAT(asked.err, HasSubstr("The rail has outgrown its influence functions"));
  EXPECT_THAT(asked.err,
              HasSubstr("tools/influence " + path("worn/rail_0001.toml") + " " + path("worn/rail_0001.h5")));
  EXPECT_THAT(text("worn/rail_0001.toml"), HasSubstr("graft_onto = \"60E1\""));
  EXPECT_THAT(text("worn/rail_0001.toml"), HasSubstr("from = -44 # mm\nto = -20\nstation_width = 0.5"));
  std::filesystem::copy(small_files + "small_rail.h5", folder_ / "worn/rail_0001.h5");
  EXPECT_THAT(run(command).err, HasSubstr("do not belong to the profile"));
}

/// A program that is given computes them, as tools/influence does, and the study goes on. The one here hands
/// out the unworn functions as those of the shapes that a study without new functions had after its first
/// step.
TEST_F(WearCommand, LetsAProgramComputeInfluenceFunctions) {
  write("scene.toml", corner);
  const std::string study = "wear " + path("scene.toml") + " --depth 0.015 --cap 0.01 ";
  ASSERT_EQ(run(study + "-o " + path("kept")).code, 0);
  for (const auto& [body, kind] :
       {std::pair("rail", ProfileKind::rail), std::pair("wheel", ProfileKind::wheel)}) {
    InfluenceFunction f = read_influence_file(small_files + "small_" + body + ".h5");
    const ProfileCurve worn = named_profile(path("kept/" + std::string(body) + "_0001.txt"), kind, {},
                                            {.profile_z = ProfileZ::down});
    f.profile = worn.name();
    f.profile_digest = worn.digest();
    write_influence_file(folder_ / (std::string(body) + "_0001.h5"), f);
  }
  write("hand_out", "#!/bin/sh\necho hands out $1\ncp " + path("") + "$(basename $2) $2\n");
  std::filesystem::permissions(folder_ / "hand_out", std::filesystem::perms::owner_all);

  const std::string command = study + "--kept-turn 1e-5 -o " + path("worn") + " --influence ";
  const Outcome failed = run(command + "false");
  EXPECT_EQ(failed.code, 2);
  EXPECT_THAT(failed.err, HasSubstr("has made no influence functions (it failed, or wrote no such file)"));
  EXPECT_THAT(run(command + path("no_such")).err,
              HasSubstr("has made no influence functions (No such file or directory)"));
  const Outcome done = run(command + path("hand_out"));
  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_THAT(done.out, HasSubstr("continued after step 1"));
  EXPECT_THAT(done.out, HasSubstr("1 step, 1 contact problem, "));
  EXPECT_THAT(done.err, HasSubstr("hands out " + path("worn/rail_0001.toml")));
  EXPECT_THAT(done.err, HasSubstr("hands out " + path("worn/wheel_0001.toml")));
  EXPECT_EQ(text("worn/wear.csv"), text("kept/wear.csv")) << "these functions are the same";
}

TEST_F(WearCommand, RefusesWhatHasNoProfiles) {
  write("scene.toml",
        "kind = \"patch\"\n[grid]\nmx = 8\nms = 8\n[gap]\na = 1e-3\nb = 1e-3\n[sweep]\nload.force "
        "= [1e3]\n");
  const Outcome refused = run("wear " + path("scene.toml") + " -o " + path("worn"));
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("This scene cannot wear (it has no profiles)"));
}

/// A scene whose steps are no solutions, and a sweep of one: the message says why.
TEST_F(WearCommand, FatigueSaysWhyACaseHasNoCertifiedResult) {
  write("steps.toml",
        "kind = \"patch\"\n[load]\nforce = 200\nforce_x = 30\n[motion]\nkind = \"transient\"\nsteps = 5\n"
        "friction = 0.3\n[grid]\ndx = 0.5\nds = 0.6\nmx = 24\nms = 20\n[gap]\na = 1e-3\nb = 1e-3\n"
        "[rail.material]\nshear_modulus = 800\npoisson = 0\n[solver]\nmax_outer = 3\n");
  const Outcome refused = run("fatigue " + path("steps.toml"));
  EXPECT_EQ(refused.code, 3);
  EXPECT_THAT(refused.err, HasSubstr("Case 0 has no certified result (step "));
  EXPECT_THAT(refused.err, HasSubstr("is not a solution: its worst violation is"));
}

TEST_F(WearCommand, FatigueHasALineForEachPatch) {
  write("scene.toml", scene);
  const Outcome done = run("fatigue " + path("scene.toml") + " --csv " + path("f.csv"));
  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_THAT(done.out, HasSubstr("2 cases, "));
  EXPECT_THAT(text("f.csv"), HasSubstr("mu_used,FI_surf"));
  const Outcome both = run("fatigue " + path("scene.toml") + " --json -o " + path("f.h5"));
  EXPECT_EQ(both.code, 0) << both.err;
  const nlohmann::json json = nlohmann::json::parse(both.out);
  const H5Table file = read_h5(path("f.h5"));
  EXPECT_EQ(json.at("cases"), 2);
  const nlohmann::json& rows = json.at("patches");
  EXPECT_EQ(rows.at(0).at("patch"), 1);
  for (const auto& [name, first] : rows.at(0).items()) {
    std::vector<double> values;
    for (const nlohmann::json& row : rows)
      values.push_back(row.at(name));
    EXPECT_EQ(file.datasets.at("patches/" + name).values, values) << name;
    EXPECT_EQ(file.datasets.at("patches/" + name).unit, json.at("units").at(name).get<std::string>()) << name;
  }
  const auto& index = file.datasets.at("patches/FI_surf").values;
  EXPECT_EQ(std::ranges::count_if(index, [](double f) { return f > 0; }), json.at("beyond_surface_limit"));
  const auto& load = file.datasets.at("patches/p0_over_k").values;
  const auto& limit = file.datasets.at("patches/p0_over_k_limit").values;
  int below = 0;
  for (std::size_t i = 0; i < load.size(); ++i)
    below += load[i] > limit[i] && index[i] <= 0;
  EXPECT_EQ(json.at("beyond_limit_below"), below);
  for (const char* count : {"beyond_surface_limit", "beyond_limit_below"})
    EXPECT_EQ(file.datasets.at(count).values.at(0), json.at(count).get<double>());
  EXPECT_THAT(done.out, HasSubstr(std::to_string(below) + " beyond that below the surface alone"));
  EXPECT_EQ(std::ranges::count(text("f.csv"), '\n'), std::ptrdiff_t(index.size()) + 1);
  EXPECT_THAT(run("info " + path("f.h5")).out, HasSubstr("Fatigue of each patch"));
  const Outcome nodes = run("fatigue " + path("scene.toml") + " --nodes 20 10 --damage 0 1");
  EXPECT_EQ(nodes.code, 2);
  EXPECT_THAT(nodes.err, HasSubstr("T-gamma must be finite, not negative, and rise"));
}

} // namespace
