#pragma once

#include "bem_contact/base/material.hpp"
#include "bem_contact/base/schema.hpp"
#include "bem_contact/geometry/unevenness.hpp"
#include "bem_contact/profile/profile_reading.hpp"
#include "bem_contact/profile/sections/slices_file.hpp"
#include "bem_contact/scene/choices.hpp"
#include "bem_contact/scene/scene_text.hpp"
#include "bem_contact/scene/warning.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bem_contact {

/// Coefficients of friction, and how they fall with the slip velocity.
struct FrictionCoefficients {
  double friction = 0.3;                  ///< Coulomb's mu
  std::optional<double> kinetic_friction; ///< of what slips; empty: the same
  /// mu that friction falls to at high slip velocity, and the slip velocity at which half of the difference
  /// is left, mm/s; or Polach's A and B (s/m). They need motion.speed.
  std::optional<double> falling_friction, half_slip_velocity, polach_a, polach_b;
  /// Distance of slip over which friction follows a slip velocity that changes, mm; empty: at once. And the
  /// velocity with which it does so where nothing slips, mm/s.
  std::optional<double> friction_memory;
  double memory_velocity = 1; ///< that velocity, mm/s

  bool operator==(const FrictionCoefficients&) const = default;
};

/// A scene file (TOML). Two kinds: "wheel_rail" (profiles, positions, forces) and "patch" (one contact
/// problem given directly). Keys and members have the same names. Paths are relative to the file's folder.
/// An optional member is empty if the file does not have its key.
struct SceneFile {
  SceneKind kind = SceneKind::wheel_rail; ///< what is described
  std::filesystem::path folder;           ///< not a key: where relative paths start
  std::vector<Warning> unused;            ///< not a key: which keys are given and have no effect, and why

  /// Numbers of the scene with respect to which its result has derivatives (derivative_inputs.hpp); none:
  /// they are not asked for.
  std::vector<std::string> derivatives;

  /// [[rail.sections]]: the section of a rail that changes along the track, at one place; [[wheel.sections]]:
  /// of a wheel that changes round its axle, at one angle
  struct Section {
    double at = 0; ///< place along the track, as position.along, mm; angle on the wheel, as flat.angle, rad
    std::string profile;          ///< standard name or file
    std::vector<double> features; ///< arc lengths of the feature lines that it has, mm (BodySection)
    std::vector<double> without;  ///< numbers of those that it does not have, from 1
    bool kink = false;            ///< the slope along the track may jump here
    /// Of several rails beside each other, the name of the one that it belongs to; "": there is one.
    std::string body = {};
    std::string influence = {}; ///< influence file of the rail as it is here; "": none

    bool operator==(const Section&) const = default;
  };

  /// [[rail.bodies]]: one of several rails beside each other on this side of the track
  struct Body {
    std::string name;                     ///< as its sections have it
    double lowered = 0;                   ///< it lies lower than its sections by this, mm
    std::optional<double> stiffness = {}; ///< vertical, of what it lies on, N/mm; empty: rigid

    bool operator==(const Body&) const = default;
  };

  /// [rail], [wheel]
  struct Side {
    std::string profile;                ///< standard name or file (wheel_rail); of sections: the first one
    ProfileReading reading;             ///< how a profile file is read: keys smoothing, unit, profile_z, ...
    BodyPlace place = BodyPlace::gauge; ///< by gauge and flange back, or where the file puts it
    double y = 0, z = 0; ///< absolute: where the section's origin stands (WheelsetPosition), mm
    std::optional<double> roller_radius = {}; ///< rail of a roller rig: WheelsetPosition::roller_radius, mm
    WheelFlat flat = {};                      ///< [wheel.flat]
    WheelPolygon polygon = {};                ///< [wheel.polygon]
    RailJoint joint = {};                     ///< [rail.joint]
    std::vector<Section> sections = {}; ///< [[rail.sections]], [[wheel.sections]]; none: it has one profile
    std::vector<Body> bodies = {};      ///< [[rail.bodies]]
    double sections_angle = 0;          ///< wheel: where angle 0 of its sections is at first, rad
    /// Whether it is given by its sections: these, or a slices file.
    bool has_sections() const { return !sections.empty() || names_slices(profile); }
    /// Whether it has an influence file, or some of its sections have.
    bool has_influence() const {
      return !influence.empty() ||
             std::ranges::any_of(sections, [](const Section& one) { return !one.influence.empty(); });
    }
    Material material; ///< [rail.material], [wheel.material]
    std::optional<double> limit_pressure =
        {};                 ///< [rail.material]: p_n is no larger, MPa; empty: that of `steel`
    std::string steel = {}; ///< [rail.material]: its name (steels.hpp); empty: not given
    std::string influence;  ///< influence file; "" where only half-space numbers are used
    StructuralCompliance structural = StructuralCompliance::removed; ///< deflection as a whole

    bool operator==(const Side&) const = default;
  };
  Side rail, wheel; ///< in a patch: the lower and the upper body

  /// [position], wheel_rail. `uneven` holds what [wheel.flat], [wheel.polygon] and [rail.joint] say.
  struct Position : WheelsetPosition {
    /// Instead of a load: z of the wheelset's centre plus wheel_radius, mm: how far the centre is lower than
    /// wheel_radius above the rail.
    std::optional<double> vertical;

    bool operator==(const Position&) const = default;
  } position; ///< [position]
  /// Whether wheel or rail are another at each place along the track.
  bool changes_along() const {
    return position.uneven.given() || rail.has_sections() || wheel.has_sections();
  }

  /// [track], wheel_rail: the curve that the wheelset runs through
  struct Track {
    std::optional<Network> network = {};     ///< where what [position] leaves out comes from (network.hpp)
    std::optional<double> curve_radius = {}; ///< mm; above 0: its centre is to the right
    double superelevation = 0;               ///< mm over `base`; above 0: the outer rail is higher
    double base = 1500;                      ///< distance of the rolling circles, mm

    double curvature() const { return curve_radius ? 1 / *curve_radius : 0; } ///< 1/mm
    bool operator==(const Track&) const = default;
  } track; ///< [track]

  /// [load]; exactly one of force and approach, or position.vertical
  struct Load {
    std::optional<double> force = {};    ///< vertical (patch: normal) force, N
    std::optional<double> approach = {}; ///< mm
    /// Shear forces on the rail, N; the creepages are found.
    std::optional<double> force_x = {}, force_s = {};
    /// wheel_rail: lateral force on the rail, N, towards the side of this wheel; position.lateral is found.
    std::optional<double> force_y = {};

    bool operator==(const Load&) const = default;
  } load; ///< [load]

  /// [wheelset], wheel_rail: both wheels of a wheelset, whose sums are given. Instead of [load]; the room
  /// wheelset answers such a scene.
  struct Wheelset {
    std::optional<double> force = {};   ///< vertical force on the axle, N
    std::optional<double> force_y = {}; ///< lateral force on the axle besides that of the curve, N, to the
                                        ///< right; position.lateral is found
    double roll_moment = 0;             ///< on the axle, about its centre, N mm, right side down
    double torque = 0;                  ///< that drives the axle, N mm; the rolling radius is found
    /// [left_rail], [left_wheel]: a body of the left side where it differs. What its table leaves out is as
    /// on the right, but for the influence file, which belongs to a profile.
    struct LeftSide {
      std::string profile;    ///< y to the field side; "": nothing differs
      ProfileReading reading; ///< how its file is read
      std::string influence;  ///< its influence file; "": none

      bool operator==(const LeftSide&) const = default;
    };
    LeftSide left_rail, left_wheel; ///< the bodies of the left side
    std::optional<double> left_rail_inclination =
        {}; ///< left_rail.inclination, rad; empty: as position.rail_inclination
    std::optional<double> left_friction = {};     ///< Coulomb's mu
    std::optional<double> left_wheel_radius = {}; ///< nominal, at the tape circle, mm

    bool operator==(const Wheelset&) const = default;
  } wheelset; ///< [wheelset]

  /// [motion]; creepages at the contact reference point
  struct Motion : FrictionCoefficients {
    MotionKind kind = MotionKind::steady; ///< rolling, or shifts
    bool frictionless = false;            ///< the normal problem alone
    /// CSV file with columns s (mm) or inclination (rad), mu instead of friction; and falling_friction,
    /// half_slip_velocity by row.
    std::string friction_table;
    int steps = 1; ///< of transient rolling (dx each) or of shifts
    /// Transient: the bodies slide in the first step as far as in so many rolling steps (a shift before
    /// rolling).
    double first_shift = 1;
    /// CSV file with one row a step and some of the columns load (N where load.force is given, mm where
    /// load.approach is), xi, eta, phi, force_x, force_s (N) and x (mm: where a shifted patch touches).
    std::string step_table;
    std::string start_table; ///< patch: CSV file with columns ix, is (from 0), px, ps, pn (MPa)
    /// phi in 1/mm; a shift: xi, eta in mm and phi in rad. wheel_rail: spin of the geometry is added to phi.
    double xi = 0, eta = 0, phi = 0;
    /// wheel_rail: forward over angular speed at xi = 0, mm. Empty: speed / pitch_rate (mm/s, rad/s); if
    /// these are empty too, the radius that rolls freely under the estimated pressure. The slip velocity is
    /// the slip times speed, of a patch too.
    std::optional<double> rolling_radius, speed, pitch_rate;
    /// wheel_rail: xi is counted from free rolling (Fx = 0), not from rolling_radius.
    bool from_free_rolling = false;
    bool free_rolling = true; ///< wheel_rail: the result has the creepage of free rolling
    /// fem, steady rolling: the wheel's surface is faster where it moves away from the axle, by u_r / R.
    bool radial_displacement = true;
    /// wheel_rail: of the wheelset, with speed: to the right and down, mm/s; right side down and front to the
    /// right, rad/s. The yaw rate is counted from that of the curve, speed / track.curve_radius.
    double lateral_velocity = 0, vertical_velocity = 0, roll_rate = 0, yaw_rate = 0;
    /// wheel_rail: rates of a wheel in a flexible wheelset, in the directions of WheelsetPosition::deviation
    /// and forwards, mm/s, and rad/s; pitch: positive as it rolls forwards.
    struct WheelRates {
      double forward = 0, lateral = 0, vertical = 0; ///< mm/s
      double roll = 0, pitch = 0, yaw = 0;           ///< rad/s

      bool operator==(const WheelRates&) const = default;
    };
    WheelRates wheel;                   ///< of this wheel beside the rigid wheelset
    std::optional<double> roller_speed; ///< wheel_rail: of a roller, rad/s; empty: its surface has the speed
    /// patch: CSV file with columns ix, is, wx, ws instead of creepages; wx, ws per unit of rolled distance
    /// (shift: mm).
    std::string slip_table;

    bool operator==(const Motion&) const = default;
  } motion; ///< [motion]

  /// Reaches from the outer border of the first row to that of the last, mm.
  struct RowRange {
    double from = 0, to = 0; ///< arc length, mm

    bool operator==(const RowRange&) const = default;
  };

  /// [grid]
  struct Grid {
    double dx = 0.5, ds = 0.2;      ///< mm
    std::optional<int> mx, ms;      ///< patch: size; wheel_rail: empty = from the undeformed distance
    std::optional<int> elements;    ///< wheel_rail: wanted in contact, instead of dx and ds
    std::optional<double> accuracy; ///< wheel_rail: discretisation error wanted, instead of dx and ds
    /// What `accuracy` is about; one at least.
    std::vector<ErrorQuantity> accuracy_of{ErrorQuantity::forces, ErrorQuantity::pmax};
    bool plane_strain = false;    ///< patch: mx = 1, infinitely long along x, forces per mm
    std::optional<RowRange> rows; ///< wheel_rail: keys s_from and s_to, on the rail's arc length
    bool planar = false;          ///< wheel_rail: a tangent plane for each patch

    bool operator==(const Grid&) const = default;
  } grid; ///< [grid]

  /// [gap], patch
  struct Gap {
    double a = 0, b = 0, c = 0; ///< h = a x^2 + b s^2 + c x s; 1/mm
    std::string table;          ///< CSV file with columns ix, is, h (mm) instead

    bool operator==(const Gap&) const = default;
  } gap; ///< [gap]

  /// [strip], patch: a curved strip
  struct Strip {
    double radius = 0; ///< constant radius of the lower surface, mm (> 0 convex, < 0 concave); 0: flat
    /// Radius of the upper surface, mm (> 0 convex, < 0 concave, 0: not given). The distance between the two
    /// circles is added to a, b, c of [gap] (not to its table); arc lengths on the upper body follow its
    /// circle.
    double upper_radius = 0;
    double rail_s0 = 0, wheel_s0 = 0; ///< arc length in the influence files at the middle of the grid, mm
    std::string inclination;          ///< CSV file with columns is, delta (rad) instead of radius

    bool operator==(const Strip&) const = default;
  } strip; ///< [strip]

  /// [layer]: a thin compliant layer between the surfaces; at most one of compliance, shear_modulus with
  /// thickness, table and slope
  struct Layer {
    std::string state; ///< of the surfaces (surface_states.hpp), where other keys say nothing; "": not given
    std::optional<double> compliance;    ///< of shear tractions, of both surfaces together, mm^3/N
    std::optional<double> shear_modulus; ///< with thickness: compliance = thickness / shear_modulus, MPa
    std::optional<double> thickness;     ///< mm
    std::string table;                   ///< CSV file with columns s (mm), compliance (mm^3/N)
    /// The slope of Fx over xi at xi = 0 with the layer, over that without it: the compliance is found.
    std::optional<double> slope;
    double normal_compliance = 0;      ///< of pressure, mm^3/N
    std::optional<double> yield_shear; ///< traction at which it yields, MPa; empty: it does not
    /// Instead, by the mean temperature of both surfaces (degrees C, rising): MPa; both empty: not given.
    std::vector<double> yield_temperatures, yield_shears;
    double hardening = 0; ///< of yield_shear with its plastic slip, MPa/mm; below 0: it softens

    /// Says whether either form of the limit is given.
    bool yields() const { return yield_shear || !yield_shears.empty(); }
    bool operator==(const Layer&) const = default;
  } layer; ///< [layer]

  /// [stresses]: below the surface of the rail (patch: the lower body), at every (x, s, depth)
  struct Stresses {
    std::vector<double> x{0.0}; ///< mm
    std::vector<double> s{0.0}; ///< arc length from the reference point (patch: the middle of the grid), mm
    std::vector<double> depths; ///< along n, mm; none: not asked for
    /// `bodies`: beside those of a half-space the real ones, by the influence files that are given.
    StressesIn in = StressesIn::halfspace;

    /// Says whether stresses in the real bodies are asked for.
    bool asks_for_bodies() const { return in == StressesIn::bodies && !depths.empty(); }
    bool operator==(const Stresses&) const = default;
  } stresses; ///< [stresses]

  /// [temperature]: of the surfaces under the heat of friction
  struct Temperature {
    bool flash = false;                  ///< asked for
    ThermalBody rail, wheel;             ///< with the temperature before the contact
    std::optional<double> rail_share;    ///< of the heat; empty: the surfaces are equally hot
    std::optional<double> hot_friction;  ///< mu from falls_to on; empty: the same
    double falls_from = 0, falls_to = 0; ///< degrees C

    bool operator==(const Temperature&) const = default;
  } temperature; ///< [temperature]

  /// [wear], wheel_rail: the wear map of Archard's law (wear/law.hpp), for the room wear alone; all empty:
  /// that of KTH Stockholm.
  struct Wear {
    std::vector<double> speeds;       ///< borders of sliding speed, rising, mm/s
    std::vector<double> pressures;    ///< borders of pressure, rising, MPa
    std::vector<double> coefficients; ///< [pressures + 1][speeds + 1], 1

    bool operator==(const Wear&) const = default;
  } wear; ///< [wear]

  /// [solver]
  struct Solver {
    std::optional<Model> model;    ///< empty: the cheapest that is accurate enough
    double model_tolerance = 0.01; ///< relative, for auto
    /// What `model_tolerance` is about; one at least.
    std::vector<ErrorQuantity> model_tolerance_of{ErrorQuantity::forces, ErrorQuantity::pmax,
                                                  ErrorQuantity::creepages, ErrorQuantity::friction_power};
    double tolerance = 1e-8; ///< relative, of the iterations
    int max_outer = 50;      ///< outer iterations
    /// What structural motion does to the geometry.
    StructuralMotion structural_motion = StructuralMotion::placed;
    /// What the motion of the surfaces in contact does to it.
    ContactMotion contact_motion = ContactMotion::linear;

    bool operator==(const Solver&) const = default;
  } solver; ///< [solver]

  bool operator==(const SceneFile&) const = default;
};

/// A key of a scene with another value than its file says (sweep_file.hpp).
struct SceneChange {
  std::string key;         ///< dotted: "position.lateral"
  SchemaValue value;       ///< a number, flag, text or list of numbers
  int line = 0;            ///< of the file, for messages; 0: none
  std::string source = {}; ///< the file of `line`; "": that of the scene
};

/// Read a scene; `changes` replace values of the file. Tables [sweep] and [table] are ignored
/// (sweep_file.hpp reads them).
/// Both throw InputError, naming source, line and key, for what is no valid scene.
SceneFile read_scene_file(const std::filesystem::path& file, std::span<const SceneChange> changes = {});
/// Reads the same from a text.
SceneFile parse_scene_file(SceneText given, std::span<const SceneChange> changes = {});
/// A scene file with every key: default, unit and meaning.
std::string default_scene_file();
/// The keys of a table of scenes, without its name ("speeds" of "wear"); empty: scenes have no such table.
std::vector<std::string> keys_of_table(std::string_view table);
/// The unit of a key of scenes, "" for none.
std::string unit_of_key(std::string_view key);
/// Every key of scenes, with the values that they have where a file says nothing.
std::vector<KeyDescription> keys_of_scenes();

/// A scene as a file with the value of every key, defaults included: reading it gives the same scene, in this
/// version and, because nothing is left to a default, in others.
std::string scene_with_defaults(const SceneFile& scene);

/// Returns the same scene, to be answered with another model. Where `model` is empty, the cheapest one that
/// is accurate enough answers it.
SceneFile with_model(SceneFile scene, std::optional<Model> model);
/// Does the same for the name of a model, or "auto", as an option gives it; "": as the scene says. Throws
/// InputError for any other text.
SceneFile with_model(SceneFile scene, const std::string& name);
/// Returns the same scene at a given lateral displacement, mm, instead of a given lateral force.
SceneFile with_lateral(SceneFile scene, double lateral);
/// One wheel of a scene with [wheelset], which it no longer has: with its side and what differs on the left.
SceneFile one_wheel(SceneFile wheelset, WheelSide side);
/// Returns the same scene on elements of a given size, mm.
SceneFile with_elements(SceneFile scene, double dx, double ds);

/// A file that a scene names, or could: a profile may be a standard's name.
struct NamedFile {
  std::string key;            ///< "rail.profile"
  std::string name;           ///< as the scene gives it
  std::filesystem::path file; ///< in the scene's folder
};
/// Says whether a key names a profile, as "rail.profile" and "left_rail.profile" do.
bool names_profile(std::string_view key);
/// Says the same of influence files.
bool names_influence(std::string_view key);
/// What a key names: nothing if `name` is empty. If it is the body file of a profile, also the profile file
/// that this one names, with the key "rail.profile.body.profile"; if it is a slices file, also those of its
/// sections, "rail.profile.sections[3].profile".
std::vector<NamedFile> files_of_key(const std::string& key, const std::string& name,
                                    const std::filesystem::path& folder);
/// "rail.profile" of both: the key of the file that names a profile; "": the scene itself does.
std::string_view named_by(std::string_view key);
/// All that a scene names, table by table.
std::vector<NamedFile> named_files(const SceneFile& scene);
/// Returns the paths of these files.
std::vector<std::filesystem::path> paths_of(const std::vector<NamedFile>& files);
/// The paths of all that a scene names.
std::vector<std::filesystem::path> input_files(const SceneFile& scene);

} // namespace bem_contact
