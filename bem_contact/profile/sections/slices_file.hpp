#pragma once

#include "bem_contact/profile/profile_reading.hpp"
#include "bem_contact/profile/sections/sectioned_surface.hpp"

#include <filesystem>
#include <string_view>
#include <vector>

namespace bem_contact {

/// One section that a slices file names.
struct Slice {
  double at = 0;                     ///< place along the track, mm
  std::filesystem::path profile;     ///< its file, relative to the folder of the slices file
  std::vector<double> features = {}; ///< lengths along the chords of its points from the first, mm; nan: none
  int line = 0;                      ///< of the slices file
};

/// Says whether a profile's name is that of a slices file (.slcs, or .slcw of a wheel).
bool names_slices(std::string_view name);

/// Reads a slices file of a rail as the program CONTACT has it (.slcs; Vollebregt, CONTACT user guide,
/// appendix on slices files): offset and scale of the places, number of sections, numbers of features, kinks
/// and jumps of the curvature, way of interpolation; then places and files; then features of each. Kinks need
/// not be said: sections keep their own. Throws InputError, which names the line, for a file that is not
/// understood, for an approximation in place of interpolation, for perturbations, and for wheels.
std::vector<Slice> read_slices(const std::filesystem::path& file);

/// The sections with their profiles. `reading`: of the profile files.
std::vector<BodySection> sections_of_slices(const std::filesystem::path& file, const ProfileReading& reading);

} // namespace bem_contact
