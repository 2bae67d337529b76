// What the C interface costs per call: a key is set by index, the scene is solved, totals and the first patch
// are copied. Each call is followed by Sequence::solve() of the same scene, read beforehand, so that other
// programs on the machine slow both; the median of the differences is the cost of the interface.
//
//     ninja -C build bench_c_interface && build/bin/bench_c_interface data/scenes/hertz.toml 2000
//
// You should see medians of both in microseconds, their difference with its quartiles (below 20), and the
// bytes in use after a tenth of the calls and after all: the same.

#include "bem_contact/c/conformal_contact.h"
#include "bem_contact/sequence/sequence.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fmt/format.h>
#include <malloc.h>
#include <string>
#include <vector>

using namespace bem_contact;
using Clock = std::chrono::steady_clock;

namespace {

constexpr int different_forces = 5;

double force_of(int i) {
  return 1e5 + 100 * (i % different_forces);
}

double microseconds(Clock::duration time) {
  return std::chrono::duration<double, std::micro>(time).count();
}

/// A scene behind the C interface.
class ThroughC {
public:
  explicit ThroughC(const char* file) {
    char message[1000];
    int model = 0;
    if (conformal_open_file(file, &contact_, message, sizeof message) != CONFORMAL_OK) {
      std::fprintf(stderr, "error: %s\n", message);
      std::exit(2);
    }
    require(conformal_key(contact_, "load.force", &force_));
    require(conformal_key(contact_, "solver.model", &model));
    require(conformal_set_text(contact_, model, "hertz"));
  }
  ~ThroughC() { conformal_close(contact_); }
  ThroughC(const ThroughC&) = delete;
  ThroughC& operator=(const ThroughC&) = delete;

  void call(int i) {
    double totals[CONFORMAL_TOTALS], patch[CONFORMAL_PATCH_VALUES];
    require(conformal_set_number(contact_, force_, force_of(i)));
    require(conformal_solve(contact_));
    require(conformal_totals(contact_, totals, CONFORMAL_TOTALS));
    require(conformal_patch(contact_, 0, patch, CONFORMAL_PATCH_VALUES));
  }

private:
  void require(int code) const {
    if (code == CONFORMAL_OK)
      return;
    std::fprintf(stderr, "error: %s\n", conformal_message(contact_));
    std::exit(2);
  }

  conformal_contact* contact_ = nullptr;
  int force_ = 0;
};

std::vector<SceneFile> scenes_of(const char* file) {
  std::vector<SceneFile> scenes;
  for (int i = 0; i < different_forces; ++i) {
    const std::vector<SceneChange> changes{{"load.force", force_of(i)}};
    scenes.push_back(with_model(read_scene_file(file, changes), Model::hertz));
  }
  return scenes;
}

double quantile(std::vector<double> values, double share) {
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

} // namespace

int main(int argc, char** argv) {
  const int calls = argc == 3 ? std::atoi(argv[2]) : 0;
  if (calls < 100) {
    std::fprintf(stderr, "usage: bench_c_interface SCENE.toml CALLS (at least 100)\n");
    return 2;
  }
  ThroughC c(argv[1]);
  const std::vector<SceneFile> scenes = scenes_of(argv[1]);
  Sequence sequence;
  std::vector<double> through_c, alone, difference;
  for (auto* times : {&through_c, &alone, &difference})
    times->reserve(static_cast<std::size_t>(calls));
  std::size_t early = 0;
  for (int i = -20; i < calls; ++i) { // the first ones read files
    const Clock::time_point begin = Clock::now();
    c.call(i + 20);
    const Clock::time_point middle = Clock::now();
    sequence.solve(scenes[static_cast<std::size_t>((i + 20) % different_forces)]);
    const Clock::time_point end = Clock::now();
    if (i == calls / 10)
      early = mallinfo2().uordblks;
    if (i < 0)
      continue;
    through_c.push_back(microseconds(middle - begin));
    alone.push_back(microseconds(end - middle));
    difference.push_back(through_c.back() - alone.back());
  }
  fmt::print("medians of {} calls: C interface {:.1f}, Sequence alone {:.1f} microseconds\n", calls,
             quantile(through_c, 0.5), quantile(alone, 0.5));
  fmt::print("cost of the interface: {:.1f} microseconds a call (quartiles {:.1f}, {:.1f})\n",
             quantile(difference, 0.5), quantile(difference, 0.25), quantile(difference, 0.75));
  fmt::print("bytes in use after {} calls {}, after {} calls {}\n", calls / 10, early, calls,
             mallinfo2().uordblks);
}
