#include "bem_contact/app/sweep_share.hpp"

#include "bem_contact/base/error.hpp"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>

namespace bem_contact::app {

Share share_of(const std::string& text) {
  Share share;
  if (text.empty())
    return share;
  const char *at = text.data(), *end = at + text.size();
  const auto first = std::from_chars(at, end, share.part);
  const bool slash = first.ec == std::errc() && first.ptr != end && *first.ptr == '/';
  const auto second = slash ? std::from_chars(first.ptr + 1, end, share.parts) : first;
  if (!slash || second.ec != std::errc() || second.ptr != end || share.part < 1 || share.parts < share.part)
    throw InputError(fmt::format("--part {} cannot be", text),
                     "it is not of the form 2/8, the second of eight", "Give 1/8, 2/8, ... 8/8, each once.");
  return share;
}

bool belongs(std::size_t index, std::size_t cases, const Share& share) {
  return index / chunk_size(cases) % share.parts == static_cast<std::size_t>(share.part - 1);
}

std::vector<Chunk> chunks_of(const SweepOutput& output, std::size_t cases, const Share& share) {
  std::vector<Chunk> chunks;
  const std::size_t size = chunk_size(cases);
  for (std::size_t from = 0; from < cases; from += size) {
    if (!belongs(from, cases, share))
      continue;
    Chunk chunk;
    for (std::size_t i = from; i < std::min(cases, from + size); ++i)
      if (output.status(i) == CaseStatus::missing)
        chunk.push_back(i);
    if (!chunk.empty())
      chunks.push_back(std::move(chunk));
  }
  return chunks;
}

} // namespace bem_contact::app
