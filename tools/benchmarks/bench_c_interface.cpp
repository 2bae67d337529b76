// What the C interface costs per call: a key is set by index, the scene is solved, totals and the first patch
// are copied. Compared with Sequence::solve() of the same scenes, read beforehand.
//
//     ninja -C build bench_c_interface && build/bin/bench_c_interface data/scenes/hertz.toml 2000
//
// You should see microseconds a call of both, and the difference, which is the cost of the interface:
// below 20.

#include "bem_contact/c/conformal_contact.h"
#include "bem_contact/sequence/sequence.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fmt/format.h>
#include <string>
#include <vector>

using namespace bem_contact;
using Clock = std::chrono::steady_clock;

namespace {

double force_of(int i) {
  return 1e5 + 100 * (i % 5);
}

double microseconds(Clock::duration time, int calls) {
  return std::chrono::duration<double, std::micro>(time).count() / calls;
}

double through_c(const char* file, int calls) {
  conformal_contact* contact = nullptr;
  char message[1000];
  int force = 0, model = 0;
  if (conformal_open_file(file, &contact, message, sizeof message) != CONFORMAL_OK ||
      conformal_key(contact, "load.force", &force) != CONFORMAL_OK ||
      conformal_key(contact, "solver.model", &model) != CONFORMAL_OK ||
      conformal_set_text(contact, model, "hertz") != CONFORMAL_OK) {
    std::fprintf(stderr, "error: %s%s\n", message, conformal_message(contact));
    std::exit(2);
  }
  double totals[CONFORMAL_TOTALS], patch[CONFORMAL_PATCH_VALUES];
  const auto begin = Clock::now();
  for (int i = 0; i < calls; ++i)
    if (conformal_set_number(contact, force, force_of(i)) != CONFORMAL_OK ||
        conformal_solve(contact) != CONFORMAL_OK ||
        conformal_totals(contact, totals, CONFORMAL_TOTALS) != CONFORMAL_OK ||
        conformal_patch(contact, 0, patch, CONFORMAL_PATCH_VALUES) != CONFORMAL_OK) {
      std::fprintf(stderr, "error: %s\n", conformal_message(contact));
      std::exit(2);
    }
  const double each = microseconds(Clock::now() - begin, calls);
  conformal_close(contact);
  return each;
}

double by_sequence(const char* file, int calls) {
  std::vector<SceneFile> scenes;
  for (int i = 0; i < 5; ++i) {
    const std::vector<SceneChange> changes{{"load.force", force_of(i)}};
    scenes.push_back(with_model(read_scene_file(file, changes), Model::hertz));
  }
  Sequence sequence;
  const auto begin = Clock::now();
  for (int i = 0; i < calls; ++i)
    sequence.solve(scenes[static_cast<std::size_t>(i % 5)]);
  return microseconds(Clock::now() - begin, calls);
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: bench_c_interface SCENE.toml CALLS\n");
    return 2;
  }
  const int calls = std::atoi(argv[2]);
  double c = 1e300, sequence = 1e300;
  for (int round = 0; round < 7; ++round) { // the least of several rounds: other programs run too
    c = std::min(c, through_c(argv[1], calls));
    sequence = std::min(sequence, by_sequence(argv[1], calls));
  }
  fmt::print("C interface {:.1f}, Sequence alone {:.1f}, difference {:.1f} microseconds a call\n", c,
             sequence, c - sequence);
}
