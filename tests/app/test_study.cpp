#include "bem_contact/base/error.hpp"
#include "bem_contact/h5/table.hpp"
#include "bem_contact/scene/command_tables.hpp"
#include "bem_contact/scene/scene_file.hpp"
#include "tests/app/run_program.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fmt/format.h>
#include <set>
#include <sys/wait.h>
#include <thread>

namespace {

using namespace bem_contact;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string wheel_on_rail = R"(kind = "wheel_rail"
rail.profile = "60E1"
wheel.profile = "S1002"
solver.model = "halfspace"
position.rail_inclination = 0.025
load.force = 8e4
motion = { friction = 0.3, xi = 2e-3 }
grid = { dx = 2.0, ds = 1.5 }
)";

class Study : public ProgramTest {
protected:
  std::string path(const std::string& name) const { return "'" + (folder_ / name).string() + "'"; }
  Outcome study(const std::string& tables) const {
    const std::string file = write("case.toml", wheel_on_rail + tables).string();
    return run("study " + file + " -o " + path("out"));
  }
  std::set<std::string> files() const {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / "out"))
      if (const std::string name = entry.path().filename().string(); !name.starts_with(".made_by_"))
        names.insert(name);
    names.erase("study.html"); // only builds that have the plotting library make it
    return names;
  }
  H5Table answers() const { return read_h5(folder_ / "out" / "study.h5"); }
};

/// Only what is asked; one result file, a page, and a CSV file for each table.
TEST_F(Study, HasAnAnswerForEachTableAndNoOther) {
  const Outcome done = study("[conicity]\nto = 3\n[creep_curves]\nxi = \"-1e-3:1e-3:3\"\n");
  ASSERT_EQ(done.code, 0) << done.out << done.err;
  EXPECT_THAT(done.out, HasSubstr("by default: "));
  EXPECT_THAT(done.out, HasSubstr("position.gauge = 1435 mm"));
  EXPECT_EQ(files(), (std::set<std::string>{"conicity_conformity.csv", "conicity_conicity.csv",
                                            "conicity_function.csv", "creep_curves_curves_xi.csv", "parts",
                                            "solve_patches.csv", "study.csv", "study.h5"}));
  const H5Table all = answers();
  const H5Table alone = [&] {
    run("creep-curves " + path("case.toml") + " -o " + path("alone.h5"));
    return read_h5(folder_ / "alone.h5");
  }();
  EXPECT_EQ(all.datasets.at("parts/creep_curves/curves/xi/Fx").values,
            alone.datasets.at("curves/xi/Fx").values);
  EXPECT_EQ(all.datasets.at("parts/conicity/conicity/amplitude").values, (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(text_attribute(all, "taken/position.gauge/value"), "1435");
  const std::string headline = text_of(folder_ / "out" / "study.csv");
  for (const char* number :
       {"solve,quantities/pmax,", "conicity,conicity/tan_gamma at 3 mm,", "slopes: dFx/dxi,"})
    EXPECT_THAT(headline, HasSubstr(number));
}

/// What is there and still true stays; a part whose own table changes is computed again, and no other.
TEST_F(Study, ComputesOnlyWhatHasChanged) {
  ASSERT_EQ(study("[conicity]\nto = 3\n").code, 0);
  const auto when = [&](const char* part) {
    return std::filesystem::last_write_time(folder_ / "out" / "parts" / (std::string(part) + ".h5"));
  };
  const auto solved = when("solve"), steered = when("conicity");
  const Outcome again = study("[conicity]\nto = 3\n");
  EXPECT_THAT(again.out, HasSubstr("as it was"));
  EXPECT_EQ(when("conicity"), steered);
  const Outcome farther = study("[conicity]\nto = 4 # mm\n");
  EXPECT_EQ(when("solve"), solved);
  EXPECT_NE(when("conicity"), steered);
  EXPECT_EQ(answers().datasets.at("parts/conicity/conicity/amplitude").values.size(), 4U);
  write("case.toml", wheel_on_rail + "motion.eta = 1e-3\n"); // of all
  std::filesystem::remove(folder_ / "out" / "parts" / "conicity.h5");
  EXPECT_EQ(study("[position]\nlateral = 1\n[conicity]\nto = 4\n").code, 2); // given twice: not TOML
  EXPECT_EQ(study("[track]\nbase = 1510\n[conicity]\nto = 4\n").code, 0);
  EXPECT_NE(when("solve"), solved);
}

/// What other machines compute part by part is put together by the same command.
TEST_F(Study, PartByPart) {
  const std::string tables = "[conicity]\nto = 3\n[creep_curves]\nxi = \"-1e-3:1e-3:3\"\n[uncertainty]\n"
                             "friction = 0.03\ndraws = 2\nparts = \"creep_curves\"\n";
  const std::string line =
      "study " + write("case.toml", wheel_on_rail + tables).string() + " -o " + path("out");
  EXPECT_EQ(run(line + " --list").out, "solve\nconicity\ncreep_curves\ndraws/0001\ndraws/0002\n");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
  for (const char* only : {"conicity,creep_curves", "draws/0002", "solve", "draws/0001"}) {
    const Outcome part = run(line + " --only " + only);
    EXPECT_EQ(part.code, 0) << part.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out" / "study.h5"));
  }
  const auto draw = folder_ / "out" / "parts" / "draws" / "0002" / "parts" / "creep_curves.h5";
  const auto before = std::filesystem::last_write_time(draw);
  const Outcome whole = run(line);
  ASSERT_EQ(whole.code, 0) << whole.err;
  for (const char* part : {"solve", "conicity", "creep_curves"})
    EXPECT_THAT(whole.out, ContainsRegex(std::string(part) + " +(certified|done) +as it was"));
  EXPECT_EQ(std::filesystem::last_write_time(draw), before);
  const std::string file = write("case.toml", wheel_on_rail + tables).string();
  ASSERT_EQ(run("study " + file + " -o " + path("other")).code, 0);
  EXPECT_EQ(text_of(folder_ / "out" / "study.csv"), text_of(folder_ / "other" / "study.csv"));
  const Outcome wrong = run(line + " --only fatigue");
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("It has solve, conicity, creep_curves, draws/0001, draws/0002."));
}

/// A part that is refused leaves the others alone; the exit code is the worst.
TEST_F(Study, GoesOnWhereAPartIsRefused) {
  const Outcome done = study("[creep_curves]\nxi = \"1:2\"\n[conicity]\nto = 3\n");
  EXPECT_EQ(done.code, 2);
  EXPECT_THAT(done.out, HasSubstr("creep_curves  refused"));
  EXPECT_THAT(done.out, HasSubstr("FROM:TO:COUNT"));
  const H5Table all = answers();
  EXPECT_EQ(text_attribute(all, "parts/creep_curves/study_status"), "refused");
  EXPECT_EQ(text_attribute(all, "parts/solve/study_status"), "certified");
  EXPECT_TRUE(all.datasets.contains("parts/conicity/conicity/tan_gamma"));
}

/// Both wheels; the parts of one wheel take that to which the wheelset is displaced, where it stands.
TEST_F(Study, OfAWheelset) {
  std::string scene = wheel_on_rail;
  scene.replace(scene.find("load.force = 8e4"), 16, "wheelset.force = 1.6e5\nposition.lateral = 3");
  scene.replace(scene.find(", xi = 2e-3"), 11, "");
  const std::string file = write("axle.toml", scene + "[fatigue]\nyield_shear = 350\n[wear]\n").string();
  const Outcome done = run("study " + file + " -o " + path("out"));
  ASSERT_EQ(done.code, 0) << done.out << done.err;
  const H5Table all = answers();
  const auto number = [&](const char* name) { return all.datasets.at(name).values.at(0); };
  EXPECT_EQ(number("parts/fatigue/yield_shear"), 350);
  EXPECT_NEAR(number("parts/fatigue/patches/pmax") / number("parts/wheelset/right/track/pmax"), 1, 1e-3);
  EXPECT_NEAR(number("parts/wear/right/T_gamma") / number("parts/wheelset/right/track/T_gamma"), 1, 1e-6);
}

/// The influence files come from a program of the scene that the line repeats, once; then models are compared
/// with them.
TEST_F(Study, WithInfluenceFiles) {
  const std::string shipped = CONFORMAL_SOURCE_DIR "/data/influence/small_";
  write("rail.toml", "[body]\nkind = \"rail\"\nprofile = \"60E1\"\n");
  write("wheel.toml", "[body]\nkind = \"wheel\"\nprofile = \"S1002\"\n");
  const std::filesystem::path program = write("copy.sh", "#!/bin/sh\necho \"$1\" >> \"$2.calls\"\nexec cp " +
                                                             shipped + "\"$(basename \"$2\")\" \"$2\"\n");
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  const std::string scene =
      "rail = { profile = \"60E1\", influence = \"rail.h5\" }\nwheel = { profile = \"S1002\", influence = "
      "\"wheel.h5\" }\nposition.lateral = 6.6\nload.force = 1e5\ngrid = { dx = 1.0, ds = 1.0 }\n";
  const std::string tables = "[compare]\nmodels = [\"halfspace\", \"fem\"]\n[influence]\nrail = "
                             "\"rail.toml\"\nwheel = \"wheel.toml\"\nprogram = \"" +
                             program.string() + "\"\n";
  const std::string file = write("case.toml", scene + tables).string();
  EXPECT_THAT(run("study " + file + " -o " + path("out")).err, HasSubstr("The scene names the program"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "rail.h5.calls"));
  const std::string study = "study " + file + " --influence " + program.string() + " -o " + path("out");
  const Outcome done = run(study);
  ASSERT_EQ(done.code, 0) << done.out << done.err;
  EXPECT_THAT(done.out, HasSubstr("influence     done"));
  const auto pressure = [](const H5Table& in, const std::string& model, const std::string& group = "") {
    return in.datasets.at(group + "at_equal_forces/" + model + "/quantities/pmax").values.at(0);
  };
  ASSERT_EQ(run("compare " + file + " -o " + path("alone.h5")).code, 0);
  const H5Table all = answers(), alone = read_h5(folder_ / "alone.h5");
  for (const std::string model : {"halfspace", "fem"})
    EXPECT_NEAR(pressure(all, model, "parts/compare/") / pressure(alone, model), 1, 1e-9) << model;
  EXPECT_LT(pressure(all, "fem", "parts/compare/"), pressure(all, "halfspace", "parts/compare/"));
  EXPECT_THAT(text_of(folder_ / "out" / "study.csv"), HasSubstr("at_equal_forces/fem/quantities/pmax,"));
  EXPECT_THAT(run(study).out, ContainsRegex("influence +done +as it was"));
  const std::string calls = text_of(folder_ / "rail.h5.calls");
  EXPECT_EQ(std::count(calls.begin(), calls.end(), '\n'), 1);
}

/// A program that makes no influence file and says nothing in our words; the other parts go on.
TEST_F(Study, SaysWhichInfluenceFileIsMissing) {
  const std::string scene = wheel_on_rail + "rail.influence = \"none.h5\"\n[influence]\nrail = "
                                            "\"rail.toml\"\nprogram = \"false\"\n";
  const Outcome done =
      run("study " + write("case.toml", scene).string() + " --influence false -o " + path("out"));
  EXPECT_THAT(done.out, ContainsRegex("influence +failed"));
  EXPECT_THAT(done.out,
              ContainsRegex("There is no influence file '.*none.h5' \\(false .*rail.toml ended with "
                            "exit code 1\\)"));
  EXPECT_THAT(done.out, ContainsRegex("solve +certified"));
  EXPECT_EQ(done.code, 1); // that of the program
}

/// Killed in the middle, it goes on: what was whole stays, the rest is computed, and all is as in one go.
TEST_F(Study, GoesOnAfterAKill) {
  const std::string tables =
      "[conicity]\nto = 3\n[creep_curves]\nxi = \"-3e-3:3e-3:31\"\neta = \"-3e-3:3e-3:31\"\n";
  const std::string file = write("case.toml", wheel_on_rail + tables).string();
  const std::string out = (folder_ / "out").string();
  const std::filesystem::path parts = folder_ / "out" / "parts";
  const pid_t process = fork();
  ASSERT_GE(process, 0);
  if (process == 0) {
    std::freopen("/dev/null", "w", stderr);
    std::freopen("/dev/null", "w", stdout);
    execl(BEM_CONTACT, BEM_CONTACT, "study", file.c_str(), "-o", out.c_str(), nullptr);
    _exit(127);
  }
  for (int wait = 0; wait < 60000 && !std::filesystem::exists(parts / "creep_curves.json"); ++wait)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  kill(process, SIGKILL);
  waitpid(process, nullptr, 0);
  ASSERT_FALSE(std::filesystem::exists(folder_ / "out" / "study.h5"));
  ASSERT_TRUE(std::filesystem::exists(parts / "creep_curves.json")); // it had begun
  const auto when = [&](const char* part) {
    return std::filesystem::last_write_time(parts / (std::string(part) + ".h5"));
  };
  const auto solved = when("solve"), steered = when("conicity");
  const Outcome done = run("study " + file + " -o " + path("out"));
  ASSERT_EQ(done.code, 0) << done.out << done.err;
  EXPECT_EQ(when("solve"), solved);
  EXPECT_EQ(when("conicity"), steered);
  EXPECT_THAT(done.out, ContainsRegex("solve +certified +as it was"));
  EXPECT_THAT(done.out, ContainsRegex("conicity +done +as it was"));
  EXPECT_THAT(done.out, Not(ContainsRegex("creep_curves +certified +as it was")));
  ASSERT_EQ(run("study " + file + " -o " + path("whole")).code, 0);
  EXPECT_EQ(text_of(folder_ / "whole" / "study.csv"), text_of(folder_ / "out" / "study.csv"));
}

/// The load scatters by 10 %, so Hertz's largest pressure scatters by a third of that.
TEST_F(Study, SaysWhatTheInputsDo) {
  const std::string scene = "kind = \"patch\"\nload.force = 1000\nmotion.frictionless = true\n"
                            "gap = { a = 1e-2, b = 1e-2 }\ngrid = { dx = 0.1, ds = 0.1, mx = 32, ms = 32 }\n"
                            "solver.model = \"halfspace\"\n[uncertainty]\nload = 100\ndraws = 12\nseed = 3\n";
  const std::string file = write("case.toml", scene).string();
  const Outcome done = run("study " + file + " -o " + path("out"));
  ASSERT_EQ(done.code, 0) << done.out << done.err;
  const std::string csv = text_of(folder_ / "out" / "study.csv");
  const auto spread = [&](const std::string& name) {
    std::istringstream line(csv.substr(csv.find("," + name + ",") + name.size() + 2));
    std::vector<double> cells;
    for (std::string cell; cells.size() < 4 && std::getline(line, cell, ',');)
      cells.push_back(cell.empty() ? 0 : std::stod(cell));
    EXPECT_EQ(cells.at(3), 12) << name;
    return cells.at(2) / cells.at(0);
  };
  const double of_load = spread("quantities/Fz");
  EXPECT_GT(of_load, 0.04); // 12 draws
  EXPECT_LT(of_load, 0.2);
  EXPECT_NEAR(spread("quantities/pmax") / of_load, 1.0 / 3, 0.03);
  EXPECT_THAT(done.out, HasSubstr("+- inputs"));
  run("study " + file + " -o " + path("again"));
  EXPECT_EQ(text_of(folder_ / "again" / "study.csv"), csv); // the seed says it all
}

/// A command reads its table, its line comes before it, and it passes over those of the others.
TEST_F(Study, TablesGiveTheOptionsOfTheirCommands) {
  const std::string file =
      write("case.toml",
            wheel_on_rail + "[conicity]\nto = 2\nstep = 0.5\n[creep_curves]\nxi = \"0:1e-3:2\"\n")
          .string();
  EXPECT_THAT(run("conicity " + file + " --json").out, HasSubstr("1.5"));
  const Outcome line = run("conicity " + file + " --step 1 --csv " + path("c.csv"));
  EXPECT_THAT(line.out, Not(ContainsRegex("\n *1\\.5 ")));
  EXPECT_EQ(run("solve " + file).code, 0);
  const auto refused = [&](const std::string& tables, const std::string& command, const char* words) {
    const Outcome done = run(command + " " + write("wrong.toml", wheel_on_rail + tables).string());
    EXPECT_EQ(done.code, 2) << tables;
    EXPECT_THAT(done.err, HasSubstr(words)) << tables;
  };
  refused("[conicity]\nstepp = 1\n", "conicity", "Did you mean conicity.step");
  refused("[conicity]\nstepp = 1\n", "solve", "wrong.toml:10: unknown key 'conicity.stepp'");
  refused("[conicity]\nstep = \"wide\"\n", "conicity", "conicity.step cannot be used");
  refused("[wear]\ndeepth = 1\n", "solve", "Did you mean wear.depth");
  refused("[fatigues]\n", "solve", "Did you mean fatigue");
  refused("[uncertainty]\nfricton = 1\n", "study -o " + path("out"), "Did you mean uncertainty.friction");
  refused("[table]\nposition.lateral = [0, 1]\ntolerence = 0.1\n", "solve", "Did you mean table.tolerance");
}

/// The reader of scenes knows the options of each command, so that Python and C refuse what the program does.
TEST_F(Study, ScenesKnowTheOptionsOfCommands) {
  for (const char* name : {"compare", "conicity", "creep-curves", "fatigue", "table", "wear"}) {
    std::string table = name;
    std::ranges::replace(table, '-', '_');
    const std::string help = run(std::string(name) + " --help").out;
    for (const std::string_view key : option_keys(table)) {
      std::string option(key);
      std::ranges::replace(option, '_', '-');
      EXPECT_THAT(help, HasSubstr("--" + option)) << name;
      EXPECT_NO_THROW(require_known_options({fmt::format("[{}]\n{} = 1\n", table, key), "s.toml"})) << key;
    }
    const std::string wrong = fmt::format("load.force = 1e4\n[{}]\nodd_key = 1\n", table);
    EXPECT_THROW(parse_scene_file({wrong, "s.toml"}), InputError) << table;
    for (std::size_t at = help.find("\n  --"); at != std::string::npos; at = help.find("\n  --", at + 1)) {
      std::string key = help.substr(at + 5, help.find_first_of(" ,\n", at + 5) - at - 5);
      std::ranges::replace(key, '-', '_');
      const Outcome given = run(
          "check " + write("given.toml", wheel_on_rail + fmt::format("[{}]\n{} = 1\n", table, key)).string());
      const bool known = std::ranges::count(option_keys(table), key) > 0;
      EXPECT_EQ(given.err.find("unknown key") == std::string::npos, known)
          << table << " " << key << given.err;
    }
  }
}

/// What `new` writes runs as it is written.
TEST_F(Study, NewScenesRun) {
  const std::string file = path("curve.toml");
  const Outcome made = run("new --wheel S1002 --rail 60E1 --curve 300 --load 80e3 -o " + file);
  ASSERT_EQ(made.code, 0) << made.err;
  EXPECT_THAT(text_of(folder_ / "curve.toml"), HasSubstr("curve_radius = -300000"));
  EXPECT_EQ(run("check " + file).code, 0);
  EXPECT_EQ(run("new --wheel S1002 --rail 60E1 -o " + file).code, 2); // it is there
  const Outcome printed = run("new --wheel S1002 --rail 60E1");
  EXPECT_EQ(printed.code, 0);
  EXPECT_THAT(printed.out, Not(HasSubstr("curve_radius")));
  EXPECT_EQ(run("check " + write("straight.toml", printed.out).string() + " --strict").code, 0);
  EXPECT_EQ(run("new --wheel S1003 --rail 60E1").code, 2);
}

/// What `profile` advises is what `new` gives: the standard from which a wheel is worn, before a wavelength.
TEST_F(Study, NewTakesTheAdviceOfProfile) {
  const std::string wheel = CONFORMAL_SOURCE_DIR "/data/bodies/worn_wheel.txt";
  EXPECT_THAT(run("profile '" + wheel + "' --kind wheel").out, HasSubstr("nominal = \"S1002\" advised"));
  const std::string scene = run("new --wheel '" + wheel + "' --rail 60E1").out;
  EXPECT_THAT(scene, HasSubstr("wheel.nominal = \"S1002\""));
  EXPECT_THAT(scene, Not(HasSubstr("smoothing")));
}

} // namespace
