#pragma once

#include "bem_contact/record/column.hpp"
#include "bem_contact/scene/sweep_file.hpp"
#include "bem_contact/uses/wear/worn_profile.hpp"

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace bem_contact {
class SectionedSurface;
}

/// How a rail wears whose section changes along the track: each section by what passes beside it.
namespace bem_contact::wear {

/// One section of such a rail (SceneFile::Section), as it wears.
struct WornSection {
  double at = 0;    ///< place along the track, mm
  std::string body; ///< of several rails beside each other, the one that it belongs to
  bool kink = false;
  /// Where the feature lines cross the section, counted in its points: 12.5 lies midway between points 12 and
  /// 13. So they stay on the same material. nan: the section does not have that line. None: they are found.
  std::vector<double> features;
  WornBody worn; ///< its profile
};

/// The sections of a scene's rail, body by body; none: the rail has one profile. Throws InputError for what
/// cannot wear place by place: a body that has one section, and a surface that does not go through its
/// sections.
std::vector<WornSection> unworn_sections(const SceneFile& scene);

/// What has become of one of them.
struct SectionRow {
  double at = 0, body = 0; ///< place along the track, mm; which of the bodies, from 1
  double depth = 0;        ///< largest, mm
  double area = 0;         ///< gone from it, mm^2
};
std::vector<SectionRow> section_rows(const std::vector<WornSection>& sections);
/// The columns of stretch.csv, of `stretch` in wear.h5 and of Python's wear().
std::span<const ColumnOf<SectionRow>> section_columns();

/// Writes the profiles of the sections into `folder`, where use_sections() finds them.
void write_sections(const std::vector<WornSection>& sections, const std::filesystem::path& folder);
/// Gives the rail of a scene these sections.
void use_sections(SceneFile::Side& rail, const std::vector<WornSection>& sections,
                  const std::filesystem::path& folder);
/// The section as a scene names it, with this file as its profile.
SceneFile::Section section_in_scene(const WornSection& section, std::string profile);

/// A place at which a wheel was solved on its way along the track. What wears there holds for the track about
/// it, and falls linearly to nothing at the places before and after: at the ends of a passage there is one.
struct PassagePlace {
  double before = 0, at = 0, after = 0; ///< mm
  double frequency = 1;                 ///< how many of all passages are of this one, 1
  double share = 0;                     ///< of all the way of all passages, 1
};

/// Which cases of a sweep are places of one passage, by numbers: all that differ in position.along, and in
/// what goes side by side with it.
std::vector<std::size_t> passages_of(const SweepFile& sweep);

/// A case of a collective on its way along the track.
struct CaseOnTrack {
  double at = 0;           ///< position.along, mm
  double weight = 1;       ///< how often its passage occurs
  std::size_t passage = 0; ///< number of the passage
};
/// Throws InputError for a passage with one place, with a place twice, or whose places have several weights.
std::vector<PassagePlace> passage_places(const std::vector<CaseOnTrack>& cases);

/// Depths of several contacts on a rail of sections.
///
/// The depth of each place, linear between places, is shared out to the sections by hats that are linear
/// between sections: a section gets the mean of what passes beside it. So the volume stays: the sum of the
/// sections' areas, each times half the distances to its neighbours, is that of the contacts, each times half
/// the distances to the places before and after. Points of the same t correspond. Where a body begins or
/// ends, the sections that have it get all.
class SectionDepths {
public:
  /// `surfaces`: through these sections, in the order of their bodies.
  SectionDepths(const std::vector<WornSection>& sections,
                std::vector<std::shared_ptr<const SectionedSurface>> surfaces);

  /// As Depths::add().
  void add(const DepthOverS& wear, const RowsOnSections& rows, const PassagePlace& place, double weight,
           double smoothing);
  const std::vector<Depths>& of_sections() const { return depths_; }

private:
  struct Share {
    std::size_t section;
    double part; ///< of the depth of the row
    int inwards; ///< 1: its surface lies behind the section, -1: before it
  };
  struct Body {
    std::size_t first = 0, last = 0; ///< of the sections, and behind the last one
    std::shared_ptr<const SectionedSurface> surface;
  };
  std::vector<Share> shares(const Body& body, const PassagePlace& place, double t) const;
  double arc_length(const Share& on, const Body& body, double t) const;

  std::vector<double> at_;
  std::vector<std::vector<Point2>> points_;
  std::vector<std::vector<double>> s_; ///< of these points, mm
  std::vector<Body> bodies_;
  std::vector<Depths> depths_;
};

} // namespace bem_contact::wear
