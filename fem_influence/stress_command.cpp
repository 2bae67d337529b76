#include "fem_influence/commands.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/base/provenance.hpp"
#include "bem_contact/profile/bodies/body_file.hpp"
#include "bem_contact/profile/standard_profiles.hpp"
#include "bem_contact/record/file_kinds.hpp"
#include "bem_contact/record/hdf5.hpp"
#include "fem_influence/harmonic/body_stresses.hpp"
#include "fem_influence/progress_bar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ostream>

namespace bem_contact::fem {

namespace {

EllipticalLoad load_of(const std::vector<double>& ellipse) {
  const EllipticalLoad load{ellipse.at(0), ellipse.at(1), ellipse.at(2), ellipse.at(3), ellipse.at(4)};
  const bool positive = load.a > 0 && load.b > 0 && load.pressure > 0 && load.friction >= 0;
  if (!positive || !std::isfinite(load.s + load.a + load.b + load.pressure + load.friction))
    throw InputError("This ellipse is no load",
                     "it needs semi-axes and a pressure above 0, and friction of 0 or more",
                     "Give --ellipse S A B P0 MU.");
  return load;
}

using inside::LoadedInside;

void require_areas(const LoadedInside& load) {
  if (load.stresses.areas.empty())
    throw InputError("There is no patch with stresses worth looking at",
                     "none has four rows and columns of elements", "Solve the scene with smaller elements.");
}

std::vector<LoadedInside> loads_on(const BodyFile& body, const ProfileCurve& curve,
                                   const StressOptions& options) {
  const std::vector<inside::BelowSurface> own = options.points.empty()
                                                    ? std::vector<inside::BelowSurface>{}
                                                    : inside::read_points_below(options.points);
  std::vector<LoadedInside> out;
  if (options.results.empty()) {
    const inside::SurfaceTractions tractions = tractions_of(load_of(options.ellipse), body.material.poisson);
    out.push_back({tractions, inside::halfspace_inside(tractions, inside::Side::rail, own)});
  }
  for (const std::string& file : options.results)
    out.push_back(inside::loaded_by(record::read_hdf5(file), curve.digest(), body.material.poisson, own));
  std::ranges::for_each(out, require_areas);
  return out;
}

bool is_text(const std::string& output) {
  return output.ends_with(".csv") || output.ends_with(".vtu");
}

/// An HDF5 file of ours may be made again; what somebody else made is kept.
void require_own_file(const std::filesystem::path& file) {
  std::error_code unknown;
  if (is_regular(file) && std::filesystem::file_size(file, unknown) > 0 && !kind_of(record::format_of(file)))
    throw InputError(fmt::format("The file '{}' exists and would be replaced", file.string()),
                     "bem_contact did not make it", "Give another output, or remove the file.");
}

void write(const std::string& output, const inside::StressesInside& stresses) {
  const std::string ending = std::filesystem::path(output).extension().string();
  if (ending == ".csv")
    write_text(output, [&](std::ostream& out) { write_csv(out, stresses); });
  else if (ending == ".vtu")
    write_text(output, [&](std::ostream& out) { write_vtu(out, stresses); });
  else
    record::write_hdf5(output, record::Record{{"format", record::Text{stresses_format}},
                                              {"program", record::Text{provenance("fem_influence")}},
                                              {"commit", record::Text{std::string(commit())}}}
                                   .append(record_of(stresses)));
}

} // namespace

void stress_command(const std::string& body_file, const std::string& mesh, const StressOptions& options) {
  const BodyFile body = read_body_file(body_file);
  std::vector<std::filesystem::path> inputs{body_file, profile_file_of(body), mesh, options.points};
  inputs.insert(inputs.end(), options.results.begin(), options.results.end());
  std::vector<Output> outputs;
  for (const std::string& file : options.outputs)
    outputs.push_back({"--stresses", file, is_text(file) ? OutputForm::text : OutputForm::whole_file});
  require_outputs(inputs, outputs);
  for (const std::string& file : options.outputs)
    if (!is_text(file))
      require_own_file(file);
  const ProfileCurve curve = body_profile(body);
  std::vector<LoadedInside> loads = loads_on(body, curve, options);
  ProgressBar bar("wavenumbers");
  add_body_stresses(loads, body, curve, mesh,
                    [&](std::size_t done, std::size_t all) { bar.show(done, all); });
  const inside::StressesInside& first = loads.front().stresses;
  fmt::print(stderr, "{} unknowns, {} wavenumbers\n", first.unknowns, first.wavenumbers);
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const inside::StressesInside& stresses = loads[i].stresses;
    for (std::size_t k = 0; k < stresses.areas.size(); ++k)
      fmt::print(stderr, "  {}{} {} of the {}: {}\n", loads.size() > 1 ? options.results[i] + ", " : "",
                 options.points.empty() ? "patch" : "points", k + 1, name_of(stresses.side),
                 in_words(stresses, stresses.areas[k]));
    write(options.outputs[i], stresses);
  }
}

} // namespace bem_contact::fem
