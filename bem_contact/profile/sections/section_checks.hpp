#pragma once

#include "bem_contact/profile/sections/correspondence.hpp"

#include <vector>

namespace bem_contact {

/// Throws InputError for sections that make no surface (SectionedSurface).
void require_sections(const std::vector<BodySection>& sections, const SectionsAre& are);

/// Throws InputError for neighbours of which most points lie so much higher or lower that no wheel rolls from
/// one to the other: places in another unit, or sections of other things.
void require_gentle(const SectionedSurface& surface, const std::vector<BodySection>& sections,
                    const SectionsAre& are);

/// Which stretches between feature lines are there between two sections that follow each other, [interval]
/// [stretch]: those that both have. Throws InputError where nothing is there, or more than one piece.
std::vector<std::vector<char>> stretches_there(const std::vector<BodySection>& sections,
                                               const CorrespondingPoints& points, const SectionsAre& are);

} // namespace bem_contact
