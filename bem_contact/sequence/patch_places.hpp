#pragma once

#include "bem_contact/contact/result.hpp"
#include "bem_contact/scene/contact_setup.hpp"
#include "bem_contact/sequence/patch_place.hpp"

#include <vector>

namespace bem_contact {

/// Returns the places of result.patches, in their order. `contact` has what the last step prescribes.
std::vector<PatchPlace> patch_places(const ContactSetup& setup, const ContactOnGrid& contact,
                                     const ContactResult& result);

} // namespace bem_contact
