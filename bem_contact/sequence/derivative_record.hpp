#pragma once

#include "bem_contact/record/record.hpp"
#include "bem_contact/sequence/scene_result.hpp"

#include <string>
#include <string_view>

namespace bem_contact {

/// NAME/Fx, NAME/patches/0/Fn ... of each number of the scene, and how far it may go until an element changes
/// its state. The result has derivatives.
record::Record derivatives_of(const SceneResult& result);

/// The unit of a derivative: "N/mm" of N by mm, "N" of N by "1".
std::string unit_per(std::string_view unit, std::string_view input);

} // namespace bem_contact
