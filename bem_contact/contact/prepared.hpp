#pragma once

#include "bem_contact/contact/normal/normal.hpp"
#include "bem_contact/contact/tangential/friction.hpp"
#include "bem_contact/contact/work.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

namespace bem_contact::contact {

/// Which numbers and grid something was made for. Offsets beyond the grid's count as well.
struct NumbersKey {
  int mx = 0, ms = 0, offsets = 0, rows = 0;
  bool translational = false;
  double dx = 0, ds = 0;
  std::uint64_t digest = 0; ///< of the bits of all values

  bool operator==(const NumbersKey&) const = default;
};
NumbersKey key_of(const ContactProblem& problem);

/// Everything that solving makes of the influence numbers of one grid, each part when it is first needed.
struct Prepared {
  NumbersKey key; ///< set where it outlives a problem
  std::shared_ptr<TransformPool> pool;
  WorkBudget* work = nullptr; ///< of the case at hand: solve() sets it; null: unlimited
  std::optional<StripOperator> nn, tt, normal_from_shear, shear_from_normal; ///< whole grid
  std::optional<NormalBox> normal_box;
  std::optional<NormalLines> normal_lines;
  NormalFactor normal_factor;
  std::optional<StepBox> step_box;
  StepMatrix step_matrix;
  std::optional<StepNumbers> step_numbers;
  std::array<double, 3> step{}; ///< of step_numbers
  std::optional<bool> coupled;  ///< normal and tangential, by the numbers

  /// Elements twice as large, to start from (nested.cpp), made of the rows about `middle`.
  struct Nested;
  std::unique_ptr<Nested> nested;
  std::unique_ptr<Prepared> companion; ///< elements twice as large, to estimate the discretisation

  void spend(double elements) const {
    if (work)
      work->spend(elements);
  }

  explicit Prepared(std::shared_ptr<TransformPool> transforms = nullptr); ///< null: its own
  ~Prepared();
};

struct Prepared::Nested {
  explicit Nested(std::shared_ptr<TransformPool> transforms) : prepared(std::move(transforms)) {}
  int middle = -1;
  bool all = false; ///< not the normal components alone
  InfluenceNumbers numbers;
  Prepared prepared;
};

} // namespace bem_contact::contact
