#include "bem_contact/base/workers.hpp"

#include "bem_contact/base/error.hpp"

#include <condition_variable>
#include <fmt/format.h>
#include <map>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace bem_contact {

struct Workers::Started {
  std::mutex mutex;
  std::condition_variable one_ended;
  std::vector<EndOfWork> ended;
  std::map<std::size_t, std::jthread> threads; ///< by number; they end before what they use
};

Workers::Workers(std::filesystem::path temporary)
    : temporary_(std::move(temporary)), started_(std::make_unique<Started>()) {}

Workers::~Workers() = default;

std::size_t Workers::size() const {
  return started_->threads.size();
}

void Workers::start(std::size_t number, const std::function<int()>& work) {
  try {
    started_->threads[number] = std::jthread([this, number, work] {
      const int code = work();
      const std::lock_guard lock(started_->mutex);
      started_->ended.push_back(
          {number, code, fmt::format("the thread that solved it ended with code {}", code)});
      started_->one_ended.notify_one();
    });
  } catch (const std::system_error& error) {
    started_->threads.erase(number);
    throw Error("No thread to solve cases can be started", error.what(),
                "Give a smaller --jobs, or end other programs.");
  }
}

EndOfWork Workers::wait() {
  std::unique_lock lock(started_->mutex);
  started_->one_ended.wait(lock, [this] { return !started_->ended.empty(); });
  const EndOfWork end = started_->ended.back();
  started_->ended.pop_back();
  lock.unlock();
  started_->threads.erase(end.number); // waits for its last steps
  return end;
}

} // namespace bem_contact
