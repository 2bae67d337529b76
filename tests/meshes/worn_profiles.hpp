#pragma once

#include "bem_contact/profile/standard_profiles.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>

namespace bem_contact::meshes {

/// How a standard profile is made into a worn one, as two columns.
struct Wear {
  double middle = -38, width = 8, depth = 1; ///< depth exp(-((s - middle)/width)^2) along the normal, mm
  double noise = 0.003;                      ///< standard deviation of each coordinate, mm
  double cut_begin = 0, cut_end = 0;         ///< mm left out at the ends
  double angle = 0;                          ///< turned about the origin, rad
  double shift_z = 0;                        ///< mm
  double step = 0.4;                         ///< mm
};

inline void write_worn(const std::filesystem::path& file, const char* standard, const Wear& wear) {
  const ProfileCurve curve = standard_profile(standard);
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, wear.noise);
  std::ofstream out(file);
  const double from = curve.s_begin() + wear.cut_begin, to = curve.s_end() - wear.cut_end;
  const int count = static_cast<int>((to - from) / wear.step);
  for (int i = 0; i <= count; ++i) {
    const CurvePoint p = curve.at(from + (to - from) * i / count);
    const double depth = wear.depth * std::exp(-std::pow((p.s - wear.middle) / wear.width, 2));
    const Point2 worn = p.position + depth * normal_of(p.delta) + Point2{noise(random), noise(random)};
    const Point2 q = worn.y * tangent_of(wear.angle) + worn.z * normal_of(wear.angle);
    out << fmt::format("{:.6f} {:.6f}\n", q.y, q.z + wear.shift_z);
  }
}

} // namespace bem_contact::meshes
