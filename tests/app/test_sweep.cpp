#include "bem_contact/app/sweep/sweep_on_cores.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/said_by.hpp"
#include "bem_contact/h5/table.hpp"
#include "bem_contact/uses/sweep/sweep_inputs.hpp"
#include "tests/app/run_program.hpp"

#include <chrono>
#include <cmath>
#include <csignal>
#include <gmock/gmock.h>
#include <new>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>

namespace {

using namespace bem_contact;
using ::testing::AnyOf;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

const std::string patch =
    "kind = \"patch\"\nmotion.friction = 0.3\n[grid]\ndx = 0.5\nds = 0.5\nmx = 16\nms = 16\n"
    "[gap]\na = 1e-3\nb = 1e-3\n[sweep]\n";
const std::string cases =
    patch + "load.force = [4e3, 5e3, 6e3, 7e3]\nmotion.xi = { from = 0, to = 2e-3, count = 5 }\n";
/// The same on a plan of so many elements that processes share them.
const std::string long_cases =
    std::string(cases).replace(cases.find("mx = 16\nms = 16"), 15, "mx = 100\nms = 100");

class Sweep : public ProgramTest {
protected:
  std::string scene(const std::string& text) const {
    return std::string("'").append(write("s.toml", text).string()).append("'");
  }
  fs::path out() const { return folder_ / "o.h5"; }
  fs::path parts() const { return folder_ / "o.h5.parts"; }
  /// What a command takes: some cases of a text, in one process.
  Outcome part(const std::string& text, const std::string& cases, const std::string& name) const {
    return run("sweep " + scene(text) + " -o '" + (folder_ / name).string() + "' --cases " + cases);
  }
  /// As the program asks for it, so that it goes on with what is found here.
  AskedSweep asked(const std::string& text) const {
    const fs::path file = write("s.toml", text);
    AskedSweep out{file, read_sweep_file(file)};
    out.origins = origins_of(out.sweep, "");
    out.digest = digest_of(out.origins);
    return out;
  }
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

/// All at once, and the other parts are not touched.
TEST_F(Sweep, EveryPartThatCannotBeJoinedIsNamed) {
  for (const char* range : {"0:5", "5:10", "10:15", "15:20"})
    ASSERT_EQ(part(cases, range, std::string(range) + ".h5").code, 0);
  fs::create_directories(folder_ / "parts");
  for (const char* range : {"0:5", "5:10", "10:15", "15:20"})
    fs::rename(folder_ / (std::string(range) + ".h5"), folder_ / "parts" / (std::string(range) + ".h5"));
  const auto joined = [&](const std::string& more) {
    return run("sweep " + scene(cases) + " --join '" + (folder_ / "parts").string() + "' " + more);
  };
  for (const char* name : {"0:5.h5", "15:20.h5"})
    fs::resize_file(folder_ / "parts" / name, 1000);
  const Outcome refused = joined("-o '" + out().string() + "'");
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("2 parts of the sweep cannot be joined"));
  for (const char* name : {"0:5.h5", "15:20.h5"})
    EXPECT_THAT(refused.err, HasSubstr(name));
  EXPECT_FALSE(fs::exists(out()));
  const Outcome damaged = joined("--damaged");
  EXPECT_EQ(damaged.code, 0);
  EXPECT_EQ(std::ranges::count(damaged.out, '\n'), 2);
  for (const char* name : {"0:5.h5", "15:20.h5"})
    fs::remove(folder_ / "parts" / name);
  const Outcome missing = joined("--all-cases -o '" + out().string() + "'");
  EXPECT_EQ(missing.code, 2);
  EXPECT_THAT(missing.err, HasSubstr("10 cases cannot be joined"));
  EXPECT_THAT(missing.out, HasSubstr("--cases 15:20"));
  EXPECT_FALSE(fs::exists(out()));
}

/// A file, an option and the scene; of the program its version and commit, which a test cannot change.
TEST_F(Sweep, WhatHasChangedSinceAPartIsNamed) {
  fs::copy_file(CONFORMAL_SOURCE_DIR "/data/bodies/hollow_wheel.txt", folder_ / "w.txt");
  const std::string text =
      "rail.profile = '60E1'\nwheel = { profile = 'w.txt', smoothing = 8 }\nload.force = 8e4\n"
      "motion.frictionless = true\nsolver.model = 'halfspace'\ngrid = { dx = 2, ds = 1 }\n"
      "[sweep]\nposition.lateral = [0, 1]\n";
  ASSERT_EQ(part(text, "0:2", "a.h5").code, 0);
  const auto why = [&](const std::string& of, const std::string& more) {
    return run("sweep " + scene(of) + " --join '" + (folder_ / "a.h5").string() + "' -o '" + out().string() +
               "' " + more)
        .err;
  };
  EXPECT_THAT(why(text, "--strict"), HasSubstr("(its options were '', and are ' strict')"));
  std::ofstream(folder_ / "w.txt", std::ios::app) << "\n";
  EXPECT_THAT(why(text, ""), HasSubstr("(the file './w.txt' has changed)"));
  std::string other = text;
  other.replace(other.find("8e4"), 3, "9e4");
  EXPECT_THAT(why(other, ""), HasSubstr("(the file './w.txt' has changed; the scene has changed)"));
}

TEST_F(Sweep, CheckNamesTheFilesThatAreRead) {
  std::ofstream(folder_ / "rails.csv")
      << "rail.profile,rail.influence\n\"60E1\",\"new.h5\"\n\"r.txt\",\"worn.h5\"\n";
  fs::copy_file(CONFORMAL_SOURCE_DIR "/data/bodies/worn_rail.txt", folder_ / "r.txt");
  const Outcome inputs =
      run("check --inputs " +
          scene("wheel = { profile = 'S1002', influence = 'wheel.h5' }\nload.force = 8e4\n[sweep]\n"
                "position.lateral = [0, 1]\n[[sweep.together]]\ntable = 'rails.csv'\n"));
  EXPECT_EQ(inputs.code, 0) << inputs.err;
  std::istringstream lines(inputs.out);
  std::set<std::string> names;
  for (std::string line; std::getline(lines, line);)
    names.insert(fs::path(line).filename().string());
  EXPECT_EQ(names, (std::set<std::string>{"new.h5", "r.txt", "rails.csv", "wheel.h5", "worn.h5"}));
}

TEST_F(Sweep, EachCaseIsWhatSolveSaysOfIt) {
  const Outcome r = sweep(cases, "--csv '" + (folder_ / "o.csv").string() + "'");
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("20 of 20 cases are certified"));
  EXPECT_THAT(r.out, ::testing::Not(HasSubstr("20 certified"))) << "it is counted once";
  EXPECT_FALSE(fs::exists(parts()));
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
  ASSERT_FALSE(cut_of(asked(long_cases)).little);
  ASSERT_EQ(sweep(long_cases, "--jobs 1").code, 0);
  const H5Table one = found(out());
  fs::remove(out());
  ASSERT_EQ(sweep(long_cases, "--jobs 5").code, 0);
  expect_equal(one, found(out()));
}

std::size_t files_in(const fs::path& folder) {
  std::error_code ignored;
  std::size_t count = 0;
  for (fs::directory_iterator at(folder, ignored), end; !ignored && at != end; at.increment(ignored))
    count += at->path().extension() == ".h5";
  return count;
}

TEST_F(Sweep, KilledItGoesOnAndSolvesNothingTwice) {
  ASSERT_EQ(sweep(long_cases).code, 0);
  const H5Table whole = found(out());
  fs::remove(out());

  const std::string file = (folder_ / "s.toml").string(), output = out().string();
  int killed = 0;
  for (int attempt = 0; attempt < 200 && !fs::exists(out()); ++attempt) {
    const std::size_t before = files_in(parts());
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
      if (waitpid(process, nullptr, WNOHANG) == process)
        break;
      if (files_in(parts()) > before) {
        kill(process, SIGKILL);
        waitpid(process, nullptr, 0);
        ++killed;
        break;
      }
      std::this_thread::sleep_for(std::chrono::microseconds(500));
    }
    // Whatever was whole stays.
    if (!fs::exists(out())) {
      EXPECT_GE(files_in(parts()), before);
    }
  }
  EXPECT_GE(killed, 1);
  ASSERT_TRUE(fs::exists(out()));
  expect_equal(whole, found(out()));
  EXPECT_FALSE(fs::exists(parts()));
}

TEST_F(Sweep, APartThatIsCutOrChangedIsRefused) {
  const std::string few = patch + "load.force = [4e3, 5e3, 6e3]\n";
  ASSERT_EQ(part(few, "0:3", "p.h5").code, 0);
  const std::string bytes = text_of(folder_ / "p.h5");
  const auto joined = [&](const std::string& changed) {
    std::ofstream(folder_ / "q.h5", std::ios::binary) << changed;
    return sweep(few, "--join '" + (folder_ / "q.h5").string() + "'");
  };
  ASSERT_EQ(joined(bytes).code, 0);
  const H5Table whole = found(out());
  fs::remove(out());
  for (const std::size_t length :
       {std::size_t{0}, std::size_t{5}, std::size_t{100}, bytes.size() / 2, bytes.size() - 1}) {
    const Outcome cut = joined(bytes.substr(0, length));
    EXPECT_EQ(cut.code, 2) << length;
    EXPECT_THAT(cut.err, HasSubstr("q.h5' cannot be read")) << length;
  }
  // A bit of a number that is not what was written.
  const auto changed_at = [&](std::size_t at) {
    std::string wrong = bytes;
    wrong[at] = static_cast<char>(wrong[at] ^ 1);
    return joined(wrong);
  };
  const std::vector<double>& forces = whole.datasets.at("Fx").values;
  const std::size_t numbers =
      bytes.find(std::string(reinterpret_cast<const char*>(forces.data()), 8 * forces.size()));
  ASSERT_NE(numbers, bytes.npos);
  for (const std::size_t at : {numbers, numbers + 7, numbers + 8 * forces.size() - 1}) {
    const Outcome changed = changed_at(at);
    EXPECT_EQ(changed.code, 2) << at;
    EXPECT_THAT(changed.err,
                AnyOf(HasSubstr("q.h5' is damaged (its dataset 'Fx'"), HasSubstr("q.h5' cannot be read")))
        << at;
    EXPECT_FALSE(fs::exists(out()));
  }
  // Any other: refused, or of no meaning.
  for (std::size_t at = 1; at < bytes.size(); at += bytes.size() / 60) {
    const Outcome changed = changed_at(at);
    EXPECT_EQ(changed.code, fs::exists(out()) ? 0 : 2) << at << changed.err;
    if (fs::exists(out()))
      expect_equal(whole, found(out()));
    else
      EXPECT_THAT(changed.err, HasSubstr("q.h5")) << at;
    fs::remove(out());
  }
}

TEST_F(Sweep, AnEmptyFileOfACrashIsSolvedAgain) {
  ASSERT_EQ(sweep(cases).code, 0);
  const H5Table whole = found(out());
  fs::remove(out());
  fs::create_directory(parts());
  for (const char* name : {"000004.h5", "000004.h5.tmp1"})
    std::ofstream(parts() / name) << "";
  const Outcome again = sweep(cases);
  EXPECT_EQ(again.code, 0) << again.err;
  expect_equal(whole, found(out()));
}

/// Memory may have run out, and the next run may have more of it.
TEST_F(Sweep, AProcessThatDiesCostsItsCaseAloneAndTheSameCommandSolvesThat) {
  ASSERT_EQ(sweep(cases).code, 0);
  const H5Table whole = found(out());
  fs::remove(out());
  {
    const AskedSweep here = asked(cases);
    const app::PartsFolder folder(here, out());
    const app::PartSolver real = app::part_solver(here);
    const app::SolvedParts solved = app::solve_on_cores(folder, 3, [&](CaseRange part, const fs::path& file) {
      if (part.first <= 6 && 6 < part.last)
        raise(SIGKILL);
      if (part.first <= 7 && 7 < part.last)
        _exit(9);
      if (part.first <= 18 && 18 < part.last)
        throw std::bad_alloc();
      real(part, file);
    });
    EXPECT_EQ(solved.code, 0);
    ASSERT_EQ(solved.died.size(), 3U);
    EXPECT_THAT(solved.died.at(6), HasSubstr("signal 9"));
    EXPECT_THAT(solved.died.at(7), HasSubstr("code 9"));
    EXPECT_EQ(solved.died.at(18), said_by(std::bad_alloc()));
    EXPECT_EQ(missing_ranges(folder.parts(), 20), (std::vector<CaseRange>{{6, 8}, {18, 19}}));
    join(here, folder.parts(), solved.died, out());
  }
  const H5Table died = read_h5(out()); // such a file is not complete
  EXPECT_EQ(died.datasets.at("died_count").values, std::vector<double>{3});
  EXPECT_EQ(died.datasets.at("certified_count").values, std::vector<double>{17});
  EXPECT_EQ(text_attribute(died, "cases/000018/reason"), said_by(std::bad_alloc()));
  const Outcome again = sweep(cases);
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_THAT(again.err, HasSubstr("cases: 3/3"));
  EXPECT_THAT(again.out, HasSubstr("20 of 20 cases are certified"));
  EXPECT_FALSE(fs::exists(parts()));
  // Some cases started cold: as exact, but not digit for digit.
  for (const char* name : {"Fx", "Fz", "pmax"})
    for (std::size_t i = 0; i < 20; ++i)
      EXPECT_NEAR(read_h5(out()).datasets.at(name).values[i], whole.datasets.at(name).values[i], 1e-5 * 7e3);
}

/// A fault of the machine is no death of a case: nothing is solved again and again.
TEST_F(Sweep, WhatAProcessCannotDoEndsTheSweep) {
  const AskedSweep here = asked(cases);
  const app::PartsFolder folder(here, out());
  testing::internal::CaptureStderr();
  const auto code = [&](const auto& fault) {
    return app::solve_on_cores(folder, 2, [&](CaseRange, const fs::path&) { throw fault; }).code;
  };
  EXPECT_EQ(code(InputError("Wrong", "one", "Mend it.")), 2);
  EXPECT_EQ(code(Error("Full", "three", "Make room.")), 1);
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("Full (three) Make room."));
}

/// By the work that is foreseen: neither a clock nor the number of processes changes what is found.
TEST(SweepCuts, FollowWork) {
  EXPECT_EQ(cut_of(21, 4e5).chunk, 21U);
  EXPECT_TRUE(cut_of(21, 4e5).little);
  EXPECT_EQ(cut_of(640, 4e5).chunk, chunk_size(640));
  EXPECT_FALSE(cut_of(640, 4e5).little);
  EXPECT_EQ(cut_of(3, 1e8).chunk, chunk_size(3));
  EXPECT_EQ(cut_of(100, 1e10).chunk, 1U);
}

/// As solve does; so no part is written, and none has to be joined.
TEST_F(Sweep, OfLittleWorkIsSolvedInOneProcess) {
  ASSERT_TRUE(cut_of(asked(cases)).little);
  ASSERT_EQ(sweep(cases, "--jobs 3").code, 0);
  const H5Table here = found(out());
  const fs::path whole = folder_ / "whole.h5";
  fs::rename(out(), whole);
  ASSERT_EQ(part(cases, "0:20", "p.h5").code, 0);
  ASSERT_EQ(sweep(cases, "--join '" + (folder_ / "p.h5").string() + "'").code, 0);
  expect_equal(here, found(out()));
}

/// What others have in the folder is neither read nor removed.
TEST_F(Sweep, OnlyItsOwnPartsAreParts) {
  fs::create_directories(parts() / "000002.h5");
  const std::string few = patch + "load.force = [4e3]\n";
  const auto names = {"mine.h5", "000001.h5.old", "000001", "1.h5.copy"};
  for (const char* name : names)
    std::ofstream(parts() / name) << "mine";
  const Outcome solved = sweep(few);
  EXPECT_EQ(solved.code, 0) << solved.err;
  for (const char* name : names)
    EXPECT_TRUE(fs::exists(parts() / name)) << name;
  EXPECT_TRUE(fs::is_directory(parts() / "000002.h5"));
  EXPECT_FALSE(fs::exists(parts() / "000000.h5"));
  fs::remove(out());
  const fs::path pipe = parts() / "000000.h5";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const Outcome refused = sweep(few);
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("a pipe"));
  EXPECT_TRUE(fs::is_fifo(pipe));
  fs::remove_all(parts());
  std::ofstream(parts()) << "mine";
  EXPECT_THAT(sweep(few).err, HasSubstr("o.h5.parts' cannot be made"));
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
  EXPECT_THAT(r.out, HasSubstr("2 of 3 cases are certified; refused: 1."));
  const H5Table table = read_h5(out());
  EXPECT_EQ(table.datasets.at("status").values, (std::vector<double>{1, 3, 1}));
  EXPECT_TRUE(std::isnan(table.datasets.at("Fz").values[1]));
  EXPECT_THAT(std::get<std::string>(table.attributes.at("cases/000001/reason")),
              HasSubstr("position.lateral"));
  EXPECT_THAT(text_of(folder_ / "o.csv"), HasSubstr("\n1,300,refused,"));
  EXPECT_EQ(sweep(text, "--model halfspace").code, 3); // complete, and still not all certified
}

TEST_F(Sweep, PartsJoinedAreTheWhole) {
  ASSERT_EQ(sweep(cases, "--csv '" + (folder_ / "o.csv").string() + "'").code, 0);
  const H5Table whole = found(out());
  const std::string patches = text_of(folder_ / "o_patches.csv");
  fs::remove(out());
  fs::create_directory(folder_ / "some parts");
  for (const char* range : {"12:20", "0:8"}) {
    const Outcome r = part(cases, range, std::string("some parts/") + range[0] + ".h5");
    EXPECT_EQ(r.code, 0) << r.err;
    EXPECT_THAT(r.out, HasSubstr("8 of 8 cases are certified"));
  }
  const std::string join =
      "--join '" + (folder_ / "some parts").string() + "' --csv '" + (folder_ / "j.csv").string() + "'";
  Outcome joined = sweep(cases, join);
  EXPECT_EQ(joined.code, 3);
  EXPECT_THAT(joined.out, HasSubstr("missing: 4"));
  EXPECT_EQ(read_h5(out()).datasets.at("missing_count").values, std::vector<double>{4});
  // The command that it names solves them.
  const std::size_t at = joined.out.find("bem_contact sweep");
  ASSERT_NE(at, std::string::npos) << joined.out;
  std::string command = joined.out.substr(at + 12, joined.out.find('\n', at) - at - 12);
  command.replace(command.find("cases_8_12.h5"), 13, "'" + (folder_ / "some parts/rest.h5").string() + "'");
  ASSERT_EQ(run(command).code, 0) << command;
  joined = sweep(cases, join);
  EXPECT_EQ(joined.code, 0) << joined.err;
  EXPECT_EQ(joined.out.find("missing"), std::string::npos);
  expect_equal(whole, found(out()));
  EXPECT_EQ(text_of(folder_ / "j_patches.csv"), patches);
}

/// The same cases give the same bytes. Only their seconds differ.
TEST_F(Sweep, APartIsTheSameBytesAgain) {
  const auto bytes = [&](const std::string& name) {
    EXPECT_EQ(part(cases, "3:9", name).code, 0);
    std::string text = text_of(folder_ / name);
    const H5Table table = read_h5(folder_ / name);
    for (const char* seconds : {"seconds", "cpu_seconds"}) {
      const std::vector<double>& values = table.datasets.at(seconds).values;
      const std::size_t at =
          text.find(std::string(reinterpret_cast<const char*>(values.data()), 8 * values.size()));
      EXPECT_NE(at, text.npos);
      text.replace(at, 8 * values.size() + 4, 8 * values.size() + 4, ' '); // and their checksum
    }
    return text;
  };
  EXPECT_EQ(bytes("a.h5"), bytes("b.h5"));
}

TEST_F(Sweep, ACutWithinAChunkIsAsExact) {
  ASSERT_EQ(sweep(cases).code, 0);
  const H5Table whole = read_h5(out());
  ASSERT_EQ(part(cases, "6:7", "p.h5").code, 0);
  const H5Table one = read_h5(folder_ / "p.h5");
  EXPECT_NEAR(one.datasets.at("Fx").values.at(0), whole.datasets.at("Fx").values[6], 1e-5 * 5e3);
  EXPECT_EQ(one.datasets.at("motion.xi").values,
            std::vector<double>{whole.datasets.at("motion.xi").values[6]});
  const Outcome info = run("info '" + (folder_ / "p.h5").string() + "'");
  EXPECT_EQ(info.code, 0) << info.err;
  EXPECT_THAT(info.out, HasSubstr("Some cases of a sweep"));
}

TEST_F(Sweep, PartsThatDoNotFitAreRefused) {
  const auto named = [&](const char* name) { return "'" + (folder_ / name).string() + "' "; };
  ASSERT_EQ(part(cases, "0:5", "a.h5").code, 0);
  ASSERT_EQ(part(cases, "4:6", "b.h5").code, 0);
  ASSERT_EQ(part(patch + "load.force = [4e3, 5e3]\n", "0:1", "other.h5").code, 0);
  const auto refused = [&](const std::string& parts, const std::string& words) {
    const Outcome r = sweep(cases, "--join " + parts);
    EXPECT_EQ(r.code, 2) << words;
    EXPECT_THAT(r.err, HasSubstr(words));
    EXPECT_FALSE(fs::exists(out()));
  };
  refused(named("a.h5") + named("b.h5"), "Two parts of the sweep have case 4");
  refused(named("a.h5") + named("a.h5"), "Two parts of the sweep have case 0");
  refused(named("a.h5") + named("other.h5"), "other.h5' belongs to another sweep");
  refused(named("a.h5") + "--strict", "a.h5' belongs to another sweep");
  refused(named("none.h5"), "there is no such file");
  refused(named("s.toml"), "cannot be read");
  ASSERT_EQ(run("solve '" +
                write("one.toml", "load.force = 1e3\n" + patch.substr(0, patch.find("[sweep]"))).string() +
                "' -o " + named("r.h5"))
                .code,
            0);
  refused(named("r.h5"), "is no part of a sweep");
  const Outcome over = run("sweep " + scene(cases) + " --join " + named("a.h5") + " -o " + named("a.h5"));
  EXPECT_EQ(over.code, 2);
  EXPECT_THAT(over.err, HasSubstr("would overwrite"));
}

/// Of more than 1000 cases only the totals are kept, unless the scene asks for more.
TEST_F(Sweep, ManyCasesKeepTheirTotals) {
  const std::string many = patch + "load.force = { from = 4e3, to = 5e3, count = 1001 }\n";
  EXPECT_EQ(run("sweep " + scene(many) + " --count").out, "1001\n");
  const auto keeps = [&](const std::string& text) {
    const Outcome one = part(text, "1000:1001", "p.h5");
    EXPECT_EQ(one.code, 0) << one.err;
    EXPECT_THAT(one.err, testing::Not(HasSubstr("totals")));
    return read_h5(folder_ / "p.h5").datasets.contains("cases/001000/p_n");
  };
  EXPECT_TRUE(keeps(many + "fields = true\n"));
  EXPECT_FALSE(keeps(many));
  const Outcome joined = sweep(many, "--join '" + (folder_ / "p.h5").string() + "'");
  EXPECT_EQ(joined.code, 3);
  EXPECT_THAT(joined.out, HasSubstr("1 of 1001 cases are certified; missing: 1000."));
  EXPECT_THAT(joined.err, HasSubstr("of 1001 cases only the totals are kept"));
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
  fs::create_directory(parts());
  ASSERT_EQ(part(cases, "0:4", "o.h5.parts/000000.h5").code, 0);
  EXPECT_THAT(sweep(patch + "load.force = [1e3]\n").err, HasSubstr("belongs to another sweep"));
  EXPECT_TRUE(fs::exists(parts() / "000000.h5"));
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
  EXPECT_THAT(input_paths(sweep), testing::UnorderedElementsAre(points, body));
  std::vector<std::string> keys;
  for (const InputRecord& input : given_sweep(sweep, "").inputs)
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
    EXPECT_FALSE(fs::exists(parts()));
  };
  refused(patch + "load.force = [1e3, 2e3, -1]\n", "", "load.force = -1.0 (out of range)");
  refused(patch, "", "no table [sweep]");
  refused(cases, "--cases 4:4", "there is no case in it");
  refused(cases, "--cases 5:4", "there is no case in it");
  refused(cases, "--cases 19:21", "the sweep has 20 cases, from 0 on");
  for (const char* odd : {"3", "3-4", "a:b", "-1:3", "1:2:3"})
    refused(cases, std::string("--cases ") + odd, "is not of the form 3200:6400");
  refused(cases, "--cases 0:1 --jobs 2", "excludes");
  refused(cases, "--cases 0:1 --join x.h5", "excludes");
  refused(cases, "--cases 0:1 --csv x.csv", "excludes");
  for (const char* gone : {"--part 1/2", "--merge"})
    refused(cases, gone, "Solve some cases with -o PART.h5 --cases 0:3200");
  refused(cases, "--jobs -1", "--jobs");
  EXPECT_THAT(run("sweep " + scene(cases)).err, HasSubstr("--output is required"));
}

/// A value that none of its cases has is nothing to a part.
TEST_F(Sweep, APartChecksItsOwnCases) {
  const std::string text = patch + "load.force = [1e3, 2e3, -1]\n";
  EXPECT_EQ(part(text, "0:2", "p.h5").code, 0);
  const Outcome wrong = part(text, "1:3", "q.h5");
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("load.force = -1.0 (out of range)"));
  EXPECT_FALSE(fs::exists(folder_ / "q.h5"));
}

TEST_F(Sweep, TwoCannotWorkInOneFolder) {
  const AskedSweep here = asked(cases);
  const app::PartsFolder first(here, out());
  const Outcome second = sweep(cases);
  EXPECT_EQ(second.code, 2);
  EXPECT_THAT(second.err, HasSubstr("is in use (another process writes it) Wait for it"));
}

/// Mirror images: what the right wheel bears at 2 mm, the left one bears at -2 mm.
TEST_F(Sweep, OfWheelsetsIsWhatTheWheelsetCommandSays) {
  const std::string wheelset = "rail.profile = \"60E1\"\nwheel.profile = \"S1002\"\nsolver.model = "
                               "\"halfspace\"\nposition.rail_inclination = 0.025\n"
                               "motion.friction = 0.3\ngrid.dx = 1\ngrid.ds = 1\n";
  const std::string swept = wheelset + "wheelset.force = 2e5\n[sweep]\nposition.lateral = [-2, 2]\n";
  const Outcome r = sweep(swept, "--csv '" + (folder_ / "o.csv").string() + "'");
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("2 of 2 cases are certified"));
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
  EXPECT_THAT(r.out, HasSubstr("1 of 2 cases are certified; refused: 1."));
  EXPECT_THAT(text_of(folder_ / "o.csv"), HasSubstr("lifts"));
}

} // namespace
