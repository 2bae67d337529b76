#pragma once

#include "bem_contact/sequence/comparison.hpp"
#include "bem_contact/sequence/scene_record.hpp"

#include <filesystem>

namespace bem_contact {

/// The file of `solve -o`: how it begins (scene_record.hpp), then what the result says.
record::Record result_file(const SceneResult& result, const GivenScene& given,
                           const std::filesystem::path& output);
/// The same without its scene: what another program of this project needs of it.
record::Record result_file(const SceneResult& result);
/// Makes the file of `compare -o`.
record::Record comparison_file(const Comparison& comparison, const GivenScene& given,
                               const std::filesystem::path& output);
/// What a sweep keeps of a case with fields: all but the numbers that its table has.
record::Record case_record(const SceneResult& result);

} // namespace bem_contact
