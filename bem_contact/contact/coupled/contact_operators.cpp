#include "bem_contact/contact/coupled/contact_operators.hpp"

#include "bem_contact/contact/coupled/settings.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <span>
#include <utility>

namespace bem_contact::contact {

namespace {

/// Four interleaved chains of multiplications, so that reading the values is what takes the time.
std::uint64_t digest_of(std::span<const double> values) {
  constexpr std::uint64_t odd = 0x9E3779B97F4A7C15U; // 2^64 over the golden ratio
  std::array<std::uint64_t, 4> chain{1, 2, 3, 4};
  const auto take = [&](std::size_t i, std::uint64_t& c) {
    c = (std::rotl(c, 29) ^ std::bit_cast<std::uint64_t>(values[i])) * odd;
  };
  std::size_t i = 0;
  for (; i + chain.size() <= values.size(); i += chain.size())
    for (std::size_t c = 0; c < chain.size(); ++c)
      take(i + c, chain[c]);
  for (std::size_t c = 0; i < values.size(); ++i, ++c)
    take(i, chain[c]);
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

bool numbers_couple(const InfluenceNumbers& a) {
  double self = 0;
  for (int row = 0; row < a.rows; ++row)
    self = std::max(self, a.at(0, row, component_n, row, component_n));
  const auto rows = a.stored_rows();
  for (int m = 0; m < a.offsets; ++m)
    for (const auto& [row_i, row_j] : rows)
      for (const int c : {component_x, component_s})
        if (std::max(std::abs(a.at(m, row_i, c, row_j, component_n)),
                     std::abs(a.at(m, row_i, component_n, row_j, c))) > coupling_rounding * self)
          return true;
  return false;
}

bool shear_moves_normal(const InfluenceNumbers& a, double share) {
  const auto rows = a.stored_rows();
  for (int m = 0; m < a.offsets; ++m)
    for (const auto& [i, j] : rows)
      if (std::hypot(a.at(m, i, component_n, j, component_x), a.at(m, i, component_n, j, component_s)) >
          share * a.at(m, i, component_n, j, component_n))
        return true;
  return false;
}

Coupling::Coupling(const ContactProblem& problem, TransformPool* pool)
    : normal_from_shear(problem.numbers, problem.grid.mx, {component_n}, {component_x, component_s}, pool),
      shear_from_normal(problem.numbers, problem.grid.mx, {component_x, component_s}, {component_n}, pool) {}

ContactOperators::ContactOperators(std::shared_ptr<TransformPool> pool, const NumbersKey& key)
    : pool_(std::move(pool)), key_(key), normal(pool_), tangential(pool_) {}

ContactOperators::~ContactOperators() = default;

void ContactOperators::forget_solutions() {
  normal.forget_solutions();
  tangential.forget_solutions();
  if (start_)
    start_->operators.forget_solutions();
  if (companion_)
    companion_->operators.forget_solutions();
}

const Coupling* ContactOperators::coupling(const ContactProblem& problem, WorkBudget& work) {
  if (!couples_)
    couples_ = numbers_couple(problem.numbers);
  if (*couples_ && !coupling_) {
    work.spend(spectra_work(problem.numbers.translational, 4, problem.grid.ms, problem.grid.mx));
    coupling_.emplace(problem, pool_.get());
  }
  return coupling_ ? &*coupling_ : nullptr;
}

StartingOperators& ContactOperators::start(const InfluenceNumbers& fine, const ContactGrid& coarse,
                                           int middle, bool only_normal) {
  if (!start_ || start_->middle != middle || start_->only_normal != only_normal)
    start_.reset(new StartingOperators{
        middle, only_normal, starting_numbers(fine, coarse, middle, only_normal), ContactOperators(pool_)});
  return *start_;
}

CompanionOperators& ContactOperators::companion(const InfluenceNumbers& fine, const LargerElements& larger,
                                                bool only_normal) {
  if (!companion_ || !companion_->larger.joins_like(larger) || companion_->only_normal != only_normal)
    companion_.reset(new CompanionOperators{
        larger, only_normal, larger.numbers(fine, only_normal, pool_->threads()), ContactOperators(pool_)});
  return *companion_;
}

} // namespace bem_contact::contact
