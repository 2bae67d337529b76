#include "meshes/heartbeat.hpp"

#include <fmt/format.h>

#include <condition_variable>
#include <mutex>
#include <ostream>
#include <utility>

namespace bem_contact::meshes {

Heartbeat::Heartbeat(std::string label, std::chrono::milliseconds every, std::ostream& out)
    : thread_([label = std::move(label), every, &out](const std::stop_token& end) {
        const auto begin = std::chrono::steady_clock::now();
        std::mutex mutex;
        std::unique_lock lock(mutex);
        std::condition_variable_any until_end;
        while (!until_end.wait_for(lock, end, every, [&end] { return end.stop_requested(); })) {
          const std::chrono::duration<double> so_far = std::chrono::steady_clock::now() - begin;
          out << fmt::format("{}: {:.0f} s so far", label, so_far.count()) << std::endl;
        }
      }) {}

} // namespace bem_contact::meshes
