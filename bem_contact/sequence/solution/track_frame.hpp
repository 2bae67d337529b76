#pragma once

#include "bem_contact/geometry/placement.hpp"
#include "bem_contact/sequence/scene_result.hpp"

namespace bem_contact {

/// Brings what a person reads of a contact on a rail of sections from the frame in which the rail is looked
/// at (SectionedRail) into the track frame: Fy, Fz, the approach, places and forces of patches, the reference
/// point. Fx stays the shear force along the rail; slope_force becomes what else acts along the track. Fields
/// and rows stay as they are.
void in_track_frame(const WheelOnRail& pair, SceneResult& out);

} // namespace bem_contact
