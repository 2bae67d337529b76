#pragma once

#include "bem_contact/scene/scene_file.hpp"

/// Private to this room: every key of a scene, with its unit, range and a line of explanation, and what they
/// demand of each other.
namespace bem_contact {

// The kinds of scenes that a key is for.
inline const std::vector<std::string> wheel_rail_alone{std::string(name_of(SceneKind::wheel_rail))};
inline const std::vector<std::string> patch_alone{std::string(name_of(SceneKind::patch))};

/// mm. Farthest place along the track: 100 km, where places are rounded to 1e-8 mm.
constexpr double farthest_along = 1e8;

/// Values of keys that have no member of their own in SceneFile; settle() turns them into one.
struct SceneKeysAsRead {
  double rail_young = 0, wheel_young = 0; ///< MPa; else the shear modulus
  double s_from = 0, s_to = 0;            ///< mm; both 0: no rows are asked for
};

/// Reads into `file` and `read`, which must outlive it.
Schema scene_schema(SceneFile& file, SceneKeysAsRead& read);

/// Sets shear moduli and rows after reading. Throws InputError if a material has two moduli.
void settle(SceneFile& file, const Schema& schema, const SceneKeysAsRead& read);

/// Throws InputError, naming line and key, for keys that exclude each other and for one that is missing.
void check_keys(const SceneFile& file, const Schema& schema);

/// Keys that the file sets to another value than their default, and that have no effect in this combination:
/// one sentence for each reason.
std::vector<Warning> unused_keys(const SceneFile& scene, const Schema& schema);

/// A key whose value changes nothing, because another key is given.
struct OverruledKey {
  std::string key, why, what_to_do;
};
/// All of a scene, whether the file gives them or not.
std::vector<OverruledKey> overruled_keys(const SceneFile& scene, const Schema& schema);

/// [rail] or [wheel], the `name`. `role` and `standards`: for the explanation; `young`: read beside the shear
/// modulus.
void add_side(Schema& s, const std::string& name, const std::string& role, SceneFile::Side& side,
              const std::string& standards, double& young);
void add_wheel_unevenness(Schema& s, SceneFile::Side& wheel); ///< [wheel.flat], [wheel.polygon]
void add_rail_joint(Schema& s, RailJoint& joint);             ///< [rail.joint]
void add_bodies(Schema& s, SceneFile::Side& rail);            ///< [[rail.bodies]]
/// [[rail.sections]], [[wheel.sections]]
void add_sections(Schema& s, SceneFile::Side& side, const std::string& name);
/// Throws InputError for a layer ([layer]) that contradicts itself or other keys.
void check_layer(const SceneFile& file, const Schema& schema);
/// Throws InputError for unevenness that contradicts itself or other keys.
void check_unevenness(const SceneFile& file, const Schema& schema);
void add_position(Schema& s, SceneFile::Position& p);   ///< [position]
void add_track(Schema& s, SceneFile::Track& track);     ///< [track]
void add_load(Schema& s, SceneFile::Load& load);        ///< [load]
void add_wheelset(Schema& s, SceneFile::Wheelset& w);   ///< [wheelset]
void add_left_sides(Schema& s, SceneFile::Wheelset& w); ///< [left_rail], [left_wheel]

void add_motion(Schema& s, SceneFile::Motion& m);           ///< [motion]
void add_temperature(Schema& s, SceneFile::Temperature& t); ///< [temperature]

} // namespace bem_contact
