#pragma once

#include "bem_contact/h5/handle.hpp"
#include "bem_contact/influence/influence_function.hpp"
#include "bem_contact/influence/stress_kernel.hpp"

#include <cstddef>
#include <filesystem>

/// Stresses of the inside in influence files (data/INFLUENCE_FORMAT.md, version 1.2).
namespace bem_contact {

inline constexpr int stress_format_minor = 2; ///< of a kernel with stresses of the inside

/// Empty: the file has none. Throws what read_influence_file() does, and InputError where stresses are not
/// whole.
StressKernel read_stress_kernel(const std::filesystem::path& file);

/// write_influence_file() and write_packed_influence_file() with these stresses; with an empty kernel
/// without. Packing leaves stresses as they are.
void write_influence_file(const std::filesystem::path& file, const InfluenceFunction& function,
                          const StressKernel& stresses);
void write_packed_influence_file(const std::filesystem::path& file, const InfluenceFunction& function,
                                 const StressKernel& stresses);

/// These read and write a part of an open file.
StressKernel read_stress_kernel(H5Id root, std::size_t stations);
void write_stress_kernel(H5Id root, const StressKernel& kernel, std::size_t stations);

} // namespace bem_contact
