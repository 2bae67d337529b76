#pragma once

#include "bem_contact/sequence/numbers/pair_numbers.hpp"
#include "bem_contact/sequence/numbers/sequence_files.hpp"
#include "bem_contact/sequence/plan/contact_estimate.hpp"

#include <memory>

namespace bem_contact {

/// A scene with all that has to be known before a grid is planned. Complete when it is made, cheap to copy.
struct ContactCase {
  SceneFile scene;
  ContactSetup setup;
  PairFiles files;
  std::shared_ptr<const ContactEstimate> estimate; ///< of a wheel on a rail
  bool own_shape = true;                           ///< influence files must be of the scene's own profiles
  bool lateral_force = false; ///< the lateral displacement is found for a force, and not given
  /// Stresses of the bodies that the scene asks for; null: of this body none.
  std::shared_ptr<const inside::FileOfStresses> rail_inside = nullptr, wheel_inside = nullptr;
};

struct PrepareOptions {
  bool foresee_shear = true; ///< the estimate knows what shear bears of the load
  /// Influence files must be of the scene's own profiles. False: the caller has seen to it that they are of
  /// nearly the same shape.
  bool own_shape = true;
  bool read_influence = true; ///< false: only for the model fem; a model that is chosen asks for them later
  bool lateral_force = false; ///< ContactCase::lateral_force
};

/// Throws InputError for a scene that cannot be asked, and for files that are not of its bodies.
ContactCase prepare_case(const SceneFile& scene, SequenceFiles& files, PrepareOptions options = {});

/// The case with the influence files that its bodies name. Throws InputError for files that are not of them.
ContactCase with_influence(ContactCase asked, SequenceFiles& files);

/// The first plan of a case on elements of the size asked for. Rows of a wheel on a rail are centred on the
/// stations of the rail's influence file where there is one. `on_strips`: every row lies on the strips of the
/// influence files; rows that the contact does not need are given up. Throws InputError where others leave
/// the strips.
GridPlan first_plan(const ContactCase& contact, const SceneFile::Grid& asked, bool on_strips);

/// First and last row of a plan that lie on the strips of both influence files; first > last where none does.
std::pair<int, int> rows_on_strips(const ContactCase& contact, const GridPlan& plan);
/// Throws InputError unless all do.
void require_strips(const ContactCase& contact, const GridPlan& plan);

} // namespace bem_contact
