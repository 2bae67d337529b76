#pragma once

#include "bem_contact/scene/scene_file.hpp"

/// Private to this room: the keys of the two bodies, where they stand and what they bear.
namespace bem_contact {

/// [rail] or [wheel], the `name`. `role` and `standards`: for the explanation; `young`: read beside the shear
/// modulus.
void add_side(Schema& s, const std::string& name, const std::string& role, SceneFile::Side& side,
              const std::string& standards, double& young);
void add_position(Schema& s, SceneFile::Position& p); ///< [position]
void add_load(Schema& s, SceneFile::Load& load);      ///< [load]
void add_wheelset(Schema& s, SceneFile::Wheelset& w); ///< [wheelset]

} // namespace bem_contact
