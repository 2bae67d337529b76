#include "meshes/heartbeat.hpp"

#include <fmt/format.h>

#include <ostream>
#include <utility>

namespace bem_contact::meshes {

Heartbeat::Heartbeat(std::string label, std::chrono::milliseconds every, std::ostream& out)
    : thread_([this, label = std::move(label), every, &out] {
        const auto begin = std::chrono::steady_clock::now();
        std::unique_lock lock(mutex_);
        while (!ended_.wait_for(lock, every, [this] { return over_; })) {
          const std::chrono::duration<double> so_far = std::chrono::steady_clock::now() - begin;
          out << fmt::format("{}: {:.0f} s so far", label, so_far.count()) << std::endl;
        }
      }) {}

Heartbeat::~Heartbeat() {
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
  }
  ended_.notify_all();
  thread_.join();
}

} // namespace bem_contact::meshes
