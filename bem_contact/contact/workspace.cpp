#include "bem_contact/contact/workspace.hpp"

#include "bem_contact/contact/coupled/contact_operators.hpp"

#include <algorithm>

namespace bem_contact {

Workspace::Workspace(int most, int threads)
    : most_(most), pool_(std::make_shared<contact::TransformPool>(threads)) {}

Workspace::~Workspace() = default;
Workspace::Workspace(Workspace&&) noexcept = default;
Workspace& Workspace::operator=(Workspace&&) noexcept = default;

int Workspace::threads() const {
  return pool_->threads();
}

contact::ContactOperators& Workspace::of(const ContactProblem& problem) {
  const contact::NumbersKey key = contact::key_of(problem);
  const auto found = std::ranges::find_if(sets_, [&](const auto& set) { return set->key() == key; });
  if (found != sets_.end()) {
    ++kept_;
    sets_.splice(sets_.begin(), sets_, found);
    return *sets_.front();
  }
  ++prepared_;
  sets_.push_front(std::make_unique<contact::ContactOperators>(pool_, key));
  if (sets_.size() > static_cast<std::size_t>(std::max(most_, 1)))
    sets_.pop_back();
  return *sets_.front();
}

} // namespace bem_contact
