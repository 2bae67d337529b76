#pragma once

#include "bem_contact/geometry/conformity.hpp"
#include "bem_contact/record/column.hpp"
#include "bem_contact/scene/scene_file.hpp"
#include "bem_contact/uses/conicity/equivalent_conicity.hpp"
#include "bem_contact/uses/conicity/rolling_radius.hpp"

#include <atomic>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace bem_contact {

/// The left side of a wheelset, where it is not the mirror image of the right one.
struct LeftProfiles {
  std::string rail, wheel; ///< standard names or files, as in a scene; "": as on the right
};

/// The wheelset of a wheel_rail scene on its track: the scene's profiles on the right and, unless `left` says
/// otherwise, on the left. Files of the left side are read as the right side's are. Throws InputError for a
/// patch and for profiles that cannot be read.
WheelsetOnTrack wheelset_of(const SceneFile& scene, const LeftProfiles& left = {});

/// A scene of the profiles and the track that `changes` give, where there is no file. Its load does not
/// count. Paths start at the working directory. Throws InputError as parse_scene_file() does.
SceneFile scene_without_file(std::span<const SceneChange> changes);

/// Amplitudes for which the conicity is wanted: step, 2 step, .. up to `largest`, mm.
struct Amplitudes {
  double largest = 10, step = 1; ///< mm
};

/// All that follows from the shapes of a wheelset and its track.
struct WheelsetConicity {
  /// One amplitude; `motion` is empty where there is none (equivalent_conicity.hpp).
  struct Value {
    double amplitude = 0;                     ///< mm
    std::optional<EquivalentConicity> motion; ///< with this amplitude
    /// How far the contact travels during it, mm: largest less smallest y of the contact of the right side;
    /// nan where there is no motion.
    double rail_travel = std::numeric_limits<double>::quiet_NaN();
    double wheel_travel = std::numeric_limits<double>::quiet_NaN(); ///< as rail_travel
  };
  KlingelLengths lengths;            ///< of the wheelset
  std::vector<WheelsetStand> stands; ///< in rising order of lateral displacement
  std::vector<Value> values;         ///< in rising order of the amplitude
  /// Play of the wheelset on the track, mm: gauge less the distance of the active faces, 10 mm below the tape
  /// circles. nan where a wheel has no such face or the bodies are not placed by gauge and flange.
  double play = std::numeric_limits<double>::quiet_NaN();
  /// The amplitude at which the conicity is rated, mm (Regulation (EU) 1302/2014, 4.2.3.4.3): 3 from a play
  /// of 7 mm on, 2 below 5 mm, (play - 1) / 2 in between; 3 where the play is not known.
  double rated_amplitude = 3;
  /// (tan gamma at rated_amplitude + 1 mm - that at rated_amplitude - 1 mm) / 2 mm, 1/mm (Polach, Proc. IAVSD
  /// 2009, and Polach and Nicklisch, Wear 366 (2016) 200). nan where one of them has no motion.
  double nonlinearity = std::numeric_limits<double>::quiet_NaN();
  /// How closely the right wheel fits its rail: upright in the middle, and with the flange root at the gauge
  /// corner.
  std::vector<Conformity> conformity;
};

/// A wheelset that nothing holds in the middle, because the cone is negative there, gives a warning.
/// Throws InputError where a wheel finds no touch point at displacement 0, for amplitudes beyond 45 mm, and
/// for more than 10000 of them; Stopped soon after another thread sets `stop`.
WheelsetConicity wheelset_conicity(const WheelsetOnTrack& wheelset, const Amplitudes& amplitudes = {},
                                   const std::atomic<bool>* stop = nullptr);

/// The same without the conformity and without a warning.
WheelsetConicity steering_of(const WheelsetOnTrack& wheelset, const Amplitudes& amplitudes = {},
                             const std::atomic<bool>* stop = nullptr);

/// Columns over the lateral displacement, in the order of the outputs.
std::span<const ColumnOf<WheelsetStand>> stand_columns();
/// Columns over the amplitude; nan where there is no motion.
std::span<const ColumnOf<WheelsetConicity::Value>> conicity_columns();
/// What the conicity says at every door: the tables "function" and "conicity", and whose they are.
record::Record record_of(const WheelsetConicity& conicity, const WheelsetOnTrack& wheelset);

} // namespace bem_contact
