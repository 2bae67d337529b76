#pragma once

#include "bem_contact/profile/profile_kind.hpp"
#include "bem_contact/profile/profile_reading.hpp"
#include "bem_contact/profile/sections/sectioned_surface.hpp"

#include <filesystem>
#include <optional>
#include <vector>

namespace bem_contact {

/// One section that a slices file names.
struct Slice {
  double at = 0;                     ///< place along the track, mm; of a wheel: angle, rad
  std::filesystem::path profile;     ///< its file, beside the slices file, or a standard's name
  std::vector<double> features = {}; ///< lengths along the chords of its points from the first, mm; nan: none
  int line = 0;                      ///< of the slices file
};

/// Of which body a slices file is by its name (.slcs, or .slcw of a wheel, in any case); nothing: it is none.
std::optional<ProfileKind> kind_of_slices(const std::filesystem::path& name);
inline bool names_slices(const std::filesystem::path& name) {
  return kind_of_slices(name).has_value();
}

/// What such a file says.
struct SlicesFile {
  std::vector<Slice> slices;
  bool approximated = false; ///< SectionsAre::approximated
};

/// Reads a slices file of a rail or a wheel as the program CONTACT has it (.slcs, .slcw; Vollebregt, CONTACT
/// user guide, appendix on slices files): offset and scale of the places, number of sections, numbers of
/// features, kinks and jumps of the curvature, way of interpolation (1) or approximation (2); then places and
/// files; then features of each. Kinks need not be said: sections keep their own. Throws InputError, which
/// names the line, for a file that is not understood, and for perturbations.
SlicesFile read_slices(const std::filesystem::path& file);

/// The sections of a file with their profiles.
struct SlicedBody {
  std::vector<BodySection> sections;
  bool approximated = false; ///< SectionsAre::approximated
};
/// `reading`: of the profile files. Throws InputError for a file of the other kind of body.
SlicedBody sections_of_slices(const std::filesystem::path& file, ProfileKind kind,
                              const ProfileReading& reading);

} // namespace bem_contact
