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

/// The tractions on the body, and what is known of them.
struct Load {
  inside::SurfaceTractions tractions;
  inside::Side side = inside::Side::rail;
  double error = 0;
};

Load load_on(const BodyFile& body, const ProfileCurve& curve, const StressOptions& options) {
  if (options.result.empty())
    return {tractions_of(load_of(options.ellipse), body.material.poisson), inside::Side::rail, 0};
  const record::Record result = record::read_hdf5(options.result);
  const inside::Side side = inside::side_of(result, curve.digest());
  Load out{inside::read_tractions(result, side), side, inside::traction_error(result)};
  if (std::abs(out.tractions.poisson - body.material.poisson) > 1e-9)
    throw InputError(
        "The body has another material than the result",
        fmt::format("Poisson's ratios are {:g} and {:g}", body.material.poisson, out.tractions.poisson),
        "Correct [material] of the body file, or solve the scene again.");
  return out;
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
  const bool is_text = options.output.ends_with(".csv") || options.output.ends_with(".vtu");
  require_outputs({body_file, profile_file_of(body), mesh, options.result, options.points},
                  {{"--stresses", options.output, is_text ? OutputForm::text : OutputForm::whole_file}});
  if (!is_text)
    require_own_file(options.output);
  const ProfileCurve curve = body_profile(body);
  const Load load = load_on(body, curve, options);
  const std::vector<inside::BelowSurface> own = options.points.empty()
                                                    ? std::vector<inside::BelowSurface>{}
                                                    : inside::read_points_below(options.points);
  inside::StressesInside stresses = inside::halfspace_inside(load.tractions, load.side, own);
  if (stresses.areas.empty())
    throw InputError("There is no patch with stresses worth looking at",
                     "none has four rows and columns of elements", "Solve the scene with smaller elements.");
  stresses.traction_error = load.error;
  ProgressBar bar("wavenumbers");
  add_body_stresses(stresses, load.tractions, body, curve, mesh,
                    [&](std::size_t done, std::size_t all) { bar.show(done, all); });
  fmt::print(stderr, "{} unknowns, {} wavenumbers\n", stresses.unknowns, stresses.wavenumbers);
  for (std::size_t k = 0; k < stresses.areas.size(); ++k)
    fmt::print(stderr, "  {} {} of the {}: {}\n", own.empty() ? "patch" : "points", k + 1,
               name_of(stresses.side), in_words(stresses, stresses.areas[k]));
  write(options.output, stresses);
}

} // namespace bem_contact::fem
