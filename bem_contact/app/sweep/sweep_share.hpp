#pragma once

#include "bem_contact/app/sweep/sweep_output.hpp"
#include "bem_contact/app/sweep/sweep_workers.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace bem_contact::app {

/// One of `parts` shares of a sweep, each for one machine of a cluster; `part` counts from 1.
struct Share {
  int part = 1, parts = 1;
};

/// "2/8"; "": all. Throws InputError for any other text.
Share share_of(const std::string& text);

bool belongs(std::size_t index, std::size_t cases, const Share& share);

/// The cases of a share that are not finished, cut into chunks. The chunks do not depend on --jobs, so the
/// results do not either.
std::vector<Chunk> chunks_of(const SweepOutput& output, std::size_t cases, const Share& share);

struct SweepSummary {
  std::string text;       ///< what was solved, in how many seconds, what failed
  bool certified = false; ///< every case that was asked for
};

/// Of the cases of a share. `top`: the top of the sweep's file; `head` comes first in the text.
SweepSummary summary_of(const H5Table& top, const Share& share, const std::string& head);

} // namespace bem_contact::app
