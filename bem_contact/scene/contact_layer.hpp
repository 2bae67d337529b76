#pragma once

#include "bem_contact/contact/friction_law.hpp"
#include "bem_contact/contact/layer.hpp"
#include "bem_contact/profile/contact_row.hpp"
#include "bem_contact/scene/scene_file.hpp"

#include <optional>
#include <string>
#include <vector>

namespace bem_contact {

/// What a scene says of the layer between the surfaces. It holds the contents of the CSV file that the scene
/// names.
struct ContactLayer {
  struct Row {
    double at = 0, compliance = 0; ///< arc length on the rail, mm; mm^3/N
  };

  std::string state;               ///< of the surfaces, as the scene names it; "": none
  double compliance = 0;           ///< of shear tractions, mm^3/N
  std::vector<Row> table;          ///< instead, by ascending s; empty: the same everywhere
  std::optional<double> slope;     ///< instead: the compliance is found (sequence/solution/layer_slope.hpp)
  double normal = 0;               ///< of pressure, mm^3/N
  std::optional<YieldLimit> yield; ///< empty: it bears what friction does

  /// Says whether rows may differ.
  bool by_row() const;
  /// As these rows have it; without what `slope` asks for.
  SurfaceLayer on(const std::vector<ContactRow>& rows) const;
};

/// Without friction only the pressure's compliance counts. Throws InputError for a table that cannot be used.
ContactLayer read_layer(const SceneFile& scene);

} // namespace bem_contact
