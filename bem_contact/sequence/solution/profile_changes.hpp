#pragma once

#include "bem_contact/profile/movable_points.hpp"
#include "bem_contact/sequence/derivatives.hpp"
#include "bem_contact/sequence/solution/changed_contact.hpp"
#include "bem_contact/sequence/solution/solve_on_grid.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace bem_contact {

/// The points of the profiles whose names `derivatives` has, "rail_profile" and "wheel_profile", as inputs of
/// derivatives: each is moved along its normal.
class ProfileChanges {
public:
  /// `solved` is the solution of `asked`. Throws InputError for a profile without points.
  ProfileChanges(const ContactCase& asked, const GridSolution& solved);

  /// Points near enough to the contact to change it, of all profiles.
  std::size_t size() const { return moves_.size(); }
  ChangedContact changed(std::size_t which) const;
  /// Each profile with all its points; `found`: of the points above. What is too far away changes nothing.
  std::vector<ProfileDerivatives> sorted(std::vector<InputDerivatives> found) const;

private:
  struct Body {
    std::string name;
    bool rail;
    MovablePoints points;
  };
  struct Move {
    std::size_t body, point;
  };
  const ContactCase& asked_;
  const ContactOnGrid& contact_;
  std::vector<Body> bodies_;
  std::vector<Move> moves_;
};

} // namespace bem_contact
