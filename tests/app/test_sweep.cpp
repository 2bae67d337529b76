#include "bem_contact/app/sweep/sweep_inputs.hpp"
#include "bem_contact/app/sweep/sweep_journal.hpp"
#include "bem_contact/app/sweep/sweep_workers.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/said_by.hpp"
#include "bem_contact/h5/table.hpp"
#include "tests/app/run_program.hpp"
#include "tests/sanitized.hpp"

#include <chrono>
#include <cmath>
#include <csignal>
#include <gmock/gmock.h>
#include <map>
#include <new>
#include <nlohmann/json.hpp>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>

namespace {

using namespace bem_contact;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

const std::string patch =
    "kind = \"patch\"\nmotion.friction = 0.3\n[grid]\ndx = 0.5\nds = 0.5\nmx = 16\nms = 16\n"
    "[gap]\na = 1e-3\nb = 1e-3\n[sweep]\n";
const std::string cases =
    patch + "load.force = [4e3, 5e3, 6e3, 7e3]\nmotion.xi = { from = 0, to = 2e-3, count = 5 }\n";

class Sweep : public ProgramTest {
protected:
  std::string scene(const std::string& text) const {
    return std::string("'").append(write("s.toml", text).string()).append("'");
  }
  fs::path out() const { return folder_ / "o.h5"; }
  fs::path journal() const { return folder_ / "o.h5.part"; }
  Outcome sweep(const std::string& text, const std::string& more = "") const {
    return run("sweep " + scene(text) + " -o '" + out().string() + "' " + more);
  }
  /// All that a sweep found, but not how long it took.
  static H5Table found(const fs::path& file) {
    H5Table table = read_h5(file);
    for (const char* name : {"seconds", "cpu_seconds"})
      table.datasets.erase(name);
    return table;
  }
  static void expect_equal(const H5Table& a, const H5Table& b) {
    EXPECT_EQ(a.attributes, b.attributes);
    ASSERT_EQ(a.datasets.size(), b.datasets.size());
    for (const auto& [name, data] : a.datasets) {
      ASSERT_TRUE(b.datasets.contains(name)) << name;
      const H5Dataset& other = b.datasets.at(name);
      ASSERT_EQ(data.shape, other.shape) << name;
      for (std::size_t i = 0; i < data.values.size(); ++i)
        ASSERT_TRUE(data.values[i] == other.values[i] ||
                    (std::isnan(data.values[i]) && std::isnan(other.values[i])))
            << name << " " << i << ": " << data.values[i] << " " << other.values[i];
    }
  }
};

TEST_F(Sweep, EachCaseIsWhatSolveSaysOfIt) {
  const Outcome r = sweep(cases, "--csv '" + (folder_ / "o.csv").string() + "'");
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("20 certified, of 20 cases"));
  EXPECT_FALSE(fs::exists(journal()));
  const H5Table table = read_h5(out());
  const auto top = [&](const char* name) { return table.datasets.at(name).values[13]; }; // 6e3, 1.5e-3
  EXPECT_EQ(top("load.force"), 6e3);
  EXPECT_EQ(top("motion.xi"), 1.5e-3);

  std::string one = cases.substr(0, cases.find("[sweep]"));
  one.replace(one.find("motion.friction = 0.3"), 21,
              "load.force = 6e3\nmotion.friction = 0.3\nmotion.xi = 1.5e-3");
  const Outcome s = run("solve '" + write("one.toml", one).string() + "' --json");
  ASSERT_EQ(s.code, 0) << s.err;
  const auto j = nlohmann::json::parse(s.out);
  EXPECT_NEAR(top("Fx"), j["quantities"]["Fx"].get<double>(), 1e-9 * 6e3);
  EXPECT_NEAR(top("Fz"), 6e3, 1e-4);
  EXPECT_EQ(top("contact"), j["patches"][0]["contact"].get<double>());
  EXPECT_EQ(table.datasets.at("cases/000013/p_n").shape, (std::vector<std::size_t>{16, 16}));

  const std::string csv = text_of(folder_ / "o.csv");
  EXPECT_THAT(csv, HasSubstr("case,load.force,motion.xi,status,seconds,cpu_seconds,Fx,"));
  EXPECT_THAT(csv, HasSubstr("\n13,6000,0.0015,certified,"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 21);
}

TEST_F(Sweep, ResultsDoNotDependOnTheNumberOfProcesses) {
  NEEDS_NO_SANITIZER();
  ASSERT_EQ(sweep(cases, "--jobs 1").code, 0);
  const H5Table one = found(out());
  fs::remove(out());
  ASSERT_EQ(sweep(cases, "--jobs 5").code, 0);
  expect_equal(one, found(out()));
}

TEST_F(Sweep, KilledItGoesOnAndSolvesNothingTwice) {
  NEEDS_NO_SANITIZER(); // the next test cuts the journal anywhere
  ASSERT_EQ(sweep(cases).code, 0);
  const H5Table whole = found(out());
  fs::remove(out());

  const std::string file = (folder_ / "s.toml").string(), output = out().string();
  int killed = 0;
  for (int attempt = 0; attempt < 200 && !fs::exists(out()); ++attempt) {
    const auto before = fs::exists(journal()) ? fs::file_size(journal()) : 0;
    const pid_t process = fork();
    ASSERT_GE(process, 0);
    if (process == 0) {
      std::freopen("/dev/null", "w", stderr);
      std::freopen("/dev/null", "w", stdout);
      execl(BEM_CONTACT, BEM_CONTACT, "sweep", file.c_str(), "-o", output.c_str(), "--jobs", "2", nullptr);
      _exit(127);
    }
    // Kill it once it has got a little further, at a moment of no importance to it.
    for (int wait = 0; wait < 5000; ++wait) {
      std::error_code ignored;
      const auto size = fs::file_size(journal(), ignored);
      if (waitpid(process, nullptr, WNOHANG) == process)
        break;
      if (!ignored && size > before + 20000 * std::size_t(1 + attempt % 3)) {
        kill(process, SIGKILL);
        waitpid(process, nullptr, 0);
        ++killed;
        break;
      }
      std::this_thread::sleep_for(std::chrono::microseconds(500));
    }
    // Whatever was whole stays.
    if (fs::exists(journal())) {
      EXPECT_GE(fs::file_size(journal()), before);
    }
  }
  EXPECT_GE(killed, 1);
  ASSERT_TRUE(fs::exists(out()));
  expect_equal(whole, found(out()));
}

TEST_F(Sweep, AJournalCutAnywhereLosesOnlyTheLastCase) {
  const std::string few = patch + "load.force = [4e3, 5e3, 6e3]\n";
  ASSERT_EQ(sweep(few).code, 0);
  const H5Table whole = found(out());
  fs::remove(out());
  ASSERT_EQ(sweep(few, "--part 1/2").code, 0); // the journal of a share stays
  fs::rename(folder_ / "o.h5.part-1-of-2", folder_ / "kept");
  const std::string bytes = text_of(folder_ / "kept");
  const std::size_t header = std::string("bem_contact sweep 2\n").size() + 64 + 1;
  for (const std::size_t length :
       {std::size_t{0}, std::size_t{5}, header - 1, header, header + 3, bytes.size() / 2, bytes.size() - 1}) {
    fs::remove(out());
    std::ofstream(journal(), std::ios::binary) << bytes.substr(0, length);
    ASSERT_EQ(sweep(few).code, 0) << length;
    expect_equal(whole, found(out()));
  }
  // A byte that is not what was written: nothing from there on is believed.
  fs::remove(out());
  std::string wrong = bytes;
  wrong[header + 100] ^= 1;
  std::ofstream(journal(), std::ios::binary) << wrong;
  ASSERT_EQ(sweep(few).code, 0);
  expect_equal(whole, found(out()));
}

/// Memory may have run out, and the next run may have more of it.
TEST_F(Sweep, ACaseWhoseProcessDiedIsSolvedAgainByTheSameCommand) {
  const std::string few = patch + "load.force = [4e3, 5e3, 6e3]\n";
  ASSERT_EQ(sweep(few).code, 0);
  const H5Table whole = found(out());
  for (const char* name : {"o.h5.part", "o.h5.part-1-of-2"}) {
    SCOPED_TRACE(name);
    fs::remove(out());
    {
      const std::string digest = app::digest_of(read_sweep_file(write("s.toml", few)), "");
      app::SweepJournal died(folder_ / name, digest, [](const app::CaseRecord&) {});
      died.append(app::to_bytes({{.index = 1, .status = CaseStatus::died, .reason = "by signal 9"}}));
    }
    // A file that says so is not complete.
    const Outcome merged = sweep(few, "--merge");
    EXPECT_EQ(merged.code, 3) << merged.err;
    EXPECT_THAT(merged.out, HasSubstr("1 died"));
    EXPECT_EQ(text_attribute(read_h5(out()), "cases/000001/reason"), "by signal 9");
    const Outcome again = sweep(few);
    EXPECT_EQ(again.code, 0) << again.err;
    EXPECT_THAT(again.out, HasSubstr("3 certified, of 3 cases"));
    expect_equal(whole, found(out()));
    EXPECT_FALSE(fs::exists(folder_ / name));
  }
}

/// What others have beside the output is neither read nor removed.
TEST_F(Sweep, OnlyItsOwnJournalsAreJournals) {
  const fs::path pipe = folder_ / "o.h5.part-1-of-2", folder = folder_ / "o.h5.part-2-of-2";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  fs::create_directory(folder);
  const std::string few = patch + "load.force = [4e3]\n";
  const auto names = {"o.h5.part-empty-of-mine", "o.h5.part-01-of-2", "o.h5.part-1-of-2.old",
                      "o.h5.part-3-of-4"};
  for (const char* name : names)
    write(name, name == std::string("o.h5.part-3-of-4") ? "mine" : "");
  EXPECT_EQ(sweep(few, "--merge").code, 3); // its case is missing
  const Outcome solved = sweep(few);
  EXPECT_EQ(solved.code, 0) << solved.err;
  for (const char* name : names)
    EXPECT_TRUE(fs::exists(folder_ / name)) << name;
  EXPECT_TRUE(fs::is_fifo(pipe) && fs::is_directory(folder));
  fs::remove(out());
  const Outcome share = sweep(few, "--part 1/2");
  EXPECT_EQ(share.code, 2);
  EXPECT_THAT(share.err, HasSubstr("a pipe"));
  const Outcome other = sweep(few, "--part 2/2");
  EXPECT_EQ(other.code, 2);
  EXPECT_THAT(other.err, HasSubstr("it is a folder"));
}

TEST_F(Sweep, FinishedItSolvesNothingAndSaysSo) {
  ASSERT_EQ(sweep(cases).code, 0);
  const auto time = fs::last_write_time(out());
  const Outcome again = sweep(cases, "--csv '" + (folder_ / "o.csv").string() + "'");
  EXPECT_EQ(again.code, 0);
  EXPECT_THAT(again.out, HasSubstr("nothing was solved"));
  EXPECT_EQ(again.err, "");
  EXPECT_EQ(fs::last_write_time(out()), time);
  EXPECT_TRUE(fs::exists(folder_ / "o.csv"));
  const Outcome info = run("info '" + out().string() + "'");
  EXPECT_EQ(info.code, 0) << info.err;
  EXPECT_THAT(info.out, HasSubstr("A sweep of bem_contact"));
  EXPECT_THAT(info.out, HasSubstr("motion.xi [20]"));
}

TEST_F(Sweep, AFailedCaseIsRecordedWithItsReasonAndTheOthersAreSolved) {
  const std::string text = "kind = \"wheel_rail\"\nrail.profile = \"60E1\"\nwheel.profile = \"S1002\"\n"
                           "load.force = 1e4\nmotion.frictionless = true\n[grid]\ndx = 1.0\nds = 0.5\n"
                           "[sweep]\nposition.lateral = [0, 300, 1]\n";
  const Outcome r = sweep(text, "--csv '" + (folder_ / "o.csv").string() + "' --model halfspace");
  EXPECT_EQ(r.code, 3) << r.err;
  EXPECT_THAT(r.out, HasSubstr("2 certified, 1 refused, of 3 cases"));
  const H5Table table = read_h5(out());
  EXPECT_EQ(table.datasets.at("status").values, (std::vector<double>{1, 3, 1}));
  EXPECT_TRUE(std::isnan(table.datasets.at("Fz").values[1]));
  EXPECT_THAT(std::get<std::string>(table.attributes.at("cases/000001/reason")),
              HasSubstr("position.lateral"));
  EXPECT_THAT(text_of(folder_ / "o.csv"), HasSubstr("\n1,300,refused,"));
  EXPECT_EQ(sweep(text, "--model halfspace").code, 3); // complete, and still not all certified
}

TEST_F(Sweep, SharesMergedAreTheWhole) {
  ASSERT_EQ(sweep(cases).code, 0);
  const H5Table whole = found(out());
  fs::remove(out());
  for (const char* part : {"2/3", "1/3"}) {
    const Outcome r = sweep(cases, std::string("--part ") + part);
    EXPECT_EQ(r.code, 0) << r.err;
    EXPECT_FALSE(fs::exists(out()));
  }
  Outcome merged = sweep(cases, "--merge");
  EXPECT_EQ(merged.code, 3);
  EXPECT_THAT(merged.out, HasSubstr("4 missing"));
  EXPECT_EQ(read_h5(out()).datasets.at("missing_count").values, std::vector<double>{4});
  ASSERT_EQ(sweep(cases, "--part 3/3").code, 0);
  merged = sweep(cases, "--merge");
  EXPECT_EQ(merged.code, 0) << merged.err;
  expect_equal(whole, found(out()));
  EXPECT_FALSE(fs::exists(folder_ / "o.h5.part-1-of-3"));
}

TEST_F(Sweep, AnotherSweepIsNeverMixedInOrLost) {
  ASSERT_EQ(sweep(cases).code, 0);
  const std::string before = text_of(out());
  const Outcome other = sweep(patch + "load.force = [1e3]\n");
  EXPECT_EQ(other.code, 2);
  EXPECT_THAT(other.err, HasSubstr("is not of this sweep"));
  EXPECT_EQ(sweep(cases, "--model fem").code, 2); // another model is another sweep
  EXPECT_EQ(text_of(out()), before);

  fs::remove(out());
  ASSERT_EQ(sweep(cases, "--part 1/2").code, 0);
  EXPECT_THAT(sweep(patch + "load.force = [1e3]\n").err, HasSubstr("belongs to another sweep"));
  EXPECT_THAT(run("sweep " + scene(cases) + " -o '" + (folder_ / "s.toml").string() + "'").err,
              HasSubstr("would overwrite"));
}

/// What they hold is part of the digest: with other points the cases are solved again.
TEST_F(Sweep, FilesThatABodyFileNamesAreInputs) {
  const std::string points = write("points.txt", "-20 1\n0 0\n20 1\n").string(),
                    body = write("rail.toml", "body.profile = \"points.txt\"\n").string();
  const fs::path file =
      write("b.toml", "wheel.profile = \"S1002\"\nload.force = 1e4\n[sweep]\nrail.profile = "
                      "[\"60E1\", \"rail.toml\", \"points.txt\"]\n");
  const SweepFile sweep = read_sweep_file(file);
  EXPECT_THAT(app::input_paths(sweep), testing::UnorderedElementsAre(points, body));
  std::vector<std::string> keys;
  for (const InputRecord& input : app::given_sweep(sweep, "").inputs)
    keys.push_back(input.key);
  EXPECT_THAT(keys, testing::UnorderedElementsAre("rail.profile", "wheel.profile", "rail.profile[1]",
                                                  "rail.profile[1].body.profile", "rail.profile[2]"));
}

TEST_F(Sweep, WrongInputIsRefusedBeforeAnythingIsSolved) {
  const auto refused = [&](const std::string& text, const std::string& more, const std::string& words) {
    const Outcome r = sweep(text, more);
    EXPECT_EQ(r.code, 2) << words;
    EXPECT_THAT(r.err, HasSubstr(words));
    EXPECT_FALSE(fs::exists(out()));
    EXPECT_FALSE(fs::exists(journal()));
  };
  refused(patch + "load.force = [1e3, 2e3, -1]\n", "", "load.force = -1.0 (out of range)");
  refused(patch, "", "no table [sweep]");
  refused(cases, "--part 4/3", "--part 4/3 cannot be");
  refused(cases, "--part 1of3", "is not of the form 2/8");
  refused(cases, "--part 1/2 --merge", "excludes");
  refused(cases, "--jobs -1", "--jobs");
}

TEST_F(Sweep, TwoCannotWriteOneJournal) {
  const std::string digest(64, 'a');
  const auto ignore = [](const app::CaseRecord&) {};
  const app::SweepJournal first(journal(), digest, ignore);
  try {
    const app::SweepJournal second(journal(), digest, ignore);
    FAIL();
  } catch (const std::exception& error) {
    EXPECT_THAT(error.what(), HasSubstr("in use"));
  }
}

TEST(SweepWorkers, AProcessThatDiesCostsItsCaseAlone) {
  std::map<std::size_t, std::string> done, died;
  app::WorkerCalls calls;
  calls.make_solver = [] {
    return [](std::size_t index) {
      if (index % 5 == 3)
        raise(SIGKILL);
      if (index == 7)
        _exit(9);
      return std::to_string(index * index);
    };
  };
  calls.done = [&](std::size_t index, std::string result) { done[index] = std::move(result); };
  calls.failed = [&](std::size_t index, app::CaseFailure how, const std::string& reason) {
    EXPECT_EQ(how, app::CaseFailure::died) << index;
    died[index] = reason;
  };
  app::solve_in_processes({{0, 1, 2, 3, 4, 5}, {6, 7, 8, 9, 10, 11}, {12, 13}}, 2, calls);
  ASSERT_EQ(died.size(), 4u);
  for (const std::size_t index : {3, 8, 13})
    EXPECT_THAT(died.at(index), HasSubstr("signal 9")) << index;
  EXPECT_THAT(died.at(7), HasSubstr("code 9"));
  ASSERT_EQ(done.size(), 10u);
  for (const auto& [index, result] : done)
    EXPECT_EQ(result, std::to_string(index * index));
}

/// The next case of the chunk is solved by the same process.
TEST(SweepWorkers, WhatASolverThrowsComesBackByItsKind) {
  using enum app::CaseFailure;
  std::map<std::size_t, std::pair<app::CaseFailure, std::string>> failed;
  std::size_t done = 0;
  app::WorkerCalls calls;
  calls.make_solver = [] {
    return [](std::size_t index) {
      if (index == 1)
        throw InputError("Wrong", "one", "Mend it.");
      if (index == 2)
        throw ConvergenceError("Hard", "two", "Wait.");
      if (index == 3)
        throw Error("Full", "three", "Make room.");
      if (index == 4)
        throw std::bad_alloc();
      return std::string("solved");
    };
  };
  calls.done = [&](std::size_t, const std::string& result) { done += result == "solved"; };
  calls.failed = [&](std::size_t index, app::CaseFailure how, const std::string& said) {
    failed[index] = {how, said};
  };
  app::solve_in_processes({{0, 1, 2, 3, 4, 5}}, 1, calls);
  EXPECT_EQ(done, 2u);
  const decltype(failed) expected{{1, {refused, "Wrong (one) Mend it."}},
                                  {2, {not_converged, "Hard (two) Wait."}},
                                  {3, {fault, "Full (three) Make room."}},
                                  {4, {fault, said_by(std::bad_alloc())}}};
  EXPECT_EQ(failed, expected);
}

TEST(SweepWorkers, EachChunkBeginsAnew) {
  std::map<std::size_t, std::string> done;
  app::WorkerCalls calls;
  calls.make_solver = [] { return [former = 0](std::size_t) mutable { return std::to_string(former++); }; };
  calls.done = [&](std::size_t index, std::string result) { done[index] = std::move(result); };
  calls.failed = [&](std::size_t index, app::CaseFailure, const std::string& reason) {
    ADD_FAILURE() << index << reason;
  };
  app::solve_in_processes({{0, 1, 2}, {3, 4}, {5}, {6, 7}}, 2, calls);
  const std::map<std::size_t, std::string> expected{{0, "0"}, {1, "1"}, {2, "2"}, {3, "0"},
                                                    {4, "1"}, {5, "0"}, {6, "0"}, {7, "1"}};
  EXPECT_EQ(done, expected);
}

/// Mirror images: what the right wheel bears at 2 mm, the left one bears at -2 mm.
TEST_F(Sweep, OfWheelsetsIsWhatTheWheelsetCommandSays) {
  const std::string wheelset = "rail.profile = \"60E1\"\nwheel.profile = \"S1002\"\nsolver.model = "
                               "\"halfspace\"\nposition.rail_inclination = 0.025\n"
                               "motion.friction = 0.3\ngrid.dx = 1\ngrid.ds = 1\n";
  const std::string swept = wheelset + "wheelset.force = 2e5\n[sweep]\nposition.lateral = [-2, 2]\n";
  const Outcome r = sweep(swept, "--csv '" + (folder_ / "o.csv").string() + "'");
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("2 certified, of 2 cases"));
  const H5Table table = read_h5(out());
  const auto at = [&](const std::string& name, std::size_t i) {
    return table.datasets.at(name).values.at(i);
  };
  const Outcome w =
      run("wheelset '" + write("w.toml", wheelset + "wheelset.force = 2e5\nposition.lateral = 2\n").string() +
          "' --json");
  ASSERT_EQ(w.code, 0) << w.err;
  const auto j = nlohmann::json::parse(w.out);
  EXPECT_NEAR(at("roll", 1), j["wheelset"]["roll"].get<double>(), 1e-9);
  EXPECT_NEAR(at("right_Fy", 1), j["right"]["track"]["Fy"].get<double>(), 0.2);
  EXPECT_NEAR(at("left_share", 1), j["left"]["track"]["share"].get<double>(), 1e-6);
  EXPECT_NEAR(at("right_share", 1), at("left_share", 0), 1e-5);
  EXPECT_NEAR(at("right_Fy", 1), -at("left_Fy", 0), 2);
  for (const char* wheel : {"right", "left"})
    EXPECT_EQ(table.datasets.at(std::string("cases/000001/") + wheel + "/p_n").shape.size(), 2u);
  EXPECT_THAT(text_of(folder_ / "o.csv"), HasSubstr(",right_share,"));
  EXPECT_THAT(text_of(folder_ / "o.csv"), HasSubstr(",halfspace,"));
  EXPECT_THAT(text_of(folder_ / "o_units.csv"),
              HasSubstr("cases,left_Fy,N,\"left wheel: on the rail, to the right\""));
  // The work of friction of each patch adds up to that of its wheel.
  double right = 0, left = 0;
  const std::vector<double>& cases = table.datasets.at("patches/case").values;
  for (std::size_t i = 0; i < cases.size(); ++i)
    if (cases[i] == 1)
      (at("patches/left", i) == 1 ? left : right) += at("patches/T_gamma", i);
  EXPECT_NEAR(right, at("right_T_gamma", 1), 1e-9 * right);
  EXPECT_NEAR(left, at("left_T_gamma", 1), 1e-9 * left);
  EXPECT_GE(at("patches/Fn", 0), at("patches/Fn", 1));
  EXPECT_THAT(text_of(folder_ / "o_patches.csv"), HasSubstr(",left"));
}

/// A wheel that lifts is a case that is refused, and says why.
TEST_F(Sweep, OfWheelsetsKeepsWhatIsRefused) {
  const Outcome r =
      sweep("rail.profile = \"60E1\"\nwheel.profile = \"S1002\"\nsolver.model = "
            "\"halfspace\"\nmotion.friction = 0.3\n"
            "grid.dx = 1\ngrid.ds = 1\nwheelset.force = 1e5\n[sweep]\nwheelset.roll_moment = [0, 2e8]\n",
            "--csv '" + (folder_ / "o.csv").string() + "'");
  EXPECT_EQ(r.code, 3) << r.out;
  EXPECT_THAT(r.out, HasSubstr("1 certified, 1 refused, of 2 cases"));
  EXPECT_THAT(text_of(folder_ / "o.csv"), HasSubstr("lifts"));
}

} // namespace
