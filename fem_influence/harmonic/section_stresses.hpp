#pragma once

#include "bem_contact/inside/stresses_inside.hpp"
#include "bem_contact/profile/bodies/body_file.hpp"
#include "bem_contact/profile/profile_curve.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <vector>

namespace bem_contact::fem {

/// Points below one patch and places along x at which stresses are asked for.
struct AskedStresses {
  std::size_t load = 0; ///< number of the tractions that make them
  std::vector<inside::BelowSurface> points;
  std::vector<double> x;
};

struct SectionTask {
  BodyFile body;
  const ProfileCurve& curve;
  std::filesystem::path mesh;
  std::span<const inside::SurfaceTractions> tractions; ///< of each load, with a row for each station
  double least_depth = 1;                              ///< of all points, mm
  std::vector<AskedStresses> areas;
};

struct SectionStresses {
  std::vector<std::vector<inside::Passage>> areas; ///< [area][point][place]; nan beside the section
  std::size_t unknowns = 0, wavenumbers = 0;
};

/// The stresses of the finite elements: of each load two solutions for each wavenumber, for tractions that
/// are even in x and those that are odd. Matrices are factorized once for all loads. Good from the least
/// depth on.
SectionStresses section_stresses(const SectionTask& task,
                                 const std::function<void(std::size_t, std::size_t)>& progress);

} // namespace bem_contact::fem
