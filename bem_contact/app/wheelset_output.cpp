#include "bem_contact/app/wheelset_output.hpp"

#include "bem_contact/app/datasets.hpp"
#include "bem_contact/app/error_text.hpp"
#include "bem_contact/app/file_kinds.hpp"
#include "bem_contact/app/report.hpp"
#include "bem_contact/app/result_file.hpp"
#include "bem_contact/base/provenance.hpp"
#include "bem_contact/wheelset/quantities.hpp"
#include "bem_contact/wheelset/settings.hpp"

#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace bem_contact::app {

namespace {

using nlohmann::json;

/// Newtons to the last, all else with five digits.
std::string number(double value) {
  const double size = std::abs(value);
  return size >= 1e4 && size < 1e7 ? fmt::format("{:.0f}", value) : fmt::format("{:.5g}", value);
}

/// "  Fz               N          109328         90672        200000": the sum only where there is one.
std::string line_of(const WheelQuantity& q, const WheelsetResult& r) {
  std::string out = fmt::format("  {:16} {:5}", q.name, q.unit);
  for (const WheelSide side : both_sides)
    out += fmt::format(" {:>13}", number(q.value(r.state, side)));
  for (const WheelsetQuantity& sum : wheelset_quantities())
    if (std::string_view(sum.name) == q.name)
      out += fmt::format(" {:>13}", number(sum.value(r)));
  return out + "\n";
}

std::string pose_text(const WheelsetResult& r) {
  const WheelsetPose& pose = r.state.pose;
  std::string out =
      fmt::format("Wheelset: lateral {:.4f} mm{}, roll {:.4e} rad (right side down), yaw {:g} rad; its "
                  "centre is {:.4f} mm "
                  "above the rails\n",
                  pose.lateral, std::isnan(r.lateral_residual) ? "" : " (found for the lateral force)",
                  pose.roll, r.state.yaw, r.state.wheel_radius - pose.vertical);
  if (pose.rolling_radius)
    out +=
        fmt::format("the axle rolls on a radius of {:.3f} mm (found for the torque)\n", *pose.rolling_radius);
  return out;
}

json numbers_of(const WheelsetState& state, WheelSide side) {
  json out = json::object();
  for (const WheelQuantity& q : wheel_quantities())
    out[q.name] = q.value(state, side);
  return out;
}

} // namespace

std::string to_text(const WheelsetResult& r) {
  std::string out = pose_text(r);
  out += fmt::format("  {:22} {:>13} {:>13} {:>13}\n", "y to the right for both", "right", "left", "sum");
  for (const WheelQuantity& q : wheel_quantities())
    out += line_of(q, r);
  const Wrench sum = r.state.sum();
  out +=
      fmt::format("on the axle: roll moment {:.5g} N mm and yaw moment {:.5g} N mm about its centre, torque "
                  "{:.5g} N mm\n",
                  r.state.roll_moment(sum), sum.moment[2], r.state.torque(sum));
  out += fmt::format(
      "equilibrium: largest residual {:.1e} of {:.0e} allowed; {} contact problems, {:.2f} s\n",
      std::fmax(r.residual, r.lateral_residual), equilibrium_tolerance, r.contact_problems, r.seconds);
  for (const WheelSide side : both_sides)
    out += fmt::format("\n{} wheel\n{}", side == WheelSide::right ? "Right" : "Left",
                       to_text(r.state.solved(side)));
  return out;
}

json to_json(const WheelsetResult& r) {
  json totals = json::object(), units = json::object();
  for (const WheelsetQuantity& q : wheelset_quantities()) {
    totals[q.name] = q.value(r);
    units[q.name] = q.unit;
  }
  for (const WheelQuantity& q : wheel_quantities())
    units[q.name] = q.unit;
  const auto wheel = [&](WheelSide side) {
    return json{{"track", numbers_of(r.state, side)}, {"result", to_json(r.state.solved(side))}};
  };
  return {{"program", provenance("bem_contact")},
          {"commit", commit()},
          {"wheelset", totals},
          {"right", wheel(WheelSide::right)},
          {"left", wheel(WheelSide::left)},
          {"units", units},
          {"certified", r.state.certified()},
          {"warnings", r.warnings},
          {"seconds", r.seconds}};
}

H5Table to_table(const WheelsetResult& r, const GivenScene& given, const std::filesystem::path& output) {
  H5Table table;
  table.attributes["format"] = std::string(wheelset_format);
  add_scene(table, given, output);
  for (const WheelsetQuantity& q : wheelset_quantities())
    table.datasets[fmt::format("wheelset/{}", q.name)] = single(q.value(r), q.unit, q.description);
  for (const WheelSide side : both_sides) {
    const std::string group = fmt::format("{}/", name_of(side));
    for (const WheelQuantity& q : wheel_quantities())
      table.datasets[fmt::format("{}track/{}", group, q.name)] =
          single(q.value(r.state, side), q.unit, q.description);
    add_whole_result(table, group, r.state.solved(side));
  }
  return table;
}

} // namespace bem_contact::app
