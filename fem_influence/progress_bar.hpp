#pragma once

#include "bem_contact/base/progress.hpp"

#include <cstddef>
#include <optional>
#include <string>

namespace bem_contact::fem {

/// A progress bar that begins with the first report of how far the work is.
class ProgressBar {
public:
  explicit ProgressBar(std::string label) : label_(std::move(label)) {}

  void show(std::size_t done, std::size_t all) {
    if (!bar_)
      bar_.emplace(label_, all);
    bar_->step(done - shown_);
    shown_ = done;
    if (done == all)
      bar_->finish();
  }

private:
  std::string label_;
  std::optional<Progress> bar_;
  std::size_t shown_ = 0;
};

} // namespace bem_contact::fem
