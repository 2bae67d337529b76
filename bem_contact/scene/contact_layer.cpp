#include "bem_contact/scene/contact_layer.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/scene/csv_table.hpp"
#include "bem_contact/scene/table_place.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace bem_contact {

namespace {

std::vector<ContactLayer::Row> read_compliances(const std::filesystem::path& file) {
  std::vector<ContactLayer::Row> table;
  for (const std::vector<double>& row : read_csv(file, {"s", "compliance"})) {
    if (row[1] < 0 || (!table.empty() && row[0] <= table.back().at))
      throw InputError(
          fmt::format("The layer table '{}' cannot be used", file.string()),
          fmt::format("its row {} has s = {:g}, compliance = {:g}", table.size() + 1, row[0], row[1]),
          "Give rows of ascending s and compliance >= 0.");
    table.push_back({row[0], row[1]});
  }
  return table;
}

} // namespace

bool ContactLayer::by_row() const {
  return std::ranges::any_of(table,
                             [this](const Row& row) { return row.compliance != table.front().compliance; });
}

SurfaceLayer ContactLayer::on(const std::vector<ContactRow>& rows) const {
  SurfaceLayer out{{}, normal};
  if (table.empty() && compliance > 0)
    out.shear = {compliance};
  for (std::size_t row = 0; row < rows.size() && !table.empty(); ++row) {
    const auto [before, after, share] = place_in(table, rows[row].s);
    out.shear.push_back(before->compliance + share * (after->compliance - before->compliance));
  }
  return out;
}

ContactLayer read_layer(const SceneFile& scene) {
  const SceneFile::Layer& asked = scene.layer;
  ContactLayer out;
  out.state = asked.state;
  out.normal = asked.normal_compliance;
  if (scene.motion.frictionless || scene.motion.friction == 0)
    return out;
  out.compliance =
      asked.shear_modulus ? asked.thickness.value_or(0) / *asked.shear_modulus : asked.compliance.value_or(0);
  if (!asked.table.empty())
    out.table = read_compliances(scene.folder / asked.table);
  out.slope = asked.slope;
  if (!asked.yield_shears.empty())
    out.yield =
        YieldLimit{asked.yield_shears.front(), asked.hardening, asked.yield_temperatures, asked.yield_shears};
  else if (asked.yield_shear)
    out.yield = YieldLimit{*asked.yield_shear, asked.hardening};
  return out;
}

} // namespace bem_contact
