#include "bem_contact/base/progress.hpp"

#include "bem_contact/base/message_file.hpp"
#include "bem_contact/base/system/files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace bem_contact {

std::string duration_text(double seconds) {
  if (seconds < 100)
    return fmt::format("{:.1f} s", seconds);
  const long whole = std::lround(seconds);
  return fmt::format("{}:{:02} min", whole / 60, whole % 60);
}

Progress::Progress(std::string label, std::size_t total)
    : Progress(std::move(label), total, std::cerr, system::standard_error_is_terminal()) {}

Progress::Progress(std::string label, std::size_t total, std::ostream& out, bool terminal)
    : label_(std::move(label)), total_(std::max<std::size_t>(total, 1)), out_(out), terminal_(terminal) {
  if (terminal_)
    draw(false);
}

Progress::~Progress() {
  if (!finished_ && terminal_)
    out_ << std::endl;
}

void Progress::step(std::size_t count) {
  const std::lock_guard lock(mutex_);
  if (finished_)
    return;
  done_ = std::min(total_, done_ + count);
  const bool due = terminal_ ? Clock::now() - last_draw_ > std::chrono::milliseconds(100)
                             : 10 * done_ / total_ > 10 * drawn_ / total_ && done_ < total_;
  if (due)
    draw(false);
}

void Progress::extend(std::size_t count) {
  const std::lock_guard lock(mutex_);
  total_ += count;
}

void Progress::finish() {
  const std::lock_guard lock(mutex_);
  if (finished_)
    return;
  finished_ = true;
  draw(true);
}

void Progress::draw(bool last) {
  const auto now = Clock::now();
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  std::string time;
  if (last)
    time = duration_text(elapsed);
  else if (done_ > 0)
    time =
        duration_text(elapsed * static_cast<double>(total_ - done_) / static_cast<double>(done_)) + " left";
  if (terminal_) {
    constexpr std::size_t width = 30;
    const std::size_t full = width * done_ / total_;
    // Carriage return, and erase what a longer line left behind.
    out_ << fmt::format("\r{} [{}{}] {}/{} {}\x1b[K", label_, std::string(full, '#'),
                        std::string(width - full, '.'), done_, total_, time);
    last ? out_ << std::endl : out_ << std::flush;
  } else {
    out_ << fmt::format("{}: {}/{} {}", label_, done_, total_, time) << std::endl;
  }
  tell_progress(done_, total_);
  drawn_ = done_;
  last_draw_ = now;
}

} // namespace bem_contact
