#pragma once

#include "bem_contact/scene/contact_setup.hpp"

#include <cstddef>
#include <vector>

namespace bem_contact {

/// From which influence files the numbers of the rows of a rail of sections come.
///
/// Between two sections with a file the influence functions change linearly along the track. A blend of two
/// symmetric and positive kernels is one, so that all that solvers ask of numbers holds. On the strip of a
/// file the rows lie where the point of the surface that corresponds to their middle does, as far apart as
/// they are: near a load a body is a half-space, and what it feels there depends on true distances. Away from
/// the middle they are `off` the points that correspond, where the section is wider or narrower. Several
/// bodies feel nothing of each other's loads.
struct SectionBlend {
  /// What one file gives.
  struct Part {
    std::size_t file = 0; ///< Body::sections
    double weight = 1;    ///< of its numbers
    double shift = 0;     ///< arc length on its strip less that of the row, mm
    double off = 0;       ///< how far rows lie off the points that correspond, the largest, mm

    bool operator==(const Part&) const = default;
  };
  /// Rows that follow each other.
  struct Stretch {
    int first = 0, rows = 0;
    double distance = 0;     ///< of the two sections along the track, mm; 0: there is one part
    std::vector<Part> parts; ///< one or two; none: no rail is there, and nothing is ever loaded

    bool operator==(const Stretch&) const = default;
  };
  std::vector<Stretch> stretches; ///< of all rows

  bool operator==(const SectionBlend&) const = default;
};

/// The blend where the contact is. Throws OffStripError where it is not between two sections with a file.
SectionBlend section_blend(const ContactSetup& setup, const std::vector<ContactRow>& rows);

/// "the section at 300 mm along the track"
std::string section_in_words(const SectionInfluence& section);

} // namespace bem_contact
