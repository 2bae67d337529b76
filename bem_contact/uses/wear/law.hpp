#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

/// What rolling contact wears away, of the rail and of the wheel.
namespace bem_contact::wear {

/// What one element does to the surfaces that pass through it.
struct Rubbing {
  double power = 0;    ///< |p_t . s|, N/mm^2: friction power per area and unit of rolled distance
  double pressure = 0; ///< p_n, MPa
  double sliding = 0;  ///< |s|, slip per unit of rolled distance
};

/// Wear by the energy that friction dissipates (T-gamma, "USFD"): a wheel of steel R8T on a rail of steel
/// 900A, twin-disc tests (Lewis and Dwyer-Joyce, Proc. IMechE J 218 (2004) 467; Braghin et al., Wear 261
/// (2006) 1253). I is Rubbing::power. K, in microgram per metre rolled and mm^2, is
///     mild   I                                    up to mild_until,
///     severe                                      up to severe_until,
///     severe + catastrophic (I - severe_until)    above.
struct EnergyLaw {
  double mild = 5.3;          ///< ug/(m mm^2) per N/mm^2
  double mild_until = 10.4;   ///< N/mm^2
  double severe = 55.1;       ///< ug/(m mm^2)
  double severe_until = 77.2; ///< N/mm^2
  double catastrophic = 61.9; ///< ug/(m mm^2) per N/mm^2
  double density = 7.8e-6;    ///< kg/mm^3

  bool operator==(const EnergyLaw&) const = default;
};

/// Regions of sliding speed and pressure, each with a wear coefficient of its own.
struct WearMap {
  std::vector<double> speeds;       ///< mm/s: borders between the columns, rising
  std::vector<double> pressures;    ///< MPa: borders between the rows, rising
  std::vector<double> coefficients; ///< [pressures + 1][speeds + 1], 1: k; a border belongs to the lower side

  bool operator==(const WearMap&) const = default;
};

/// Wear by Archard (J. Appl. Phys. 24 (1953) 981): depth = k p d / H, d the sliding distance.
struct ArchardLaw {
  double hardness = 3000;     ///< H of the softer body, MPa
  double rolling_speed = 3e4; ///< mm/s; sliding speed = rolling speed times Rubbing::sliding
  WearMap map;

  bool operator==(const ArchardLaw&) const = default;
};

using Law = std::variant<EnergyLaw, ArchardLaw>;

/// How users call the laws: as law_named() takes them.
inline constexpr std::array<std::string_view, 2> law_names{"energy", "archard"};
/// A law with its usual coefficients. Archard: `hardness` (MPa), `rolling_speed` (mm/s), and this map or
/// kth_map(). Throws InputError for another name, and for a map with a law that has none.
Law law_named(std::string_view name, double hardness, double rolling_speed,
              const std::optional<WearMap>& map = {});

/// The map of KTH Stockholm (Jendel, Wear 253 (2002) 89): k = 1..10e-4 below 0.2 m/s, 30..40e-4 up to 0.7
/// m/s, 1..10e-4 above, and 300..400e-4 where the pressure exceeds 0.8 H. Here the middle of each range.
WearMap kth_map(double hardness);

/// Of the region in which the values lie, 1.
double coefficient(const WearMap& map, double sliding_speed, double pressure);

/// Mass that leaves the surfaces, ug per metre rolled and mm^2, under the power `power` (N/mm^2).
double mass_rate(const EnergyLaw& law, double power);

/// Depth that an element takes off a surface per mm that the surface travels through it; mm/mm.
double depth_rate(const Law& law, const Rubbing& rubbing);

/// Throws InputError for what is not finite, negative, or not rising; for a map of the wrong size.
void validate(const Law& law);

} // namespace bem_contact::wear
