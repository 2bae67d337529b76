#include "bem_contact/sequence/result_file.hpp"

#include "bem_contact/record/file_kinds.hpp"
#include "bem_contact/sequence/result_record.hpp"

#include <fmt/format.h>

namespace bem_contact {

namespace {

/// Checksums of the profiles as curves, by which `repeat` knows whether a program makes others of the same
/// file.
record::Record geometry_of(const SceneResult& r) {
  record::Record out;
  const auto add = [&](const char* key, std::uint64_t digest) {
    if (digest != 0)
      out.add(key, fmt::format("{:016x}", digest));
  };
  add("rail", r.bodies.rail_geometry);
  add("wheel", r.bodies.wheel_geometry);
  return out;
}

} // namespace

record::Record result_file(const SceneResult& result, const GivenScene& given,
                           const std::filesystem::path& output) {
  return headed(result_format, given, output).add("geometry", geometry_of(result)).append(record_of(result));
}

record::Record result_file(const SceneResult& result) {
  constexpr const char* poisson = "Poisson's ratio";
  return record::Record{{"format", record::Text{result_format}}}
      .add("materials",
           record::Record{{"rail_poisson", record::Number{result.bodies.rail_poisson, "1", poisson}},
                          {"wheel_poisson", record::Number{result.bodies.wheel_poisson, "1", poisson}}})
      .add("geometry", geometry_of(result))
      .append(record_of(result));
}

record::Record comparison_file(const Comparison& comparison, const GivenScene& given,
                               const std::filesystem::path& output) {
  return headed(comparison_format, given, output)
      .add("geometry", geometry_of(comparison.leading().front()))
      .append(record_of(comparison));
}

record::Record case_record(const SceneResult& result) {
  return record::Record{{"format", record::Text{case_format}}}.append(
      record_of(result, {.quantities = false}));
}

} // namespace bem_contact
