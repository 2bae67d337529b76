#include "bem_contact/app/commands/start_python.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/h5/table.hpp"
#include "bem_contact/influence/influence_function.hpp"
#include "bem_contact/scene/scene_file.hpp"
#include "tests/app/run_program.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <regex>
#include <sys/stat.h>
#include <thread>

namespace {

using namespace bem_contact;
using nlohmann::json;
using ::testing::HasSubstr;

const std::string hertz = "kind = \"patch\"\n[load]\nforce = 1e4\n[motion]\nfriction = 0.3\nxi = 1e-3\n"
                          "[grid]\ndx = 0.5\nds = 0.5\nmx = 16\nms = 16\n[gap]\na = 1e-3\nb = 1e-3\n";
const std::string wheel_rail = "kind = \"wheel_rail\"\nrail.profile = \"60E1\"\nwheel.profile = \"S1002\"\n"
                               "load.force = 1e4\nmotion.frictionless = true\n[grid]\ndx = 1.0\nds = 0.5\n";

class CommandLine : public ProgramTest {
protected:
  /// Exit code 2, nothing on standard output, every one of the words in the message.
  void refused(const Outcome& run, const std::vector<std::string>& words) {
    EXPECT_EQ(run.code, 2) << run.err;
    EXPECT_EQ(run.out, "");
    for (const std::string& word : words)
      EXPECT_THAT(run.err, HasSubstr(word));
  }
};

TEST_F(CommandLine, EveryModelIsExplainedAndCanBeAskedFor) {
  const std::string help = run("solve --help").out, scene = write("s.toml", hertz).string();
  for (const ModelWords& words : model_words) {
    EXPECT_THAT(help, HasSubstr(fmt::format("  {:<13}  {}\n", words.name, words.help)));
    const Outcome r = run(fmt::format("solve '{}' --model {}", scene, words.name));
    EXPECT_THAT(r.err, ::testing::Not(HasSubstr("--model"))) << "the option knows it";
  }
  refused(run(fmt::format("solve '{}' --model gummy", scene)),
          {"gummy", std::string(model_words.back().name)});
}

TEST_F(CommandLine, SolvePrintsOneJsonObject) {
  const Outcome r = run("solve '" + write("s.toml", hertz).string() + "' --json");
  ASSERT_EQ(r.code, 0) << r.err;
  const json j = json::parse(r.out); // throws unless it is exactly one object
  EXPECT_EQ(j["model"], "halfspace");
  EXPECT_NE(j["why_this_model"], "");
  ASSERT_EQ(j["patches"].size(), 1u);
  for (const char* key : {"Fn", "Fx", "Fs", "overlap", "pmax", "area", "contact", "adhesion", "slip"})
    EXPECT_TRUE(j["patches"][0][key].is_number()) << key;
  EXPECT_EQ(j["patches"][0]["contact"].get<int>(),
            j["patches"][0]["adhesion"].get<int>() + j["patches"][0]["slip"].get<int>());
  EXPECT_NEAR(j["quantities"]["Fz"].get<double>(), 1e4, 1e-2);
  EXPECT_GT(j["quantities"]["Fx"].get<double>(), 0); // the wheel drags the rail along
  for (const char* key : {"Fx", "Fy", "Fz", "Mz"})
    EXPECT_TRUE(j["quantities"][key].is_number()) << key;
  for (const char* key : {"pressure", "penetration", "complementarity", "friction_cone", "adhesion",
                          "slip_direction", "force_balance"})
    EXPECT_LE(j["certificate"][key].get<double>(), 1e-6) << key;
  EXPECT_LE(j["quantities"]["certificate"].get<double>(), 1e-6);
  EXPECT_TRUE(j["certified"].get<bool>());
  for (const char* key : {"geometry", "numbers", "solve", "total"})
    EXPECT_GE(j["seconds"][key].get<double>(), 0) << key;
}

/// No shear is asked for: no tangential problem is solved, and nothing is prepared for one.
TEST_F(CommandLine, FrictionlessScenesSolveNoTangentialProblem) {
  const auto solved = [&](const std::string& motion) {
    std::string scene = hertz;
    const std::size_t from = scene.find("friction"), to = scene.find("[grid]");
    const Outcome r = run("solve '" + write("s.toml", scene.replace(from, to - from, motion)).string() +
                          "' --json --model halfspace");
    EXPECT_EQ(r.code, 0) << r.err;
    json j = json::parse(r.out), out = j["solver"];
    out.update(j["quantities"]);
    return out;
  };
  const json with = solved("friction = 0.3\nxi = 1e-3\n");
  EXPECT_GT(with["tangential_iterations"], 0);
  const json without = solved("frictionless = true\n");
  EXPECT_EQ(without["tangential"], "none");
  EXPECT_EQ(without["tangential_iterations"], 0);
  EXPECT_EQ(without["outer_iterations"], 1);
  EXPECT_LT(without["work"], with["work"]);
}

/// Influence files that are not there are no obstacle where auto takes the half-space.
TEST_F(CommandLine, InfluenceFilesAreOpenedOnlyIfTheyAreNeeded) {
  const std::string scene = "kind = \"wheel_rail\"\nload.force = 1e4\nmotion.frictionless = true\n"
                            "[rail]\nprofile = \"60E1\"\ninfluence = \"no_rail.h5\"\n"
                            "[wheel]\nprofile = \"S1002\"\ninfluence = \"no_wheel.h5\"\n"
                            "[grid]\ndx = 1.0\nds = 0.5\n";
  const std::string file = write("s.toml", scene).string();
  const Outcome chosen = run("solve '" + file + "' --json");
  ASSERT_EQ(chosen.code, 0) << chosen.err;
  EXPECT_NE(json::parse(chosen.out)["model"], "fem");
  refused(run("solve '" + file + "' --model fem"),
          {"no_rail.h5", "there is no such file", "from the body file: tools/influence BODY.toml"});
}

/// In steady state friction dissipates what the creepages supply, xi Fx + eta Fy + phi Mz (V = 1).
TEST_F(CommandLine, FrictionDissipatesWhatTheCreepagesSupply) {
  const Outcome r = run("solve '" CONFORMAL_SOURCE_DIR "/data/scenes/steady_rolling.toml' --json");
  ASSERT_EQ(r.code, 0) << r.err;
  const json totals = json::parse(r.out)["quantities"];
  const auto number = [&](const char* key) { return totals[key].get<double>(); };
  const double supplied = 8e-4 * number("Fx") + 6e-4 * number("Fy") + 5e-4 * number("Mz");
  EXPECT_NEAR(number("T_gamma"), supplied, 0.01 * supplied);
}

TEST_F(CommandLine, ForcesPrescribedTellTheirCreepages) {
  std::string forced = hertz;
  forced.insert(forced.find("[motion]"), "force_x = 800\n");
  const Outcome r = run("solve '" + write("s.toml", forced).string() + "' --json");
  ASSERT_EQ(r.code, 0) << r.err;
  const json j = json::parse(r.out);
  EXPECT_NEAR(j["quantities"]["Fx"].get<double>(), 800, 1e-2);
  EXPECT_LT(j["quantities"]["creepage_x"].get<double>(), 0) << "1e-3 alone gives more";
  EXPECT_EQ(j["quantities"]["creepage_s"], 0);
  EXPECT_THAT(run("solve '" + (folder_ / "s.toml").string() + "'").out, HasSubstr("creepages found"));
}

TEST_F(CommandLine, AHistoryHasOneObjectAStep) {
  write("steps.csv", "force_x\n1000\n2000\n0\n");
  std::string shift = hertz;
  shift.insert(shift.find("[motion]"), "force_x = 0\n");
  shift.replace(shift.find("xi = 1e-3"), 9, "kind = \"shift\"\nstep_table = \"steps.csv\"");
  const std::string scene = write("s.toml", shift).string(), file = (folder_ / "r.h5").string();
  const Outcome r = run("solve '" + scene + "' --json -o '" + file + "'");
  ASSERT_EQ(r.code, 0) << r.err;
  const json j = json::parse(r.out);
  ASSERT_EQ(j["history"].size(), 3u);
  EXPECT_NEAR(j["history"][1]["Fx"].get<double>(), 2000, 1e-2);
  EXPECT_GT(j["history"][1]["creepage_x"].get<double>(), 0);
  EXPECT_NEAR(j["quantities"]["Fx"].get<double>(), 0, 1e-2);
  const H5Table table = read_h5(file);
  EXPECT_THAT(table.datasets.at("step_fields/p_x").shape, ::testing::ElementsAre(3, 16, 16));
  EXPECT_NEAR(table.datasets.at("history/Fx").values.at(1), 2000, 1e-2);
  for (const char* name : {"u_x", "u_s", "u_n", "friction_work_density", "friction_work"})
    EXPECT_THAT(table.datasets.at(name).shape, ::testing::ElementsAre(16, 16));
  EXPECT_EQ(table.datasets.at("slip_x").unit, "mm");
  EXPECT_THAT(run("check '" + scene + "'").out, HasSubstr("shift in 3 steps"));
  refused(run("solve '" + scene + "' -o '" + (folder_ / "steps.csv").string() + "'"), {"would overwrite"});
}

TEST_F(CommandLine, SolvePrintsATableForPeople) {
  const Outcome r = run("solve '" + write("s.toml", wheel_rail).string() + "' --model halfspace");
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("certified: yes, worst violation"));
  EXPECT_THAT(r.out, HasSubstr("Fz 10000.0 N"));
}

TEST_F(CommandLine, CheckSolvesNothing) {
  const Outcome r = run("check '" + write("s.toml", wheel_rail).string() + "'");
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("touch point"));
}

TEST_F(CommandLine, CheckReadsItsSceneOnceSoItMayBeAPipe) {
  const std::filesystem::path file = write("s.toml", wheel_rail), pipe = folder_ / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&] { std::ofstream(pipe) << wheel_rail; });
  const Outcome r = run("check '" + pipe.string() + "'");
  writer.join();
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("touch point"));
  EXPECT_EQ(r.out, run("check '" + file.string() + "'").out) << r.err;
}

TEST_F(CommandLine, ThePrintedDefaultIsAScene) {
  const Outcome r = run("--print-default");
  EXPECT_EQ(r.code, 0);
  EXPECT_NO_THROW(parse_scene_file(r.out));
}

TEST_F(CommandLine, CompareSaysAWarningOnceWithWhatItIsAbout) {
  std::string scene = hertz;
  scene.replace(scene.find("friction = 0.3"), 14, "friction = 30");
  const Outcome r = run("compare '" + write("s.toml", scene).string() + "' --models halfspace,tangent_plane");
  EXPECT_EQ(r.code, 0) << r.err;
  const auto at = r.err.find("motion.friction = 30: ");
  ASSERT_NE(at, std::string::npos) << r.err;
  EXPECT_EQ(r.err.find("motion.friction = 30: ", at + 1), std::string::npos) << r.err;
  EXPECT_THAT(r.err, HasSubstr("halfspace at equal forces, tangent_plane at equal forces"));
}

/// The same words with other figures: one warning, with the places of the others.
TEST_F(CommandLine, CompareCountsWarningsThatDifferInFigures) {
  const Outcome r = run("compare " CONFORMAL_SOURCE_DIR "/data/scenes/conformal_small.toml");
  const std::string words = "above three times the yield strength";
  const auto at = r.err.find(words);
  ASSERT_NE(at, std::string::npos) << r.err;
  EXPECT_EQ(r.err.find(words, at + 1), std::string::npos) << r.err;
  EXPECT_THAT(r.err, HasSubstr("[3 more with other figures: fem at equal forces"));
}

/// 18 elements: nothing is said of errors but why, and what to do.
TEST_F(CommandLine, ACoarseGridSaysWhyThereAreNoErrors) {
  std::string coarse = hertz;
  for (const char* size : {"dx = 0.5", "ds = 0.5"})
    coarse.replace(coarse.find(size), 8, std::string(size, 5) + "1.0");
  const std::string scene = write("coarse.toml", coarse).string();
  EXPECT_THAT(run("solve '" + scene + "'").out,
              ::testing::ContainsRegex("no errors .* are stated: .* 40 are needed. Give smaller elements"));
  EXPECT_THAT(json::parse(run("solve '" + scene + "' --json").out)["why_no_errors"].get<std::string>(),
              HasSubstr("Give smaller elements"));
  std::string fine = hertz;
  for (const char* size : {"dx = 0.5", "ds = 0.5"})
    fine.replace(fine.find(size), 8, std::string(size, 5) + "0.25");
  for (const char* size : {"mx = 16", "ms = 16"})
    fine.replace(fine.find(size), 7, std::string(size, 5) + "32");
  const std::string fine_scene = write("fine.toml", fine).string();
  EXPECT_TRUE(json::parse(run("solve '" + fine_scene + "' --json").out)["why_no_errors"].is_null());
}

TEST_F(CommandLine, TextHasNoInsiderWordsAndNoSlipWithoutFriction) {
  const Outcome r = run("solve '" + write("s.toml", wheel_rail).string() + "' --model halfspace");
  EXPECT_THAT(r.out, HasSubstr("Fz 10000.0 N"));
  for (const char* word : {"slip", "adhesion", "outer iterations"})
    EXPECT_THAT(r.out, ::testing::Not(HasSubstr(word)));
  const std::string influence = run("info " CONFORMAL_SOURCE_DIR "/data/influence/small_rail.h5").out;
  EXPECT_THAT(influence, HasSubstr("rail 60E1"));
  for (const char* word : {"self number", "digest"})
    EXPECT_THAT(influence, ::testing::Not(HasSubstr(word)));
}

/// Of a wheel on a rail with friction, free rolling takes as long as the case itself.
TEST_F(CommandLine, SecondsNameFreeRollingAndSearch) {
  std::string scene = wheel_rail;
  scene.replace(scene.find("motion.frictionless = true"), 26, "load.force_y = 2e3\nmotion.friction = 0.3");
  const std::string file = write("s.toml", scene).string();
  const json seconds = json::parse(run("solve '" + file + "' --json").out)["seconds"];
  EXPECT_GT(seconds["free_rolling"].get<double>(), 0);
  EXPECT_GT(seconds["search"].get<double>(), 0);
  EXPECT_THAT(run("solve '" + file + "'").out,
              ::testing::ContainsRegex("free rolling [0-9.]+, search of the displacement [0-9.]+, total"));
}

/// check searches for nothing, so it says which position its description is of.
TEST_F(CommandLine, CheckSaysWhereTheSearchOfALateralForceBegins) {
  const std::string without = run("check '" + write("s.toml", wheel_rail).string() + "'").out;
  EXPECT_THAT(without, ::testing::Not(HasSubstr("lateral force")));
  const std::string with =
      run("check '" + write("f.toml", "load.force_y = 2e3\nposition.lateral = 1.5\n" + wheel_rail).string() +
          "'")
          .out;
  EXPECT_THAT(with, HasSubstr("lateral force 2000 N: solve looks for the lateral displacement"));
  EXPECT_THAT(with, HasSubstr("position.lateral = 1.5 mm"));
}

TEST_F(CommandLine, CheckTakesSweepsAndWheelsets) {
  const std::string sweep = "\n[sweep]\nposition.lateral = [ 0.0, 3.0, 6.0 ]\n";
  const Outcome r = run("check '" + write("s.toml", wheel_rail + sweep).string() + "' --strict");
  EXPECT_EQ(r.code, 0) << r.err;
  for (const char* words : {"case 1 of 3: position.lateral = 0", "case 3 of 3: position.lateral = 6",
                            "first grid: ", "model: auto, which takes "})
    EXPECT_THAT(r.out, HasSubstr(words));
  refused(run("check '" +
              write("bad.toml", wheel_rail + "\n[sweep]\nload.force = [ 1e4, -1.0, 1e4 ]\n").string() + "'"),
          {"load.force"});
  std::string wheelset = wheel_rail;
  wheelset.replace(wheelset.find("load.force = 1e4"), 16, "wheelset.force = 1e5");
  const Outcome both = run("check '" + write("w.toml", wheelset).string() + "'");
  EXPECT_EQ(both.code, 0) << both.err;
  for (const char* words :
       {"equilibrium begins at a lateral displacement of 0 mm", "right wheel", "left wheel"})
    EXPECT_THAT(both.out, HasSubstr(words));
}

/// Messages come between lines, each once.
TEST_F(CommandLine, AMessageComesOnceAndBetweenLines) {
  std::string points;
  for (int i = 0; i <= 700; ++i) {
    const double y = -60 + 0.15 * i;
    points += fmt::format("{:.3f} {:.4f}\n", y, 0.025 * y + (i == 350 ? 0.2 : 0.0));
  }
  const std::string cone = write("cone.txt", points).string();
  const Outcome r = run("conicity --rail 60E1 --wheel '" + cone + "' --left-wheel '" + cone + "' --to 2");
  const auto at = r.err.find("may split patches");
  ASSERT_NE(at, std::string::npos) << r.err;
  EXPECT_EQ(r.err.rfind("may split patches"), at) << "said once";
  EXPECT_THAT(r.err, HasSubstr("info: 2 times: cone.txt: its points scatter by"));
  const Outcome table = run("solve '" + write("s.toml", wheel_rail).string() + "' --model halfspace -o '" +
                            (folder_ / "r.h5").string() + "'");
  const std::string info = run("info '" + (folder_ / "r.h5").string() + "'").out;
  EXPECT_THAT(info, ::testing::ContainsRegex("Main results\n  result: Fx 0.00 N.* certified\n"));
}

TEST_F(CommandLine, ReportSaysWhatItTakes) {
  refused(run("report '" + write("fatigue.csv", "case,patch\n").string() + "' -o '" +
              (folder_ / "r.html").string() + "'"),
          {"fatigue.csv", "report takes what solve, compare", "spreadsheet"});
}

/// A shift is a length; each number has at least the digits of its error, and there is no -0.
TEST_F(CommandLine, AShiftAndItsForcesHaveTheDigitsOfTheirErrors) {
  const std::string out = run("solve '" CONFORMAL_SOURCE_DIR "/data/scenes/cattaneo.toml'").out;
  EXPECT_THAT(out, HasSubstr("shift found for the shear forces: along x +0.0081"));
  EXPECT_THAT(out, ::testing::ContainsRegex("along x [+]0[.][0-9]* [+]- 0[.][0-9]* mm, along s [+]0 mm"));
  EXPECT_THAT(out, ::testing::Not(::testing::ContainsRegex("-0[.]0* ")));
  int checked = 0;
  const std::regex form(R"(([0-9.]+) \+- ([0-9]+\.[0-9]+)( |;))");
  for (auto found = std::sregex_iterator(out.begin(), out.end(), form); found != std::sregex_iterator();
       ++found) {
    const auto decimals = [&](int group) {
      const std::string text = (*found)[group];
      return text.find('.') == text.npos ? 0 : text.size() - text.find('.') - 1;
    };
    EXPECT_GE(decimals(1), decimals(2)) << found->str();
    ++checked;
  }
  EXPECT_GE(checked, 5) << out;
}

/// At most one digit more than the error has.
TEST_F(CommandLine, NumbersHaveNoMoreDigitsThanTheirErrorAllows) {
  std::string scene = wheel_rail;
  scene.replace(scene.find("motion.frictionless = true"), 26, "motion.friction = 0.3");
  scene.replace(scene.find("1e4"), 3, "1e5");
  const std::string file = write("s.toml", scene).string();
  const std::string out = run("solve '" + file + "' --model halfspace").out;
  EXPECT_THAT(out, ::testing::ContainsRegex("Mz -?[0-9]+ \\+- [0-9][0-9][0-9]+ N mm")) << out;
}

TEST_F(CommandLine, NoContactIsZeroForceAndSuccess) {
  std::string scene = hertz;
  scene.replace(scene.find("force = 1e4"), 11, "approach = -0.01");
  const Outcome r = run("solve '" + write("s.toml", scene).string() + "' --json");
  ASSERT_EQ(r.code, 0) << r.err;
  const json j = json::parse(r.out);
  EXPECT_EQ(j["quantities"]["Fz"].get<double>(), 0);
  EXPECT_TRUE(j["patches"].empty());
}

TEST_F(CommandLine, LackOfConvergenceIsThree) {
  // One outer iteration is too few for unlike bodies: a result is printed, and it is not called one.
  const std::string scene =
      hertz + "[wheel.material]\nshear_modulus = 800\npoisson = 0\n[solver]\nmax_outer = 1\n";
  const Outcome r = run("solve '" + write("s.toml", scene).string() + "' --json");
  EXPECT_EQ(r.code, 3) << r.out;
  EXPECT_FALSE(json::parse(r.out)["certified"].get<bool>());
  EXPECT_THAT(r.err, HasSubstr("is not a solution"));
}

/// Each case of a sweep says why as solve does; its reason may be that of a step before the last.
TEST_F(CommandLine, ASweepAndSolveNameTheStepThatFailed) {
  std::string scene = hertz + "[wheel.material]\nshear_modulus = 800\npoisson = 0\n[solver]\nmax_outer = 1\n";
  scene.replace(scene.find("force = 1e4"), 11, "approach = 0.01");
  scene.replace(scene.find("friction"), 0, "kind = \"shift\"\nstep_table = \"steps.csv\"\n");
  write("steps.csv", "load\n0.01\n-0.01\n");
  const Outcome r = run("solve '" + write("s.toml", scene).string() + "'");
  EXPECT_EQ(r.code, 3) << r.err;
  EXPECT_THAT(r.err, HasSubstr("step 1 of 2 is not a solution: its worst violation is"));
  const auto csv = folder_ / "s.csv";
  EXPECT_EQ(run("sweep '" + write("sweep.toml", scene + "[sweep]\nmotion.xi = [1e-3]\n").string() + "' -o '" +
                (folder_ / "s.h5").string() + "' --csv '" + csv.string() + "'")
                .code,
            3);
  EXPECT_THAT(text_of(csv), HasSubstr("step 1 of 2 is not a solution: its worst violation is"));
}

TEST_F(CommandLine, WrongArgumentsAreTwo) {
  EXPECT_EQ(run("").code, 2);
  refused(run("solve"),
          {"error: The arguments cannot be used (scene is required) See bem_contact solve --help."});
  refused(run("solve x.toml --thread 3"), {"There is no option '--thread'", "Did you mean --threads?"});
  refused(run("influence expand --centr 3"), {"(bem_contact influence expand has others)", "--centre"});
  refused(run("solve x.toml --threads 0"), {"(--threads: Value 0 not in range ", "64"});
  refused(run("conicity --wheel S1002"), {"--rail is not given", "--rail 60E1"});
  refused(run("dissolve x.toml"), {"There is no command 'dissolve'", "Did you mean solve?"});
  const std::string scene = write("s.toml", hertz).string();
  refused(run("'" + scene + "'"), {"Did you mean bem_contact solve " + scene});
  EXPECT_EQ(run("solve x.toml --model magic").code, 2);
  const Outcome help = run("--help");
  EXPECT_EQ(help.code, 0);
  EXPECT_THAT(help.out, HasSubstr("Exit code 0"));
  EXPECT_EQ(help.err, "");
}

TEST_F(CommandLine, MissingSceneIsRefused) {
  refused(run("solve '" + (folder_ / "nowhere.toml").string() + "'"), {"nowhere.toml"});
}

TEST_F(CommandLine, UnknownKeyIsRefusedWithTheNearestName) {
  refused(run("solve '" + write("s.toml", hertz + "[solver]\ntolerence = 1e-8\n").string() + "'"),
          {"tolerence", "tolerance"});
}

TEST_F(CommandLine, NotANumberIsRefused) {
  std::string scene = hertz;
  scene.replace(scene.find("a = 1e-3"), 8, "a = nan");
  refused(run("solve '" + write("s.toml", scene).string() + "' --json"), {"gap.a"});
}

/// Whatever option takes a number: the library reads nan and inf, and -1 as the largest count.
TEST_F(CommandLine, OptionsRefuseNumbersThatAreNone) {
  const std::string wear = "wear '" CONFORMAL_SOURCE_DIR "/data/scenes/wear_collective.toml' -o w ";
  for (const auto& [arguments, words] :
       {std::pair<std::string, const char*>{"profile S1002 --step nan", "--step: nan is no finite number"},
        {"profile S1002 --smoothing=-nan", "-nan is no finite number"},
        {wear + "--kept-turn nan", "--kept-turn: nan is no finite number"},
        {wear + "--cap inf", "--cap: Value inf not in range"},
        {wear + "--smoothing NAN", "NAN is no finite number"},
        {"conicity --wheel S1002 --rail 60E1 --gauge 1e999", "1e999 is no finite number"},
        {"conicity --wheel S1002 --rail 60E1 --step nan", "nan is no finite number"},
        {"fatigue s.toml --nodes nan 1 2", "nan is no finite number"},
        {"fatigue s.toml --yield-shear nan", "nan is no finite number"},
        {"influence expand a.h5 --dx nan --ds 1 --mx 2 --my 2 -o x", "nan is no finite number"},
        {"table --creep-forces -o o.h5 --tolerance nan", "nan is no finite number"},
        {"table --creep-forces -o o.h5 --ratio 0.5:nan", "--ratio '0.5:nan' cannot be read"},
        {"table --creep-forces -o o.h5 --most-points -1", "-1 is below 0"},
        {"table --creep-forces -o o.h5 --most-points=-1", "-1 is below 0"}}) {
    const Outcome refused = run(arguments);
    EXPECT_EQ(refused.code, 2) << arguments;
    EXPECT_THAT(refused.err, HasSubstr(words)) << arguments;
  }
}

TEST_F(CommandLine, ZeroFrictionIsRefused) {
  std::string scene = hertz;
  scene.replace(scene.find("friction = 0.3"), 14, "friction = 0.0");
  refused(run("solve '" + write("s.toml", scene).string() + "'"), {"friction", "frictionless"});
}

TEST_F(CommandLine, EmptyProfileIsRefused) {
  write("empty.prr", "");
  std::string scene = wheel_rail;
  scene.replace(scene.find("60E1"), 4, "empty.prr");
  refused(run("solve '" + write("s.toml", scene).string() + "'"), {"empty.prr"});
}

TEST_F(CommandLine, FemWithoutInfluenceFilesIsRefused) {
  const std::string scene = write("s.toml", hertz).string();
  refused(run("solve '" + scene + "' --model fem"), {"influence functions of both bodies"});
  refused(run("compare '" + scene + "'"), {"influence functions of both bodies"});
}

TEST_F(CommandLine, MissingInfluenceFileIsRefused) {
  const std::string scene =
      hertz + "[rail]\ninfluence = \"nowhere.h5\"\n[wheel]\ninfluence = \"nowhere.h5\"\n";
  refused(run("solve '" + write("s.toml", scene).string() + "'"), {"nowhere.h5"});
}

TEST_F(CommandLine, AnUnwritableResultIsRefused) {
  const Outcome r =
      run("solve '" + write("s.toml", hertz).string() + "' -o '" + (folder_ / "no/such/r.h5").string() + "'");
  refused(r, {"r.h5", "cannot be written"});
}

/// The name can be written to, and the disk is full: the machine is to blame, not the input.
TEST_F(CommandLine, AFullDiskIsOne) {
  const std::string scene = write("s.toml", hertz).string();
  for (const std::string& command : {std::string("conicity --wheel S1002 --rail 60E1 --csv /dev/full"),
                                     "solve '" + scene + "' --vtk /dev/full"}) {
    const Outcome r = run(command);
    EXPECT_EQ(r.code, 1) << command;
    EXPECT_THAT(r.err, HasSubstr("The file '/dev/full' cannot be written (No space left"));
  }
}

TEST_F(CommandLine, NamesOfOtherKindsOfFilesAreRefused) {
  const std::string scene = write("s.toml", hertz).string();
  refused(run("solve '" + scene + "' -o a.csv"),
          {"a.csv' of --output would have a misleading name", "an HDF5 file", "ends with .h5"});
  refused(run("solve '" + scene + "' --vtk a.vtk"), {"in XML", "ends with .vts"});
  refused(run("conicity --wheel S1002 --rail 60E1 --csv c.xlsx"),
          {"c.xlsx' of --csv would have a misleading name", "ends with .csv"});
  refused(run("profile S1002 --csv p.h5"), {"p.h5' of --csv", "ends with .csv"});
  refused(run("profile S1002 --plot p.pdf"), {"p.pdf' of --plot", "ends with .html"});
  const std::string file = (folder_ / "r.h5").string();
  ASSERT_EQ(run("solve '" + scene + "' -o '" + file + "'").code, 0);
  refused(run("report '" + file + "' -o r.pdf"), {"r.pdf' of --output", "a page (HTML)", "ends with .html"});
}

TEST_F(CommandLine, AResultIsNoScene) {
  const std::string file = (folder_ / "r.h5").string();
  ASSERT_EQ(run("solve '" + write("s.toml", hertz).string() + "' -o '" + file + "'").code, 0);
  for (const char* command : {"fatigue", "check", "wheelset", "conicity"})
    refused(run(std::string(command) + " '" + file + "'"),
            {"is no scene", "HDF5 file: a result file", "bem_contact info"});
}

TEST_F(CommandLine, WithoutPythonPlotNamesThePackages) {
  try {
    app::become_python("/no/such/python3", "bem_contact.plotting", {"r.h5"});
  } catch (const InputError& error) { // exit code 2
    EXPECT_THAT(error.what(), HasSubstr("there is no '/no/such/python3'"));
    EXPECT_THAT(error.what(), HasSubstr("apt-get install python3 python3-h5py python3-matplotlib"));
  }
}

TEST_F(CommandLine, AFolderIsNoOutputAndNothingIsLeftBesideIt) {
  const std::string scene = write("s.toml", hertz).string();
  std::filesystem::create_directory(folder_ / "taken");
  for (const char* option : {" -o '", " --vtk '"})
    refused(run("solve '" + scene + "'" + option + (folder_ / "taken").string() + "'"),
            {"cannot be written"});
  for (const auto& entry : std::filesystem::directory_iterator(folder_))
    EXPECT_THAT(entry.path().filename().string(), testing::Not(HasSubstr(".tmp")));
}

TEST_F(CommandLine, AnOutputNeverReplacesAnInput) {
  const std::string scene = write("s.toml", hertz).string();
  refused(run("solve '" + scene + "' -o '" + scene + "'"), {"would overwrite", "s.toml"});
  refused(run("solve '" + scene + "' --vtk '" + (folder_ / "." / "s.toml").string() + "'"),
          {"would overwrite"});
  const std::string both = (folder_ / "both").string();
  refused(run("solve '" + scene + "' -o '" + both + "' --vtk '" + both + "'"), {"would overwrite", "both"});
  EXPECT_EQ(text_of(scene), hertz);
}

/// Also a file that the scene names, and one that only a body file of the scene names.
TEST_F(CommandLine, NoCommandOverwritesAFileThatItReads) {
  const std::string points = write("points.txt", "-20 1\n0 0\n20 1\n").string();
  const std::string body = write("rail.toml", "body.profile = \"points.txt\"\n").string();
  std::string text = wheel_rail + "[sweep]\nposition.lateral = [0.0, 1.0]\n";
  text.replace(text.find("60E1"), 4, "rail.toml");
  const std::string scene = "'" + write("s.toml", text).string() + "'";
  for (const std::string& file : {points, body})
    for (const std::string& command :
         {"solve " + scene + " --vtk", "creep-curves " + scene + " --csv", "conicity " + scene + " --csv",
          "conicity --wheel S1002 --rail 60E1 --left-rail '" + body + "' --csv",
          "profile '" + body + "' --csv", "fatigue " + scene + " --csv",
          "sweep " + scene + " -o '" + (folder_ / "new.h5").string() + "' --csv"})
      refused(run(command + " '" + file + "'"), {"would overwrite '", file, "(this run reads it)"});
  EXPECT_EQ(text_of(points), "-20 1\n0 0\n20 1\n");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "new.h5"));
  write("surface_fem.vts", "mine");
  refused(run("compare " + scene + " -o '" + (folder_ / "surface_fem.vts").string() + "' --vtk-prefix '" +
              (folder_ / "surface").string() + "'"),
          {"surface_fem.vts' of --vtk-prefix would overwrite", "(it is the output of --output)"});
}

/// Of every option of every command that names an output: a name that is none, as of a variable that is not
/// set, one in a folder that is not there, and one that is too long.
TEST_F(CommandLine, NoCommandEndsWellWithoutItsOutput) {
  const std::string scene =
                        "'" +
                        write("s.toml", wheel_rail + "[sweep]\nposition.lateral = [0.0, 1.0]\n").string() +
                        "'",
                    pair = "--wheel S1002 --rail 60E1", result = (folder_ / "r.h5").string(),
                    small = "'" CONFORMAL_SOURCE_DIR
                            "/data/influence/small_rail.h5' --dx 0.5 --ds 0.5 --mx 2 --my 2";
  ASSERT_EQ(run("solve '" + write("p.toml", hertz).string() + "' -o '" + result + "'").code, 0);
  const std::string long_name(300, 'a');
  for (const auto& [command, ending] : std::initializer_list<std::pair<std::string, const char*>>{
           {"solve " + scene + " -o", ".h5"},
           {"solve " + scene + " --vtk", ".vts"},
           {"compare " + scene + " -o", ".h5"},
           {"compare " + scene + " --vtk-prefix", ""},
           {"sweep " + scene + " -o", ".h5"},
           {"sweep " + scene + " -o '" + (folder_ / "new.h5").string() + "' --csv", ".csv"},
           {"creep-curves " + scene + " -o", ".h5"},
           {"creep-curves " + scene + " --csv", ".csv"},
           {"conicity " + pair + " -o", ".h5"},
           {"conicity " + pair + " --csv", ".csv"},
           {"profile 60E1 --csv", ".csv"},
           {"profile 60E1 --plot", ".html"},
           {"fatigue " + scene + " -o", ".h5"},
           {"fatigue " + scene + " --csv", ".csv"},
           {"wheelset '" CONFORMAL_SOURCE_DIR "/data/scenes/wheelset.toml' -o", ".h5"},
           {"wheelset '" CONFORMAL_SOURCE_DIR "/data/scenes/wheelset.toml' --vtk-prefix", ""},
           {"table --creep-forces -o", ".h5"},
           {"table --creep-forces --text", ".txt"},
           {"influence expand " + small + " -o", ".h5"},
           {"report '" + result + "' -o", ".html"}}) {
    refused(run(command + " ''"), {"(it names no file)"});
    refused(run(command + " '" + (folder_ / "none" / "a").string() + ending + "'"),
            {"cannot be written", "there is no folder"});
    refused(run(command + " '" + (folder_ / long_name).string() + ending + "'"),
            {"cannot be written", "(the name is too long)"});
  }
  refused(run("wear " + scene + " -o ''"), {"(it names no file)"});
  refused(run("wear " + scene + " -o '" + (folder_ / long_name).string() + "'"), {"cannot be made"});
  EXPECT_FALSE(std::filesystem::exists(folder_ / "new.h5"));
}

/// An argument may be of any length.
TEST_F(CommandLine, MessagesAreShort) {
  const std::string word(100'000, 'a');
  for (const std::string& line :
       {"solve s.toml --" + word, "solve " + word, "solve s.toml --threads " + word, word})
    EXPECT_LT(run(line).err.size(), 1000u);
}

TEST_F(CommandLine, WhatIsTooLargeIsRefusedAtOnce) {
  std::string large = hertz;
  for (const char* size : {"mx = 16", "ms = 16"})
    large.replace(large.find(size), 7, std::string(size, 5) + "2000");
  refused(run("solve '" + write("large.toml", large).string() + "'"), {"2000 x 2000", "is too large", "GB"});
  std::string heavy = wheel_rail;
  heavy.replace(heavy.find("1e4"), 3, "1e8");
  refused(run("solve '" + write("heavy.toml", heavy).string() + "'"), {"far beyond elastic contact"});
}

TEST_F(CommandLine, ElementsTooLargeForTheContactAreWarnedOf) {
  std::string light = hertz;
  light.replace(light.find("1e4"), 3, "1.0");
  const Outcome r = run("solve '" + write("light.toml", light).string() + "' --json");
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_THAT(r.err, HasSubstr("the elements are too large for this contact"));
}

TEST_F(CommandLine, StrictTakesWarningsAsErrors) {
  std::string light = hertz;
  light.replace(light.find("1e4"), 3, "1.0");
  const std::string scene = write("light.toml", light).string(), out = (folder_ / "light.h5").string();
  refused(run("solve '" + scene + "' --strict -o '" + out + "'"), {"too large for this contact", "(patch 1"});
  EXPECT_FALSE(std::filesystem::exists(out));
  EXPECT_EQ(run("solve '" + write("s.toml", hertz).string() + "' --strict").code, 0);
  std::string slippery = hertz;
  slippery.replace(slippery.find("0.3"), 3, "1.5");
  const Outcome checked = run("check '" + write("slippery.toml", slippery).string() + "' --strict");
  EXPECT_EQ(checked.code, 2);
  EXPECT_THAT(checked.err, HasSubstr("motion.friction = 1.5"));
}

/// JSON names an error "<number>_error"; text has it beside the number.
TEST_F(CommandLine, ErrorsStandBesideTheirNumbers) {
  std::string fine = hertz;
  fine.replace(fine.find("xi = 1e-3"), 9, "xi = 3e-4");
  for (const char* size : {"mx = 16", "ms = 16"})
    fine.replace(fine.find(size), 7, std::string(size, 5) + "32");
  for (const char* size : {"dx = 0.5", "ds = 0.5"})
    fine.replace(fine.find(size), 8, std::string(size, 5) + "0.25");
  const std::string scene = write("fine.toml", fine).string();
  const json j = json::parse(run("solve '" + scene + "' --json").out);
  for (const char* key : {"pmax_error", "area_error", "approach_error", "adhesion_share_error"})
    EXPECT_GT(j["quantities"][key].get<double>(), 0) << key;
  for (const char* key : {"Fx_error", "Fy_error", "Mz_error", "T_gamma_error"})
    EXPECT_GT(j["quantities"][key].get<double>(), 0) << key;
  EXPECT_EQ(j["quantities"]["Fz_error"], 0) << "prescribed";
  for (const char* key : {"Fx_error", "Fs_error", "overlap_error", "pmax_error", "area_error"})
    EXPECT_GT(j["patches"][0][key].get<double>(), 0) << key;
  EXPECT_EQ(j["patches"][0]["Fn_error"], 0) << "prescribed, because the surface is flat";
  EXPECT_EQ(j["converges_with_elements"], true);
  const std::string text = run("solve '" + scene + "'").out;
  EXPECT_THAT(text, ::testing::ContainsRegex("pmax [0-9.]+ \\+- [0-9.]+ MPa, area [0-9.]+ \\+- [0-9.]+ mm2"));
  EXPECT_THAT(text, ::testing::ContainsRegex("Fx [0-9.]+ \\+- [0-9.]+ N"));
}

TEST_F(CommandLine, InfoRefusesWhatIsNoHdf5) {
  refused(run("info '" + write("text.h5", "not HDF5").string() + "'"), {"text.h5"});
  refused(run("info '" + (folder_ / "nowhere.h5").string() + "'"), {"nowhere.h5"});
}

} // namespace
