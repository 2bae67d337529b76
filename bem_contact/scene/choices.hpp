#pragma once

#include "bem_contact/base/enum_names.hpp"
#include "bem_contact/contact/problem.hpp"
#include "bem_contact/geometry/placement.hpp"
#include "bem_contact/influence/influence_function.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// What a scene chooses between, with the names that files, commands, reports and Python use.
namespace bem_contact {

/// A wheel on a rail, or one contact problem that is given directly.
enum class SceneKind { wheel_rail, patch };
template <> struct EnumNames<SceneKind> {
  static constexpr std::array<std::string_view, 2> names{"wheel_rail", "patch"};
};

inline constexpr std::array<WheelSide, 2> both_sides{WheelSide::right,
                                                     WheelSide::left}; ///< in order of outputs
template <> struct EnumNames<WheelSide> {
  static constexpr std::array<std::string_view, 2> names{"right", "left"};
};

/// Whose track and wheelsets these are (network.hpp).
enum class Network { uic, gb, china, arema };
template <> struct EnumNames<Network> {
  static constexpr std::array<std::string_view, 4> names{"UIC", "GB", "China", "AREMA"};
};

/// Where a body stands across the track: by its gauge face or its flange back, or where its file puts it.
enum class BodyPlace { gauge, absolute };
template <> struct EnumNames<BodyPlace> {
  static constexpr std::array<std::string_view, 2> names{"gauge", "absolute"};
};

template <> struct EnumNames<MotionKind> {
  static constexpr std::array<std::string_view, 3> names{"steady", "transient", "shift"};
};

template <> struct EnumNames<StructuralCompliance> {
  static constexpr std::array<std::string_view, 2> names{"removed", "included"};
};

/// What is done about the geometry where structural motion (StructuralCompliance::included) moves the bodies:
///   placed: the bodies are placed by it, and the contact is solved again until they stand still;
///   linear: undeformed distance, normals and slip stay those of the position that the scene gives.
enum class StructuralMotion { placed, linear };
template <> struct EnumNames<StructuralMotion> {
  static constexpr std::array<std::string_view, 2> names{"placed", "linear"};
};

/// What is done about the geometry where surfaces in contact slide past each other as they approach:
///   linear: undeformed distance and normals stay those of the bodies as they touch;
///   placed: the wheel is moved aside by as much, and the contact is solved again until it stands still.
enum class ContactMotion { linear, placed };
template <> struct EnumNames<ContactMotion> {
  static constexpr std::array<std::string_view, 2> names{"linear", "placed"};
};

/// What the points of [stresses] are in.
enum class StressesIn { halfspace, bodies };
template <> struct EnumNames<StressesIn> {
  static constexpr std::array<std::string_view, 2> names{"halfspace", "bodies"};
};

/// The model of the bodies' elasticity. Sweeps keep a model as its number here, so a new one comes last.
enum class Model { hertz, halfspace, tangent_plane, fem, simplified };

/// What a scene knows of a model, and how people read it. How it is solved is in sequence/models.hpp.
struct ModelWords {
  std::string_view name;  ///< in scenes, options and files
  std::string_view title; ///< at the head of a column
  std::string_view help;  ///< what it takes the bodies for
  bool needs_files;       ///< its influence numbers come from influence files of both bodies
};

/// One row for each model, in the order of the enum.
inline constexpr auto model_words = std::to_array<ModelWords>({
    {"hertz", "Hertz",
     "no elements: the closed form for a contact without friction and with constant curvatures", false},
    {"halfspace", "half-space",
     "the elastic half-space, the profiles unrolled: distances count along the arc", false},
    {"tangent_plane", "tangent plane",
     "a half-space at the tangent plane of each element: the surface turns, but has no other shape", false},
    {"fem", "FEM", "influence files of both bodies, computed by finite elements", true},
    {"simplified", "simplified",
     "Kalker's simplified theory (FASTSIM) on Hertz's ellipse of each patch: steady rolling", false},
});

/// Returns the words for a model.
constexpr const ModelWords& words_of(Model model) {
  return model_words[static_cast<std::size_t>(model)];
}

template <> struct EnumNames<Model> {
  static constexpr auto names = [] {
    std::array<std::string_view, model_words.size()> all;
    for (std::size_t i = 0; i < all.size(); ++i)
      all[i] = model_words[i].name;
    return all;
  }();
};

/// A quantity whose error a scene may limit: the error that elements cause (grid.accuracy_of), or that a
/// model is predicted to have (solver.model_tolerance_of). `forces`: of elements forces, moment and approach
/// (Discretisation::worst()). `creepages`: those that are found for prescribed shear forces; not that of free
/// rolling, which comes along.
enum class ErrorQuantity { forces, pmax, area, adhesion, approach, creepages, friction_power };
template <> struct EnumNames<ErrorQuantity> {
  static constexpr std::array<std::string_view, 7> names{"forces",   "pmax",      "area",          "adhesion",
                                                         "approach", "creepages", "friction_power"};
};
/// Those that are predicted of models.
inline constexpr std::array<ErrorQuantity, 4> predicted_quantities{
    ErrorQuantity::forces, ErrorQuantity::pmax, ErrorQuantity::creepages, ErrorQuantity::friction_power};

/// The name of an empty choice of model: the cheapest model that is accurate enough.
inline constexpr std::string_view automatic_model = "auto";

/// "auto" for none.
std::string name_of(std::optional<Model> model);

/// The model of that name, empty for "auto". Throws InputError for a text that is neither a model nor "auto".
std::optional<Model> model_named(const std::string& name);

/// The models that are compared if none are named.
std::vector<Model> models_to_compare();

/// One line for each model: its name, and what it takes the bodies for. The last one is "auto".
std::string models_help();

} // namespace bem_contact
