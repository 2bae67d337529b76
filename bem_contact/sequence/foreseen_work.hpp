#pragma once

#include "bem_contact/scene/scene_file.hpp"

namespace bem_contact {

class SequenceFiles;

/// About how many units of work (contact/work.hpp) a case will take, within a factor of three for most: from
/// the elements of its first plan. It decides how many cases are worth a process of their own, so it depends
/// on the scene alone, and neither on a clock nor on what was solved before. Throws InputError for a scene
/// that cannot be asked.
double foreseen_work(const SceneFile& scene, SequenceFiles& files);

} // namespace bem_contact
