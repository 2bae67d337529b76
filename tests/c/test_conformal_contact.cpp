#include "bem_contact/base/temporary_folder.hpp"
#include "bem_contact/c/conformal_contact.h"
#include "bem_contact/sequence/quantities.hpp"
#include "bem_contact/sequence/sequence.hpp"

#include <gmock/gmock.h>
#include <malloc.h>

#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <vector>

using namespace bem_contact;
using testing::AllOf;
using testing::HasSubstr;

extern "C" int c89_solve(conformal_contact* contact, double* totals);

namespace {

const std::string corner = CONFORMAL_SOURCE_DIR "/data/scenes/conformal_small.toml";
const std::string hertz = CONFORMAL_SOURCE_DIR "/data/scenes/hertz.toml";

struct Close {
  void operator()(conformal_contact* handle) const { conformal_close(handle); }
};
using Handle = std::unique_ptr<conformal_contact, Close>;

Handle open_file(const std::string& scene) {
  conformal_contact* handle = nullptr;
  char message[500] = "?";
  EXPECT_EQ(conformal_open_file(scene.c_str(), &handle, message, sizeof message), CONFORMAL_OK) << message;
  EXPECT_STREQ(message, "");
  return Handle(handle);
}

int key_of(const Handle& handle, const char* name) {
  int key = -1;
  EXPECT_EQ(conformal_key(handle.get(), name, &key), CONFORMAL_OK) << conformal_message(handle.get());
  return key;
}

std::string message_of_text(const std::string& toml) {
  conformal_contact* handle = nullptr;
  char message[500] = "";
  EXPECT_EQ(conformal_open_text(toml.c_str(), ".", &handle, message, sizeof message), CONFORMAL_WRONG_INPUT);
  EXPECT_EQ(handle, nullptr);
  return message;
}

TEST(C, IsWhatTheSequenceComputes) {
  const Handle contact = open_file(corner);
  const int lateral = key_of(contact, "position.lateral"), model = key_of(contact, "solver.model");
  EXPECT_EQ(key_of(contact, "position.lateral"), lateral);
  ASSERT_EQ(conformal_set_text(contact.get(), model, "halfspace"), CONFORMAL_OK);
  Sequence sequence;
  for (const double y : {6.4, 6.5}) {
    const std::vector<SceneChange> changes{{"position.lateral", y}};
    const SceneResult expected =
        sequence.solve(with_model(read_scene_file(corner, changes), Model::halfspace));
    double totals[CONFORMAL_TOTALS];
    ASSERT_EQ(conformal_set_number(contact.get(), lateral, y), CONFORMAL_OK);
    ASSERT_EQ(c89_solve(contact.get(), totals), CONFORMAL_OK) << conformal_message(contact.get());
    EXPECT_EQ(totals[CONFORMAL_FX], expected.result.totals.Fx);
    EXPECT_EQ(totals[CONFORMAL_FY], expected.result.totals.Fy);
    EXPECT_EQ(totals[CONFORMAL_FZ], expected.result.totals.Fz);
    EXPECT_EQ(totals[CONFORMAL_MZ], expected.moment);
    EXPECT_EQ(totals[CONFORMAL_PMAX], expected.result.totals.pmax);
    EXPECT_LE(totals[CONFORMAL_CERTIFICATE], 1e-6);
    int mx = 0, ms = 0;
    ASSERT_EQ(conformal_grid(contact.get(), &mx, &ms), CONFORMAL_OK);
    std::vector<double> pressure(static_cast<std::size_t>(mx * ms)), delta(static_cast<std::size_t>(ms));
    ASSERT_EQ(conformal_array(contact.get(), CONFORMAL_P_N, pressure.data(), mx * ms), CONFORMAL_OK);
    EXPECT_EQ(pressure, expected.result.pn);
    ASSERT_EQ(conformal_array(contact.get(), CONFORMAL_DELTA, delta.data(), ms), CONFORMAL_OK);
    EXPECT_EQ(delta.back(), expected.problem.rows.back().delta);
  }
}

/// Exact: largest pressure 1237.56 MPa, force 1e5 N (data/scenes/hertz.toml).
TEST(C, PatchesAndArraysAddUp) {
  const Handle contact = open_file(hertz);
  ASSERT_EQ(conformal_solve(contact.get()), CONFORMAL_OK) << conformal_message(contact.get());
  int count = 0, mx = 0, ms = 0;
  ASSERT_EQ(conformal_patch_count(contact.get(), &count), CONFORMAL_OK);
  ASSERT_EQ(count, 1);
  double patch[CONFORMAL_PATCH_VALUES];
  ASSERT_EQ(conformal_patch(contact.get(), 0, patch, CONFORMAL_PATCH_VALUES), CONFORMAL_OK);
  EXPECT_NEAR(patch[CONFORMAL_PATCH_FN], 1e5, 1e-2);
  EXPECT_NEAR(patch[CONFORMAL_PATCH_PMAX] / 1237.56, 1, 5e-3);
  EXPECT_NEAR(patch[CONFORMAL_PATCH_FZ], 1e5, 1e-2);
  EXPECT_NEAR(patch[CONFORMAL_PATCH_SEMI_AXIS_A] / 7.1617, 1, 2e-3);
  EXPECT_NEAR(patch[CONFORMAL_PATCH_SEMI_AXIS_B] / 5.3872, 1, 2e-3);
  EXPECT_TRUE(std::isnan(patch[CONFORMAL_PATCH_WHEEL_S])) << "a patch scene has no profiles";
  ASSERT_EQ(conformal_grid(contact.get(), &mx, &ms), CONFORMAL_OK);
  std::vector<double> x(static_cast<std::size_t>(mx));
  ASSERT_EQ(conformal_array(contact.get(), CONFORMAL_X, x.data(), mx), CONFORMAL_OK);
  EXPECT_NEAR(x[1] - x[0], 0.4, 1e-12);
  std::vector<double> values(static_cast<std::size_t>(mx * ms));
  for (int which = CONFORMAL_P_X; which <= CONFORMAL_STATE; ++which) {
    EXPECT_EQ(conformal_array(contact.get(), which, values.data(), mx * ms), CONFORMAL_OK) << which;
    for (const double value : values)
      ASSERT_TRUE(std::isfinite(value)) << which;
  }
  EXPECT_EQ(std::ranges::count_if(values, [](double state) { return state > 0; }),
            patch[CONFORMAL_PATCH_CONTACT]);
}

/// The order of the header is that of the table: each value is the one of its name.
TEST(C, PatchValuesAreThoseOfTheirNames) {
  const Handle contact = open_file(corner);
  ASSERT_EQ(conformal_set_text(contact.get(), key_of(contact, "solver.model"), "halfspace"), CONFORMAL_OK);
  ASSERT_EQ(conformal_solve(contact.get()), CONFORMAL_OK);
  const SceneResult expected = Sequence().solve(with_model(read_scene_file(corner), Model::halfspace));
  double patch[CONFORMAL_PATCH_VALUES];
  ASSERT_EQ(conformal_patch(contact.get(), 0, patch, CONFORMAL_PATCH_VALUES), CONFORMAL_OK);
  const PatchSummary& p = expected.result.patches.front();
  const PatchPlace& place = expected.patch_places.front();
  const std::pair<int, double> values[] = {{CONFORMAL_PATCH_FN, p.fn},
                                           {CONFORMAL_PATCH_FS, p.fs},
                                           {CONFORMAL_PATCH_X, p.x},
                                           {CONFORMAL_PATCH_SLIP, p.slip},
                                           {CONFORMAL_PATCH_FY, p.fy},
                                           {CONFORMAL_PATCH_MX, p.moment_x},
                                           {CONFORMAL_PATCH_MN, p.moment_n},
                                           {CONFORMAL_PATCH_SEMI_AXIS_B, p.semi_axis_b},
                                           {CONFORMAL_PATCH_AXIS_ANGLE, p.axis_angle},
                                           {CONFORMAL_PATCH_Y, p.position.y},
                                           {CONFORMAL_PATCH_DELTA, p.delta},
                                           {CONFORMAL_PATCH_RAIL_Z, place.rail_z},
                                           {CONFORMAL_PATCH_WHEEL_S, place.wheel_s},
                                           {CONFORMAL_PATCH_WHEEL_DELTA, place.wheel_delta},
                                           {CONFORMAL_PATCH_ETA, place.eta},
                                           {CONFORMAL_PATCH_PHI, place.phi},
                                           {CONFORMAL_PATCH_FRICTION_POWER, p.T_gamma}};
  for (const auto& [index, value] : values)
    EXPECT_EQ(patch[index], value) << index;
}

/// What is prescribed has the error 0, and what has no error is not a number.
TEST(C, StatedErrorsAndTheModelAreThoseOfTheResult) {
  const Handle contact = open_file(corner);
  ASSERT_EQ(conformal_set_text(contact.get(), key_of(contact, "solver.model"), "halfspace"), CONFORMAL_OK);
  ASSERT_EQ(conformal_solve(contact.get()), CONFORMAL_OK);
  const SceneResult expected = Sequence().solve(with_model(read_scene_file(corner), Model::halfspace));
  const ContactResult& r = expected.result;
  double totals[CONFORMAL_TOTALS], patch[CONFORMAL_PATCH_VALUES];
  ASSERT_EQ(conformal_total_errors(contact.get(), totals, CONFORMAL_TOTALS), CONFORMAL_OK);
  EXPECT_GT(r.totals.Fx.error, 0);
  EXPECT_EQ(totals[CONFORMAL_FX], r.totals.Fx.error);
  EXPECT_EQ(totals[CONFORMAL_PMAX], r.totals.pmax.error);
  EXPECT_EQ(totals[CONFORMAL_FRICTION_POWER], r.totals.T_gamma.error);
  EXPECT_EQ(totals[CONFORMAL_FZ], 0);
  EXPECT_TRUE(std::isnan(totals[CONFORMAL_CERTIFICATE]));
  ASSERT_EQ(conformal_patch_errors(contact.get(), 0, patch, CONFORMAL_PATCH_VALUES), CONFORMAL_OK);
  EXPECT_EQ(patch[CONFORMAL_PATCH_FS], r.patches.front().fs.error);
  EXPECT_EQ(patch[CONFORMAL_PATCH_AREA], r.patches.front().area.error);
  EXPECT_EQ(patch[CONFORMAL_PATCH_MN], r.patches.front().moment_n.error);
  EXPECT_TRUE(std::isnan(patch[CONFORMAL_PATCH_CONTACT]));
  const char *name = nullptr, *reason = nullptr;
  ASSERT_EQ(conformal_model(contact.get(), &name, &reason), CONFORMAL_OK);
  EXPECT_STREQ(name, "halfspace");
  EXPECT_EQ(reason, expected.choice.why_this_model);
  const char* why = nullptr;
  ASSERT_EQ(conformal_why_no_errors(contact.get(), &why), CONFORMAL_OK);
  EXPECT_EQ(why, why_no_errors(expected));
}

TEST(C, NumbersAreAskedByTheirPaths) {
  const Handle contact = open_file(hertz);
  double value = -7, totals[CONFORMAL_TOTALS], patch[CONFORMAL_PATCH_VALUES];
  const auto ask = [&](const char* path) { return conformal_number(contact.get(), path, &value); };
  const auto refused = [&](const char* path) {
    return ask(path) == CONFORMAL_WRONG_INPUT ? std::string(conformal_message(contact.get())) : "no error";
  };
  EXPECT_THAT(refused("quantities/Fx"), HasSubstr("There is no result"));
  for (const double force : {5e4, 1e5}) { // the paths are those of the last result
    conformal_set_number(contact.get(), key_of(contact, "load.force"), force);
    ASSERT_EQ(conformal_solve(contact.get()), CONFORMAL_OK);
    conformal_totals(contact.get(), totals, CONFORMAL_TOTALS);
    conformal_patch(contact.get(), 0, patch, CONFORMAL_PATCH_VALUES);
    for (const auto& [path, expected] : {std::pair("quantities/pmax", totals[CONFORMAL_PMAX]),
                                         {"quantities/Fz", force},
                                         {"patches/0/Fn", patch[CONFORMAL_PATCH_FN]},
                                         {"patches/0/semi_axis_a", patch[CONFORMAL_PATCH_SEMI_AXIS_A]},
                                         {"certified", 1.0},
                                         {"friction", 0.0}}) {
      ASSERT_EQ(ask(path), CONFORMAL_OK) << conformal_message(contact.get());
      EXPECT_EQ(value, expected) << path;
    }
    double x[40];
    ASSERT_EQ(conformal_array(contact.get(), CONFORMAL_X, x, 40), CONFORMAL_OK);
    ASSERT_EQ(ask("x/3"), CONFORMAL_OK); // fields, too
    EXPECT_EQ(value, x[3]);
  }
  ASSERT_EQ(ask("quantities/free_rolling_radius"), CONFORMAL_OK);
  EXPECT_TRUE(std::isnan(value)); // there is none
  value = -7;
  EXPECT_THAT(refused("quantities/Fxx"), HasSubstr("Did you mean quantities/Fx"));
  EXPECT_THAT(refused("Fn"), HasSubstr("Did you mean patches/0/Fn?"));
  EXPECT_THAT(refused("patches/1/Fn"), HasSubstr("patches/0/Fn"));
  EXPECT_THAT(refused("patches/Fn"), HasSubstr("several numbers"));
  EXPECT_THAT(refused("model"), HasSubstr("'model' is no number (a text"));
  EXPECT_THAT(refused(""), HasSubstr("no path ''"));
  EXPECT_EQ(value, -7);
  EXPECT_EQ(conformal_number(contact.get(), nullptr, &value), CONFORMAL_WRONG_INPUT);
  EXPECT_EQ(conformal_number(contact.get(), "certified", nullptr), CONFORMAL_WRONG_INPUT);
}

TEST(C, SaysWhatIsWrong) {
  EXPECT_THAT(message_of_text("kind = \"wheel_rai\""), HasSubstr("wheel_rail"));
  EXPECT_THAT(message_of_text("load.forze = 1"), HasSubstr("load.force"));
  EXPECT_THAT(message_of_text("="), HasSubstr("not valid TOML"));
  char tiny[4];
  conformal_contact* none = nullptr;
  EXPECT_EQ(conformal_open_file("no/such.toml", &none, tiny, sizeof tiny), CONFORMAL_WRONG_INPUT);
  EXPECT_EQ(std::string(tiny).size(), 3u);
  EXPECT_EQ(conformal_open_file("no/such.toml", &none, nullptr, 0), CONFORMAL_WRONG_INPUT);

  const Handle contact = open_file(hertz);
  const auto refused = [&](int code) {
    return code == CONFORMAL_WRONG_INPUT ? std::string(conformal_message(contact.get())) : "no error";
  };
  int key = -1, number = 0;
  double value[2] = {1, 2};
  EXPECT_THAT(refused(conformal_key(contact.get(), "load.forze", &key)), HasSubstr("load.force"));
  EXPECT_EQ(key, -1);
  EXPECT_THAT(refused(conformal_set_number(contact.get(), 5, 1.0)), HasSubstr("no key with the index 5"));
  EXPECT_THAT(refused(conformal_totals(contact.get(), value, 2)), HasSubstr("There is no result"));
  EXPECT_THAT(refused(conformal_grid(contact.get(), &number, &number)), HasSubstr("There is no result"));
  EXPECT_THAT(refused(conformal_total_errors(contact.get(), value, 2)), HasSubstr("There is no result"));
  const int force = key_of(contact, "load.force");
  EXPECT_THAT(refused(conformal_set_number(contact.get(), force, std::nan(""))), HasSubstr("must be finite"));
  EXPECT_THAT(refused(conformal_set_text(contact.get(), force, "much")), HasSubstr("load.force is text"));
  EXPECT_THAT(refused(conformal_set_numbers(contact.get(), force, value, 2)),
              HasSubstr("load.force is a list"));
  EXPECT_THAT(refused(conformal_set_numbers(contact.get(), force, value, -1)), HasSubstr("-1 numbers"));
  EXPECT_THAT(refused(conformal_set_text(contact.get(), force, nullptr)), HasSubstr("null pointer"));
  ASSERT_EQ(conformal_solve(contact.get()), CONFORMAL_OK); // the force is still that of the file
  ASSERT_EQ(conformal_totals(contact.get(), value, 2), CONFORMAL_OK);
  EXPECT_STREQ(conformal_message(contact.get()), "");
  EXPECT_THAT(refused(conformal_totals(contact.get(), value, 99)), HasSubstr("there are 13"));
  EXPECT_THAT(refused(conformal_array(contact.get(), CONFORMAL_P_N, value, 2)),
              HasSubstr("mx = 40 by ms = 40"));
  EXPECT_THAT(refused(conformal_array(contact.get(), CONFORMAL_P_N, value, -2)), HasSubstr("0 values"));
  EXPECT_THAT(refused(conformal_array(contact.get(), 99, value, 2)), HasSubstr("no array 99"));
  EXPECT_THAT(refused(conformal_patch(contact.get(), 1, value, 2)), HasSubstr("no patch 1"));
  EXPECT_THAT(refused(conformal_patch_errors(contact.get(), 1, value, 2)), HasSubstr("no patch 1"));
  EXPECT_THAT(refused(conformal_model(contact.get(), nullptr, nullptr)), HasSubstr("null pointer"));
  EXPECT_THAT(refused(conformal_warning(contact.get(), 7, nullptr)), HasSubstr("null pointer"));
}

/// What was set is forgotten; a flag is no number. The JSON is that of the result.
TEST(C, KeysAreResetAndTheAnswerIsThatOfTheProgram) {
  const Handle contact = open_file(hertz);
  const int force = key_of(contact, "load.force"), flag = key_of(contact, "motion.frictionless");
  const auto json = [&] {
    const char* text = nullptr;
    EXPECT_EQ(conformal_solve(contact.get()), CONFORMAL_OK) << conformal_message(contact.get());
    EXPECT_EQ(conformal_json(contact.get(), &text), CONFORMAL_OK);
    EXPECT_THAT(text,
                AllOf(testing::StartsWith("{"), HasSubstr("\"found\""), HasSubstr("bem_contact result")));
    double fz = 0;
    EXPECT_EQ(conformal_number(contact.get(), "quantities/Fz", &fz), CONFORMAL_OK);
    return fz;
  };
  const double given = json();
  ASSERT_EQ(conformal_set_number(contact.get(), force, 2 * given), CONFORMAL_OK);
  EXPECT_NEAR(json(), 2 * given, 1e-6 * given);
  ASSERT_EQ(conformal_reset(contact.get()), CONFORMAL_OK);
  EXPECT_NEAR(json(), given, 1e-6 * given);
  EXPECT_EQ(conformal_set_flag(contact.get(), force, 1), CONFORMAL_WRONG_INPUT);
  EXPECT_THAT(conformal_message(contact.get()), HasSubstr("load.force is true or false"));
  EXPECT_EQ(conformal_set_flag(contact.get(), flag, 1), CONFORMAL_OK);
  EXPECT_EQ(conformal_reset(nullptr), CONFORMAL_WRONG_INPUT);
}

TEST(C, NullPointersAreRefused) {
  EXPECT_EQ(conformal_solve(nullptr), CONFORMAL_WRONG_INPUT);
  EXPECT_EQ(conformal_stop(nullptr), CONFORMAL_WRONG_INPUT);
  EXPECT_EQ(conformal_totals(nullptr, nullptr, 1), CONFORMAL_WRONG_INPUT);
  EXPECT_EQ(conformal_open_file(nullptr, nullptr, nullptr, 0), CONFORMAL_WRONG_INPUT);
  EXPECT_EQ(conformal_open_text(nullptr, nullptr, nullptr, nullptr, 0), CONFORMAL_WRONG_INPUT);
  EXPECT_THAT(conformal_message(nullptr), HasSubstr("null pointer"));
  conformal_close(nullptr);
  const Handle contact = open_file(hertz);
  EXPECT_EQ(conformal_key(contact.get(), nullptr, nullptr), CONFORMAL_WRONG_INPUT);
  EXPECT_EQ(conformal_set_numbers(contact.get(), 0, nullptr, 3), CONFORMAL_WRONG_INPUT);
}

TEST(C, NumbersServeFlagsAndWholeNumbers) {
  const Handle contact = open_file(hertz);
  const int mx = key_of(contact, "grid.mx"), frictionless = key_of(contact, "motion.frictionless");
  EXPECT_EQ(conformal_set_number(contact.get(), mx, 42), CONFORMAL_OK);
  EXPECT_EQ(conformal_set_number(contact.get(), frictionless, 1), CONFORMAL_OK);
  ASSERT_EQ(conformal_solve(contact.get()), CONFORMAL_OK) << conformal_message(contact.get());
  int columns = 0, rows = 0;
  conformal_grid(contact.get(), &columns, &rows);
  EXPECT_EQ(columns, 42);
  EXPECT_EQ(conformal_set_number(contact.get(), mx, 42.5), CONFORMAL_WRONG_INPUT);
  EXPECT_EQ(conformal_set_number(contact.get(), mx, 1e300), CONFORMAL_WRONG_INPUT);
  EXPECT_EQ(conformal_set_number(contact.get(), frictionless, 0.5), CONFORMAL_WRONG_INPUT);
}

TEST(C, ARefusedSolutionLeavesNoResult) {
  const Handle contact = open_file(hertz);
  ASSERT_EQ(conformal_solve(contact.get()), CONFORMAL_OK);
  const int approach = key_of(contact, "load.approach");
  ASSERT_EQ(conformal_set_number(contact.get(), approach, 0.1), CONFORMAL_OK);
  EXPECT_EQ(conformal_solve(contact.get()), CONFORMAL_WRONG_INPUT);
  EXPECT_THAT(conformal_message(contact.get()), HasSubstr("load.force is given too"));
  double fx = 0;
  EXPECT_EQ(conformal_totals(contact.get(), &fx, 1), CONFORMAL_WRONG_INPUT);
}

/// Unlike bodies that may take one outer iteration only are no solution; bodies apart always are one.
TEST(C, NamesTheStepThatFailed) {
  const TemporaryFolder folder;
  folder.write("steps.csv", "load\n0.01\n-0.01\n");
  const Handle contact = open_file(folder.write(
      "s.toml", "kind = 'patch'\nload.approach = 0.01\n[motion]\nkind = 'shift'\nfriction = 0.3\n"
                "xi = 1e-3\nstep_table = 'steps.csv'\n[grid]\ndx = 0.5\nds = 0.5\nmx = 16\nms = 16\n"
                "[gap]\na = 1e-3\nb = 1e-3\n[wheel.material]\nshear_modulus = 800\npoisson = 0\n"
                "[solver]\nmax_outer = 1\n"));
  EXPECT_EQ(conformal_solve(contact.get()), CONFORMAL_NOT_CONVERGED);
  EXPECT_THAT(conformal_message(contact.get()), HasSubstr("step 1 of 2 is not a solution"));
  double totals[CONFORMAL_TOTALS];
  ASSERT_EQ(conformal_totals(contact.get(), totals, CONFORMAL_TOTALS), CONFORMAL_OK);
  EXPECT_LE(totals[CONFORMAL_CERTIFICATE], 1e-6) << "that of the last step";
}

/// Whoever asks for a stop cannot know whether the solution has begun.
TEST(C, AStopBeforeTheSolutionIsNotLost) {
  const Handle contact = open_file(hertz);
  double totals[CONFORMAL_TOTALS];
  ASSERT_EQ(conformal_stop(contact.get()), CONFORMAL_OK);
  ASSERT_EQ(conformal_stop(contact.get()), CONFORMAL_OK);
  EXPECT_EQ(conformal_solve(contact.get()), CONFORMAL_STOPPED);
  EXPECT_THAT(conformal_message(contact.get()), HasSubstr("stopped"));
  EXPECT_EQ(conformal_totals(contact.get(), totals, 1), CONFORMAL_WRONG_INPUT) << "there is no result";
  EXPECT_EQ(conformal_solve(contact.get()), CONFORMAL_OK) << "a stop ends one solution";
}

TEST(C, AnotherThreadStopsASolution) {
  const Handle contact = open_file(corner);
  for (const char* key : {"grid.dx", "grid.ds"})
    ASSERT_EQ(conformal_set_number(contact.get(), key_of(contact, key), 0.06), CONFORMAL_OK);
  ASSERT_EQ(conformal_set_text(contact.get(), key_of(contact, "solver.model"), "halfspace"), CONFORMAL_OK);
  std::thread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    conformal_stop(contact.get());
  });
  EXPECT_EQ(conformal_solve(contact.get()), CONFORMAL_STOPPED);
  other.join();
  EXPECT_THAT(conformal_message(contact.get()), HasSubstr("stopped"));
}

TEST(C, HandlesWorkSideBySide) {
  std::vector<double> forces(4), alone(4);
  const auto solve = [](double y) {
    const Handle contact = open_file(corner);
    conformal_set_text(contact.get(), key_of(contact, "solver.model"), "fem");
    conformal_set_number(contact.get(), key_of(contact, "position.lateral"), y);
    double totals[CONFORMAL_TOTALS] = {};
    EXPECT_EQ(c89_solve(contact.get(), totals), CONFORMAL_OK) << conformal_message(contact.get());
    return totals[CONFORMAL_FY];
  };
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < forces.size(); ++i)
    threads.emplace_back([&, i] { forces[i] = solve(6.3 + 0.1 * static_cast<double>(i)); });
  for (std::thread& thread : threads)
    thread.join();
  for (std::size_t i = 0; i < forces.size(); ++i)
    alone[i] = solve(6.3 + 0.1 * static_cast<double>(i));
  EXPECT_EQ(forces, alone);
}

/// Bytes in use after many calls are those after a few.
TEST(C, MemoryDoesNotGrowWithTheNumberOfCalls) {
#ifdef CONFORMAL_SANITIZED
  GTEST_SKIP() << "the sanitizer's allocator does not count";
#endif
  const Handle contact = open_file(hertz);
  const int force = key_of(contact, "load.force");
  std::vector<double> pressure(1600);
  const auto call = [&](int i) {
    double totals[CONFORMAL_TOTALS];
    conformal_set_number(contact.get(), force, 1e5 + 10 * (i % 7));
    ASSERT_EQ(conformal_set_number(contact.get(), force, -1), CONFORMAL_WRONG_INPUT);
    ASSERT_EQ(c89_solve(contact.get(), totals), CONFORMAL_OK);
    ASSERT_EQ(conformal_array(contact.get(), CONFORMAL_P_N, pressure.data(), 1600), CONFORMAL_OK);
  };
  const auto calls = [&](int count) {
    for (int i = 0; i < count; ++i)
      call(i);
    return mallinfo2().uordblks;
  };
  const auto few = calls(20);
  EXPECT_LT(calls(100), few + 10'000);
}

} // namespace
