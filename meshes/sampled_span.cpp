#include "meshes/sampled_span.hpp"

#include "meshes/settings.hpp"

#include <algorithm>
#include <cmath>

namespace bem_contact::meshes {
namespace {

/// mm. Distance of the points in which an outline is sampled, far below any element's size.
constexpr double outline_step = 0.1;
/// 1. Of a piece, at least,
constexpr int least_outline_samples = 64;
/// 1. and at most.
constexpr int most_outline_samples = 4000;
/// mm. Curvature of the outline is the turn over this to both sides: it smooths the noise of measured points.
constexpr double curvature_reach = 0.25;

Point2 direction(const Piece& piece, double at_part, double to_part) {
  const double range = piece.to - piece.from;
  return piece.at(piece.from + range * to_part) - piece.at(piece.from + range * at_part);
}

bool break_between(const Piece& a, const Piece& b) {
  return a.group != b.group || corner_between(a, b);
}

int sample_count(const Piece& piece) {
  double length = 0;
  for (int i = 0; i < least_outline_samples; ++i)
    length += norm(direction(piece, static_cast<double>(i) / least_outline_samples,
                             static_cast<double>(i + 1) / least_outline_samples));
  return std::clamp(static_cast<int>(length / outline_step), least_outline_samples, most_outline_samples);
}

void sample(Span& span) {
  for (std::size_t p = 0; p < span.pieces.size(); ++p) {
    const Piece& piece = *span.pieces[p];
    const int count = sample_count(piece);
    for (int i = 0; i <= count; ++i) {
      const double t = i == count ? piece.to : piece.from + (piece.to - piece.from) * i / count;
      span.samples.push_back({piece.at(t), p, t, 0, 0});
    }
  }
  auto& s = span.samples;
  Point2 last{};
  for (std::size_t i = 1; i < s.size(); ++i) {
    const Point2 step = s[i].position - s[i - 1].position;
    s[i].length = s[i - 1].length + norm(step);
    s[i].turn = s[i - 1].turn;
    if (norm(step) < coinciding) // a joint of two pieces is sampled twice
      continue;
    if (norm(last) > 0)
      s[i].turn += std::abs(angle_from_to(last, step));
    last = step;
  }
}

} // namespace

bool corner_between(const Piece& a, const Piece& b) {
  return std::abs(angle_from_to(direction(a, 1 - tangent_step, 1), direction(b, 0, tangent_step))) > corner;
}

std::vector<Span> sample_spans(const Loop& loop) {
  const std::size_t n = loop.size();
  const auto breaks_before = [&](std::size_t i) { return break_between(loop[(i + n - 1) % n], loop[i]); };
  std::size_t start = 0;
  while (start < n && !breaks_before(start))
    ++start;
  std::vector<Span> spans;
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = (start + k) % n;
    if (k == 0 || breaks_before(i)) {
      spans.emplace_back();
      spans.back().group = loop[i].group;
    }
    spans.back().pieces.push_back(&loop[i]);
  }
  for (auto& span : spans) {
    span.closed = start == n;
    sample(span);
  }
  return spans;
}

double curvature_at(const Span& span, std::size_t sample) {
  const auto& s = span.samples;
  std::size_t before = sample, after = sample;
  while (before > 0 && s[sample].length - s[before].length < curvature_reach)
    --before;
  while (after + 1 < s.size() && s[after].length - s[sample].length < curvature_reach)
    ++after;
  const double length = s[after].length - s[before].length;
  return length > 0 ? (s[after].turn - s[before].turn) / length : 0;
}

Point2 point_between(const Span& span, std::size_t sample, double part) {
  const Sample &a = span.samples[sample], &b = span.samples[sample + 1];
  if (a.piece != b.piece)
    return a.position;
  return span.pieces[a.piece]->at(a.t + part * (b.t - a.t));
}

} // namespace bem_contact::meshes
