#pragma once

#include "bem_contact/inside/stresses_inside.hpp"
#include "bem_contact/record/column.hpp"
#include "bem_contact/uses/shakedown/initial_stress.hpp"
#include "bem_contact/uses/shakedown/residual.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

/// Does the steel below a contact yield never, once or for ever, and is it far from fatigue?
namespace bem_contact {
struct SceneResult;
} // namespace bem_contact

namespace bem_contact::shakedown {

/// What the steel bears, and what residual stresses it may build up.
struct ShakedownProperties {
  double yield_shear = 300;          ///< k, MPa
  Residual residual = Residual::all; ///< which may build up
  double dang_van_a = 0.4;           ///< weight of the hydrostatic stress, 1; often 0.3 to 0.4 of rail steels
  std::optional<double> alpha = {};  ///< Crossland's, 1; nothing: crossland_alpha(dang_van_a)
  std::optional<double> fatigue_limit = {}; ///< in torsion, MPa: what Dang Van's stress is compared with
  std::string steel = {};                   ///< whose values these are; "": one's own
  /// Residual and thermal stress that is there before any wheel. First yield and fatigue feel it. The
  /// shakedown limit does not: residual stresses of passages make up for it (Melan).
  std::optional<InitialStress> initial = {};

  double crossland() const; ///< its alpha
  bool operator==(const ShakedownProperties&) const = default;
};

/// Those of a named steel (scene/steels.hpp): fatigue limit, Dang Van's a and, if its standard has a yield
/// strength, k. Throws InputError for an unknown name.
ShakedownProperties properties_of(const std::string& steel);

/// Throws InputError for values out of range.
void validate(const ShakedownProperties& properties);

/// What a passage does, and all that come after it.
enum class Yielding {
  never,    ///< all stays elastic
  once,     ///< residual stresses of the first passages keep all later ones elastic
  for_ever, ///< no residual stress does: it yields at each passage
  open,     ///< the load lies between both bounds
};
const char* word_of(Yielding yielding); ///< "never", "once", "for ever", "once or for ever"

/// A value with the point below which it is found.
struct AtPoint {
  double value = 0;        ///< in the unit of what is found there
  double s = 0, depth = 0; ///< mm: on the rail's arc length, and along n
};

/// What is known at each point of a section, by number of the point.
struct SectionMaps {
  std::vector<double> first_yield;         ///< load factor up to which it stays elastic
  std::vector<double> cycle;               ///< load factor up to which some residual stress keeps it elastic
  std::vector<double> dang_van, crossland; ///< MPa
  std::vector<halfspace::Stress> residual; ///< that bears the lower bound; mean normal stress unknown: 0
};

/// One patch. A load factor multiplies all tractions: the load is below a limit where its factor is above 1.
struct PatchShakedown {
  double s = 0, y = 0; ///< centre of pressure, mm (from a file of stresses: middle of the points; y nan)
  double pmax = 0;     ///< MPa
  AtPoint first_yield; ///< load factor up to which nothing yields
  AtPoint lower;       ///< load factor up to which it shakes down (Melan), and where it is decided
  AtPoint upper;       ///< load factor above which it does not (a closed cycle of plastic strain there)
  AtPoint dang_van, crossland; ///< MPa; largest below the surface, where they rise again with the depth
  double dang_van_surface = 0; ///< MPa; largest on the surface
  Yielding yielding = Yielding::open; ///< what both bounds say
  double yield_shear = 0;             ///< k, MPa
  double fatigue_limit = 0;           ///< in torsion, MPa; nan: not given
  inside::Section section;            ///< where stresses are known below the patch
  SectionMaps maps;                   ///< at its points

  /// Dang Van's largest stress, at the surface or below, over the fatigue limit: fatigue begins above 1.
  double fatigue_share() const;
  double damage() const; ///< of one passage after Miner, at that place; a crack begins at 1
  double limit_pressure() const { return lower.value * pmax / yield_shear; } ///< pmax / k at the lower bound
};

/// What passages of one contact do to the rail (a patch: to the lower body).
struct Shakedown {
  std::vector<PatchShakedown> patches; ///< largest force first; without those too small to tell
  std::size_t too_small = 0;           ///< patches with fewer than four rows or columns
};

/// The steel is elastic and perfectly plastic with von Mises' condition, and the load passes again and again
/// along x. The bounds are those of limit analysis: the largest factor for which residual stresses that do
/// not vary along x keep the stress below k everywhere (Melan 1938), and the least for which a closed cycle
/// of plastic strain at one point dissipates less than the load works (Koiter 1960). Elastic stresses are
/// those of a half-space under the tractions. Throws InputError for wrong properties, without a certified
/// result, and in plane strain.
Shakedown shakedown_of(const SceneResult& result, const ShakedownProperties& properties = {});

/// Of the patches of a result (SceneResult::result) the numbers of those that are large enough to tell, in
/// the order in which shakedown_of() has them.
std::vector<std::size_t> patches_told(const SceneResult& result);

/// The same with the stresses of a file: of the real body where it has them. Residual stresses balance
/// themselves below a surface of the body's mean curvature, where the body is. Throws InputError for wrong
/// properties, and where the points are not those below a patch.
Shakedown shakedown_of(const inside::StressesInside& stresses, const ShakedownProperties& properties = {});

/// A sentence for people: "yields once (...)".
std::string in_words(const PatchShakedown& patch, const ShakedownProperties& properties);

/// What Dang Van's stress means for this steel.
std::string fatigue_in_words(const PatchShakedown& patch, const ShakedownProperties& properties);

/// The numbers of a patch, in the order of the outputs.
std::span<const ColumnOf<PatchShakedown>> patch_columns();

/// What every door says: `patches`, and `sections/1` ... with the maps over s and depth.
record::Record record_of(const Shakedown& found, const ShakedownProperties& properties);

} // namespace bem_contact::shakedown
