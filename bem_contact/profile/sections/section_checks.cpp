#include "bem_contact/profile/sections/section_checks.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/median.hpp"
#include "bem_contact/profile/sections/correspondence.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace bem_contact {

namespace {

/// 1. A section is taken as the mirror image of its neighbour where that fits so many times better.
constexpr double mirrored_fits = 5;
/// mm. Sections that differ by less from their neighbours are not looked at: rails are nearly symmetric.
/// Inclined by 1:40, or worn by 1 mm at the gauge corner, they are told from their mirror image.
constexpr double looked_at = 0.1;

/// 1. Where half of a surface is steeper along the track, nothing rolls on it: noses rise 1:10. Chosen.
constexpr double steepest_surface = 0.5;
/// mm. Distance of the points that are looked at.
constexpr double slope_step = 1.0;

/// Sections with the words for them.
struct NamedSections {
  const std::vector<BodySection>& sections;
  const SectionsAre& are;

  std::size_t size() const { return sections.size(); }
  const BodySection& operator[](std::size_t i) const { return sections[i]; }
  std::string place(std::size_t i) const { return fmt::format("{:g} {}", sections[i].at, are.unit); }
};

std::string named(const NamedSections& sections, std::size_t i) {
  return fmt::format("Section {} ('{}' at {})", i + 1, sections[i].profile.name(), sections.place(i));
}

void require_places(const NamedSections& sections) {
  for (std::size_t i = 1; i < sections.size(); ++i) {
    if (sections[i].at == sections[i - 1].at)
      throw InputError(fmt::format("{} is doubled", named(sections, i)),
                       fmt::format("section {} is at the same place", i), "Leave one of them out.");
    if (!(sections[i].at > sections[i - 1].at))
      throw InputError(fmt::format("{} is out of order", named(sections, i)),
                       fmt::format("section {} before it is at {}", i, sections.place(i - 1)),
                       "Give the sections by rising place.");
  }
}

void require_features(const NamedSections& sections) {
  const std::size_t count = sections[0].features.size();
  if (count == 1)
    throw InputError(fmt::format("{} has one feature", named(sections, 0)),
                     "a surface lies between two, and what is beyond the first and the last is left out",
                     "Give the ends of the sections too.");
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const auto& [at, profile, features, kink] = sections[i];
    if (features.size() != count)
      throw InputError(fmt::format("{} has {} features", named(sections, i), features.size()),
                       fmt::format("section 1 has {}, and each is a line through all sections", count),
                       "Give each section as many, nan where it does not have one.");
    double before = profile.s_begin();
    for (std::size_t k = 0; k < count; ++k) {
      if (std::isnan(features[k]))
        continue;
      if (!(features[k] >= profile.s_begin() && features[k] <= profile.s_end()))
        throw InputError(fmt::format("Feature {} of {} is off its profile", k + 1, named(sections, i)),
                         fmt::format("it is at s = {:g} mm, and the profile goes from {:.6g} to {:.6g} mm",
                                     features[k], profile.s_begin(), profile.s_end()),
                         "Give arc lengths of the profile; bem_contact profile shows them.");
      if (features[k] < before)
        throw InputError(fmt::format("Features cross each other in {}", named(sections, i)),
                         fmt::format("feature {} is at s = {:g} mm, and one before it at {:g} mm", k + 1,
                                     features[k], before),
                         "Give the features of all sections in the same order, along the profile.");
      before = features[k];
    }
  }
}

void require_one_side(const NamedSections& sections) {
  for (std::size_t i = 1; i < sections.size(); ++i) {
    const ProfileCurve &before = sections[i - 1].profile, &here = sections[i].profile;
    const double apart = distance_of_profiles(before, here);
    if (apart > looked_at && mirrored_fits * distance_of_profiles(before, mirrored(here)) < apart)
      throw InputError(fmt::format("{} is the mirror image of its neighbour", named(sections, i)),
                       "left and right exchanged it fits, and as it is it does not",
                       "Give all sections from the same side of the track.");
  }
}

} // namespace

void require_sections(const std::vector<BodySection>& sections, const SectionsAre& are) {
  if (sections.size() < 2)
    throw InputError(fmt::format("A {} has one section", are.body), "a surface between sections needs two",
                     fmt::format("Give two sections or more, or {}.profile alone.", are.body));
  const NamedSections all{sections, are};
  require_places(all);
  require_features(all);
  require_one_side(all);
}

void require_gentle(const SectionedSurface& surface, const std::vector<BodySection>& sections,
                    const SectionsAre& are) {
  const NamedSections all{sections, are};
  std::vector<std::size_t> nearest_first(sections.size() - 1); // a wheel's sections are there again and again
  std::iota(nearest_first.begin(), nearest_first.end(), 0);
  std::ranges::sort(nearest_first, {}, [&](std::size_t i) { return std::abs(sections[i].at); });
  for (const std::size_t i : nearest_first) {
    const double from = sections[i].at, to = sections[i + 1].at, length = (to - from) * are.unit_length;
    if (!(length > 0))
      continue; // a kink
    const auto [first, last] = surface.extent(0.5 * (from + to));
    const double end = std::nextafter(to, from); // behind it other lines may be there
    std::vector<double> slopes;
    for (double t = first; t <= last; t += slope_step) {
      const SectionedSurface::Point a = surface.at(from, t), b = surface.at(end, t);
      const Point2 off = b.position - a.position, along = a.by_t + b.by_t;
      slopes.push_back(std::abs(off.z * along.y - off.y * along.z) / (norm(along) * length));
    }
    if (const double slope = median(std::move(slopes)); slope > steepest_surface)
      throw InputError(fmt::format("Section '{}' at {} lies far off the one before it, '{}' at {}",
                                   sections[i + 1].profile.name(), all.place(i + 1),
                                   sections[i].profile.name(), all.place(i)),
                       fmt::format("half of the surface between them is steeper than {:.2g} along the track, "
                                   "and up to {:g} a wheel may roll on it",
                                   slope, steepest_surface),
                       "Check places, units and files of both.");
  }
}

std::vector<std::vector<char>> stretches_there(const std::vector<BodySection>& sections,
                                               const CorrespondingPoints& points, const SectionsAre& are) {
  const NamedSections all{sections, are};
  std::vector<std::vector<char>> out;
  for (std::size_t i = 0; i + 1 < sections.size(); ++i) {
    const std::vector<char>& joined = points.joined[i];
    std::vector<char> there;
    int pieces = 0;
    for (std::size_t k = 0; k + 1 < joined.size(); ++k) {
      there.push_back(joined[k] && joined[k + 1] ? 1 : 0);
      pieces += there.back() && (k == 0 || !there[k - 1]) ? 1 : 0;
    }
    if (pieces != 1)
      throw InputError(
          fmt::format("There is {} {} between {} and {}", pieces == 0 ? "no" : "a hole in the", are.body,
                      all.place(i), all.place(i + 1)),
          fmt::format("sections {} ('{}') and {} ('{}') have {} features next to each other in common", i + 1,
                      sections[i].profile.name(), i + 2, sections[i + 1].profile.name(),
                      pieces == 0 ? "no two" : "not all of the"),
          "Features that only one of the two has must lie at one end of the profiles.");
    out.push_back(std::move(there));
  }
  for (std::size_t k = 0; k + 1 < points.marks.front().size(); ++k)
    if (std::ranges::none_of(points.marks, [&](const std::vector<double>& of) { return of[k + 1] > of[k]; }))
      throw InputError(fmt::format("There is nothing between features {} and {}", k + 1, k + 2),
                       "no section has both, at different places", "Leave one of them out.");
  return out;
}

} // namespace bem_contact
