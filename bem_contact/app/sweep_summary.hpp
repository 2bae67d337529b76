#pragma once

#include "bem_contact/app/sweep_share.hpp"
#include "bem_contact/influence/h5_table.hpp"

#include <string>

namespace bem_contact::app {

struct SweepSummary {
  std::string text;       ///< what was solved, in how many seconds, what failed
  bool certified = false; ///< every case that was asked for
};

/// Of the cases of a share. `top`: the top of the sweep's file; `head` comes first in the text.
SweepSummary summary_of(const H5Table& top, const Share& share, const std::string& head);

} // namespace bem_contact::app
