#include "bem_contact/app/sweep/sweep_share.hpp"

#include "bem_contact/base/counted.hpp"
#include "bem_contact/base/error.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <map>

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
  std::vector<Chunk> chunks = chunks_of(cases);
  for (Chunk& chunk : chunks)
    std::erase_if(chunk, [&](std::size_t i) { return output.finished(i) || !belongs(i, cases, share); });
  std::erase_if(chunks, [](const Chunk& chunk) { return chunk.empty(); });
  return chunks;
}

SweepSummary summary_of(const H5Table& top, const Share& share, const std::string& head) {
  const std::vector<double>& status = top.datasets.at("status").values;
  const std::vector<double>& cpu = top.datasets.at("cpu_seconds").values;
  SweepSummary out;
  out.text = head;
  std::map<std::string_view, int> counts;
  const std::vector<double>& warnings = top.datasets.at("warning_count").values;
  std::size_t cases = 0, warned = 0;
  std::vector<double> times;
  out.certified = true;
  for (std::size_t i = 0; i < status.size(); ++i) {
    if (!belongs(i, status.size(), share))
      continue;
    const auto s = static_cast<CaseStatus>(status[i]);
    ++cases;
    ++counts[name_of(s)];
    if (!std::isnan(cpu[i]) && s != CaseStatus::died)
      times.push_back(cpu[i]);
    warned += warnings[i] > 0; // nan: no result
    out.certified = out.certified && (s == CaseStatus::certified);
  }
  for (const auto& [name, number] : counts)
    out.text += fmt::format("{} {}, ", number, name);
  out.text += fmt::format("of {}\n", counted(cases, "case", "cases"));
  if (warned > 0)
    out.text += fmt::format("{} of them have warnings (column warning_count; reason says which)\n", warned);
  if (!times.empty()) {
    std::ranges::sort(times);
    const auto at = [&](double quantile) {
      return times[static_cast<std::size_t>(quantile * double(times.size() - 1))];
    };
    out.text += fmt::format("CPU seconds a case: median {:.3g}, 99 % below {:.3g}, largest {:.3g}\n", at(0.5),
                            at(0.99), times.back());
  }
  return out;
}

} // namespace bem_contact::app
