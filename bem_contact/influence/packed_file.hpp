#pragma once

#include "bem_contact/influence/influence_function.hpp"

#include <filesystem>

namespace bem_contact {

/// Returns the function with numbers that pack: rounded to whole multiples of a step that is a power of two,
/// at most packed_step times the smallest self number of its wavenumber (or of the table). The influence
/// numbers are sums over wavenumbers with positive weights, so that none moves by more than packed_step of
/// the smallest self number; that is added to the stated error. Symmetry is kept to the last bit.
InfluenceFunction rounded(InfluenceFunction function);

/// Does what write_influence_file() does with the rounded function, compressed: a fifth of the bytes. Reading
/// takes longer, since every chunk is inflated. Files that are sent around are packed.
void write_packed_influence_file(const std::filesystem::path& file, const InfluenceFunction& function);

} // namespace bem_contact
