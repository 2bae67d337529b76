#include "bem_contact/contact/work.hpp"
#include "bem_contact/scene/scene_reader.hpp"
#include "bem_contact/sequence/sequence.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

// Also run under the thread sanitizer (preset sanitize-threads).
namespace {

using namespace bem_contact;

/// With influence files, so that HDF5 is used from several threads too.
SceneFile corner(double lateral) {
  const std::vector<SceneChange> changes{{"position.lateral", lateral}, {"grid.dx", 1.0}, {"grid.ds", 1.0}};
  return with_model(read_scene_file(CONFORMAL_SOURCE_DIR "/data/scenes/conformal_small.toml", changes),
                    Model::fem);
}

template <class Work> void in_threads(std::size_t count, const Work& work) {
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < count; ++i)
    threads.emplace_back([&work, i] { work(i); });
  for (std::thread& thread : threads)
    thread.join();
}

TEST(Threads, OneSequenceIsCalledByMany) {
  Sequence sequence;
  std::vector<SceneResult> results(6);
  in_threads(3, [&](std::size_t i) {
    for (const std::size_t k : {2 * i, 2 * i + 1})
      results[k] = sequence.solve(corner(6.2 + 0.1 * static_cast<double>(k)));
  });
  EXPECT_EQ(sequence.counts().cases, 6);
  for (std::size_t k = 0; k < results.size(); ++k) {
    const SceneResult alone = Sequence().solve(corner(6.2 + 0.1 * static_cast<double>(k)));
    ASSERT_TRUE(results[k].result.certified());
    EXPECT_NEAR(results[k].result.totals.Fy, alone.result.totals.Fy, 1e-5 * alone.result.totals.Fz);
    EXPECT_NEAR(results[k].result.totals.Fx, alone.result.totals.Fx, 1e-4 * alone.result.totals.Fz);
  }
}

TEST(Threads, SequencesWorkSideBySide) {
  std::vector<double> together(4), alone(4);
  const auto fy = [](std::size_t i) {
    return Sequence().solve(corner(6.2 + 0.1 * static_cast<double>(i))).result.totals.Fy;
  };
  in_threads(together.size(), [&](std::size_t i) { together[i] = fy(i); });
  for (std::size_t i = 0; i < alone.size(); ++i)
    alone[i] = fy(i);
  EXPECT_EQ(together, alone);
}

TEST(Threads, ASolutionIsStoppedAndTheSequenceGoesOn) {
  Sequence sequence;
  const SceneFile scene = corner(6.4);
  std::atomic<bool> stop = true;
  EXPECT_THROW(sequence.solve(scene, &stop), Stopped);
  SceneFile long_one = with_model(scene, Model::halfspace);
  long_one.grid.dx = long_one.grid.ds = 0.04;
  stop = false;
  std::thread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    stop = true;
  });
  EXPECT_THROW(sequence.solve(long_one, &stop), Stopped);
  other.join();
  EXPECT_EQ(sequence.solve(scene).result.certified(), Sequence().solve(scene).result.certified());
}

} // namespace
