// What the C interface costs per call: a key is set by index, the scene is solved, totals and the first patch
// are copied. With each call goes Sequence::solve() of the same scene, read beforehand; now one of them is
// first, now the other. The median of the differences in this thread's processor time is the cost of the
// interface, so that other programs on the machine hardly count.
//
//     ninja -C build bench_c_interface && build/bin/bench_c_interface data/scenes/hertz.toml 2000
//
// You should see medians of both in microseconds, their difference with its quartiles (below 20), and the
// bytes in use after a tenth of the calls, half and all: they do not grow with the number of calls.
//
// With a table of `bem_contact table` instead of a scene: microseconds of one look-up, at points spread over
// the axes.

#include "bem_contact/c/conformal_contact.h"
#include "bem_contact/scene/scene_reader.hpp"
#include "bem_contact/sequence/sequence.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fmt/format.h>
#include <malloc.h>
#include <string>
#include <string_view>
#include <time.h>
#include <vector>

using namespace bem_contact;

namespace {

constexpr int different_forces = 5;

double force_of(int i) {
  return 1e5 + 100 * (i % different_forces);
}

/// Processor time of this thread.
double microseconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

template <class Call> double microseconds_of(const Call& call) {
  const double begin = microseconds();
  call();
  return microseconds() - begin;
}

struct Element {
  const char* key;
  double value;
};
/// Few and large elements: the shorter a solution takes, the better the difference is known.
constexpr Element few_elements[] = {{"grid.mx", 10}, {"grid.ms", 10}, {"grid.dx", 1.8}, {"grid.ds", 1.4}};

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
    for (const auto& [name, value] : few_elements) {
      int key = 0;
      require(conformal_key(contact_, name, &key));
      require(conformal_set_number(contact_, key, value));
    }
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
    SceneReader reader(read_scene_text(file));
    reader.set_number("load.force", force_of(i));
    for (const auto& [name, value] : few_elements)
      reader.set_number(name, value);
    scenes.push_back(with_model(reader.scene(), Model::hertz));
  }
  return scenes;
}

double quantile(std::vector<double> values, double share) {
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// Look-ups of all columns at points of a sequence that fills the axes evenly (Weyl 1916).
int time_table(const char* file, int calls) {
  conformal_table* table = nullptr;
  char message[1000];
  if (conformal_table_open(file, &table, message, sizeof message) != CONFORMAL_OK) {
    std::fprintf(stderr, "error: %s\n", message);
    return 2;
  }
  int axes = 0, columns = 0, failed = 0;
  conformal_table_size(table, &axes, &columns);
  std::vector<double> at(static_cast<std::size_t>(axes)), values(static_cast<std::size_t>(columns));
  const double took = microseconds_of([&] {
    for (int i = 0; i < calls; ++i) {
      for (int a = 0; a < axes; ++a) {
        double from = 0, to = 0, share = std::fmod(i * std::sqrt(2.0 + a), 1.0);
        conformal_table_axis(table, a, nullptr, nullptr, &from, &to);
        at[static_cast<std::size_t>(a)] = from + share * (to - from);
      }
      failed += conformal_table_look_up(table, at.data(), axes, values.data(), nullptr, columns, message,
                                        sizeof message) != CONFORMAL_OK;
    }
  });
  conformal_table_close(table);
  fmt::print("{} look-ups of {} columns over {} axes: {:.2f} microseconds each, {} failed\n", calls, columns,
             axes, took / calls, failed);
  return failed == 0 ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) {
  const int calls = argc == 3 ? std::atoi(argv[2]) : 0;
  if (calls < 100) {
    std::fprintf(stderr, "usage: bench_c_interface SCENE.toml|TABLE.h5 CALLS (at least 100)\n");
    return 2;
  }
  if (std::string_view(argv[1]).ends_with(".h5"))
    return time_table(argv[1], calls);
  ThroughC c(argv[1]);
  const std::vector<SceneFile> scenes = scenes_of(argv[1]);
  Sequence sequence;
  std::vector<double> through_c, alone, difference;
  for (auto* times : {&through_c, &alone, &difference})
    times->reserve(static_cast<std::size_t>(calls));
  std::size_t early = 0, half = 0;
  for (int i = -20; i < calls; ++i) { // the first ones read files
    const int force = (i + 20) / 2;   // each twice: with either order
    const auto by_c = [&] { c.call(force); };
    const auto by_sequence = [&] {
      sequence.solve(scenes[static_cast<std::size_t>(force % different_forces)]);
    };
    const double first = i % 2 == 0 ? microseconds_of(by_c) : microseconds_of(by_sequence);
    const double second = i % 2 == 0 ? microseconds_of(by_sequence) : microseconds_of(by_c);
    if (i == calls / 10)
      early = mallinfo2().uordblks;
    if (i == calls / 2)
      half = mallinfo2().uordblks;
    if (i < 0)
      continue;
    through_c.push_back(i % 2 == 0 ? first : second);
    alone.push_back(i % 2 == 0 ? second : first);
    difference.push_back(through_c.back() - alone.back());
  }
  const std::size_t late = mallinfo2().uordblks; // before anything is printed
  fmt::print("medians of {} calls: C interface {:.1f}, Sequence alone {:.1f} microseconds\n", calls,
             quantile(through_c, 0.5), quantile(alone, 0.5));
  fmt::print("cost of the interface: {:.1f} microseconds a call (quartiles {:.1f}, {:.1f})\n",
             quantile(difference, 0.5), quantile(difference, 0.25), quantile(difference, 0.75));
  fmt::print("bytes in use after {} calls {}, after {} calls {}, after {} calls {}\n", calls / 10, early,
             calls / 2, half, calls, late);
}
