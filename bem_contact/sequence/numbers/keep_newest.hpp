#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <limits>

namespace bem_contact {

/// Entries used last are in front. This keeps at most `most_entries` whose sizes sum up to no more than
/// `most`; the first one stays whatever its size.
template <class Kept, class SizeOf>
void keep_newest(std::deque<Kept>& all, const SizeOf& size_of, double most,
                 std::size_t most_entries = std::numeric_limits<std::size_t>::max()) {
  double size = 0;
  std::size_t count = 0;
  for (; count < std::min(all.size(), most_entries); ++count) {
    size += size_of(all[count]);
    if (count > 0 && size > most)
      break;
  }
  all.erase(all.begin() + static_cast<std::ptrdiff_t>(count), all.end());
}

} // namespace bem_contact
