#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace bem_contact {

struct SceneFile;

/// What a number changes of a contact.
enum class InputReach {
  motion, ///< rigid slip, friction and prescribed shear forces alone
  bodies, ///< where they stand, and where the reference point is: the load moves that, too
  layer   ///< the layer between them
};

/// A number of one scene with respect to which its result has derivatives.
struct SceneNumber {
  std::string name, key, unit; ///< "lateral", "position.lateral", "mm"; the unit "1" for none
  double* value;               ///< in the scene
  InputReach reach;
  double step; ///< in the unit, for differences of what the scene says of its elements; no contact is solved
};

/// The names that the key `derivatives` takes: "all", then those of numbers.
std::vector<std::string> derivative_names();

/// The one of them that means this key; "" for none.
std::string derivative_name_of(std::string_view key);

/// The numbers that the scene names, each once, in the order of derivative_names(). "all" stands for those
/// that most scenes have, as far as this one gives them. Throws InputError for one that it does not give.
std::vector<SceneNumber> derivative_inputs(SceneFile& scene);

/// Throws InputError where a scene asks for derivatives that `what` ("a table") does not show.
void refuse_derivatives(const SceneFile& scene, std::string_view what);
[[noreturn]] void refuse_derivatives(std::string_view what);

/// Names of derivatives with respect to all points of a profile.
inline constexpr std::string_view rail_profile_input = "rail_profile", wheel_profile_input = "wheel_profile";
/// Those that the scene names.
std::vector<std::string> profile_inputs(const SceneFile& scene);

} // namespace bem_contact
