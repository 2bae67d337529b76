#include "bem_contact/contact/workspace.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/contact/operator/plane_transforms.hpp"
#include "bem_contact/contact/prepared.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

namespace bem_contact {

void WorkBudget::spend(double elements) {
  used_ += elements;
  if (used_ > most_)
    throw ConvergenceError(
        "The work allowed for one case is used up",
        fmt::format("{:.2g} products with influence numbers times elements, and there is no "
                    "solution yet",
                    most_),
        "Give larger elements (grid.dx, grid.ds), a less strict grid.accuracy, or fewer rows "
        "(grid.s_from, grid.s_to).");
}

namespace contact {
namespace {

/// Of all bits: four interleaved chains of multiplications, so that reading the values is what takes the
/// time.
std::uint64_t digest_of(const std::vector<double>& values) {
  constexpr std::uint64_t odd = 0x9E3779B97F4A7C15U; // 2^64 over the golden ratio
  std::array<std::uint64_t, 4> chain{1, 2, 3, 4};
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::uint64_t& c = chain[i % 4];
    c = (std::rotl(c, 29) ^ std::bit_cast<std::uint64_t>(values[i])) * odd;
  }
  std::uint64_t digest = values.size();
  for (const std::uint64_t c : chain)
    digest = (std::rotl(digest, 29) ^ c) * odd;
  return digest;
}

} // namespace

NumbersKey key_of(const ContactProblem& problem) {
  const InfluenceNumbers& a = problem.numbers;
  return {problem.grid.mx,    problem.grid.ms, a.offsets, a.rows, a.translational, a.dx, a.ds,
          digest_of(a.values)};
}

Prepared::Prepared(std::shared_ptr<TransformPool> transforms)
    : pool(transforms ? std::move(transforms) : std::make_shared<TransformPool>()) {}
Prepared::~Prepared() = default;

void DeletePrepared::operator()(Prepared* prepared) const {
  delete prepared;
}

} // namespace contact

Workspace::Workspace(int most) : most_(most), pool_(std::make_shared<contact::TransformPool>()) {}

contact::Prepared& Workspace::of(const ContactProblem& problem) {
  const contact::NumbersKey key = contact::key_of(problem);
  const auto found = std::ranges::find_if(sets_, [&](const auto& set) { return set->key == key; });
  if (found != sets_.end()) {
    ++kept_;
    sets_.splice(sets_.begin(), sets_, found);
    return *sets_.front();
  }
  ++prepared_;
  sets_.emplace_front(new contact::Prepared(pool_));
  sets_.front()->key = key;
  if (sets_.size() > static_cast<std::size_t>(std::max(most_, 1)))
    sets_.pop_back();
  return *sets_.front();
}

} // namespace bem_contact
