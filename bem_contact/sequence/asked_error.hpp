#pragma once

#include "bem_contact/scene/scene_file.hpp"
#include "bem_contact/sequence/scene_result.hpp"

namespace bem_contact {

/// The largest relative error, estimated, of what the scene's grid.accuracy_of names; < 0: not estimated. The
/// error of adhesion is that of its share. If the pressure does not converge with the elements, no error is
/// stated, and the change of pmax from larger elements counts; with rough surfaces that of the forces.
double asked_error(const SceneFile::Grid& grid, const ContactResult& result);

} // namespace bem_contact
