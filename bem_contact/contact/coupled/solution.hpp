#pragma once

#include "bem_contact/contact/normal/normal_system.hpp"
#include "bem_contact/contact/tangential/creepage_search.hpp"
#include "bem_contact/contact/tangential/tangential_system.hpp"

#include <Eigen/Core>

#include <string>

namespace bem_contact::contact {

/// Normal and tangential solution of one problem.
struct Solution {
  NormalState normal;
  TangentialState shear;
  Eigen::VectorXd from_shear; ///< (A p_t)_n, mm; field
  Eigen::VectorXd distance;   ///< e, mm; field
  TangentialTask task;        ///< as solved: bounds, rigid slip
  FoundCreepage creepage;
  double rate = 0; ///< mean factor by which an outer iteration reduces the residual; 0: there was one
  int outer_iterations = 0;
  double pressed = 0, borne = 0; ///< vertical force of the pressure; of pressure and shear; N (load == force)
  bool unbalanced = false;       ///< the friction is such that no pressure carries the prescribed force
  bool settled = false;          ///< neither problem changes the other any more
  bool ended_early = false;      ///< RoughLook::ends said so
  std::string remark;
};

} // namespace bem_contact::contact
