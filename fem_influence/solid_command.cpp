#include "fem_influence/commands.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/base/printable.hpp"
#include "bem_contact/influence/expand.hpp"
#include "bem_contact/influence/file_seal.hpp"
#include "bem_contact/influence/influence_file.hpp"
#include "bem_contact/influence/requirements.hpp"
#include "bem_contact/profile/bodies/body_file.hpp"
#include "bem_contact/profile/standard_profiles.hpp"
#include "fem_influence/progress_bar.hpp"
#include "fem_influence/shared/body_description.hpp"
#include "fem_influence/solid/solid_check.hpp"
#include "fem_influence/solid/solid_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fmt/format.h>
#include <numeric>
#include <vector>

namespace bem_contact::fem {

namespace {

/// The influence function as a table along x, from loads on all stations. Loads of different meshes differ by
/// the error of the meshes. So the mean of A_ij(m; I, J) and +-A_ji(m; J, I) is stored, which is reciprocal,
/// and half of their largest difference, relative to the self numbers, is the table's betti_error.
InfluenceFunction as_table(const BodyFile& body, const ProfileCurve& curve, const SolidNumbers& numbers) {
  const std::size_t stations = numbers.stations.size(), n = 3 * stations;
  if (numbers.loads.size() != stations)
    throw InputError("The table of influence numbers would not be complete",
                     fmt::format("{} of {} stations were loaded", numbers.loads.size(), stations),
                     "Load all of them.");
  InfluenceFunction f = describe(body, curve);
  f.held = "all three displacements are zero on the mesh's group 'held' (physical surface 2)";
  f.method = fmt::format("solid3d, degree {}, up to {} hexahedra, {} along each side of the loaded element",
                         body.solid.degree, numbers.report.cells, body.solid.elements_per_load);
  f.table_dx = numbers.dx;
  f.table.assign(static_cast<std::size_t>(numbers.offsets) * n * n, 0.0);
  for (int m = 0; m < numbers.offsets; ++m)
    for (std::size_t row = 0; row < n; ++row)
      for (std::size_t column = 0; column <= row; ++column) {
        const auto i = static_cast<int>(row % 3), j = static_cast<int>(column % 3);
        const auto I = static_cast<int>(row / 3), J = static_cast<int>(column / 3);
        const double a = numbers.at(column / 3, j, m, I, i),
                     b = parity(i, j) * numbers.at(row / 3, i, m, J, j);
        const double self = std::sqrt(numbers.at(row / 3, i, 0, I, i) * numbers.at(column / 3, j, 0, J, j));
        f.betti_error = std::max(f.betti_error, 0.5 * std::abs(a - b) / self);
        // On the diagonal of an odd pair a and b are the same number.
        double* table = f.table.data() + static_cast<std::size_t>(m) * n * n;
        table[row * n + column] = 0.5 * (a + b);
        table[column * n + row] = parity(i, j) * table[row * n + column];
      }
  f.estimated_error = -1;
  return f;
}

/// Error by the meshes, relative to the self number. One load is computed again with elements twice as large.
/// Errors go as h^2, so the error is a third of the largest difference; we return half of it. -1: no mesh is
/// coarser.
double mesh_error(const BodyFile& body, const ProfileCurve& curve, const std::filesystem::path& mesh,
                  const SolidNumbers& numbers) {
  BodyFile coarse = body;
  coarse.solid.elements_per_load = body.solid.elements_per_load / 2;
  if (coarse.solid.elements_per_load < 1)
    return -1;
  const std::size_t middle = numbers.loads.size() / 2;
  const int J = numbers.loads[middle];
  const SolidNumbers other = solid_numbers(coarse, curve, mesh, {.loads = {J}});
  double worst = 0;
  for (int j = 0; j < 3; ++j)
    for (int m = 0; m < numbers.offsets; ++m)
      for (int I = 0; I < static_cast<int>(numbers.stations.size()); ++I)
        for (int i = 0; i < 3; ++i) {
          const double self = std::sqrt(numbers.at(middle, i, 0, J, i) * numbers.at(middle, j, 0, J, j));
          worst = std::max(worst, std::abs(other.at(0, j, m, I, i) - numbers.at(middle, j, m, I, i)) / self);
        }
  return worst / 2;
}

void print_check(const std::vector<SolidDifference>& bands) {
  constexpr const char* name = "xsn";
  print_out("{:<16}{:>9}  largest of self and of local, %; then each component of local, %\n", "distance",
            "elements");
  for (const auto& band : bands) {
    if (band.elements == 0)
      continue;
    double self = 0, local = 0;
    std::string each;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        self = std::max(self, band.of_self[i][j]);
        local = std::max(local, band.of_local[i][j]);
        each += fmt::format(" {}{} {:.3f}", name[i], name[j], 100 * band.of_local[i][j]);
      }
    print_out("{:<16}{:>9}  {:.3f} {:.3f} {}\n",
              band.up_to == 0 ? "loaded element" : fmt::format("to {} mm", band.up_to), band.elements,
              100 * self, 100 * local, each);
  }
}

void check_files(const std::vector<std::filesystem::path>& inputs, const SolidOptions& options) {
  if (options.output.empty() && options.check.empty() && options.vtu.empty())
    throw InputError("There is nothing to do with the 3-D numbers", "they would be computed and forgotten",
                     "Give -o OUT.h5, --check INFLUENCE.h5 or --vtu FIELD.vtu.");
  require_outputs(inputs, {{"--output", options.output, OutputForm::whole_file}, {"--vtu", options.vtu}});
}

void write_table(const BodyFile& body, const ProfileCurve& curve, const std::string& mesh,
                 const SolidNumbers& numbers, const std::string& output) {
  InfluenceFunction function = as_table(body, curve, numbers);
  function.estimated_error = mesh_error(body, curve, mesh, numbers);
  write_influence_file(output, function);
  print_error("{}: table of {} offsets, Maxwell-Betti between meshes {:.1e}, estimated error {}\n", output,
              numbers.offsets, function.betti_error,
              function.estimated_error < 0 ? "none" : fmt::format("{:.1e}", function.estimated_error));
}

void compare_with(const std::string& file, const BodyFile& body, const ProfileCurve& curve,
                  const SolidNumbers& numbers) {
  const InfluenceFunction function = read_influence_file(file);
  require_profile(function, curve.name(), curve.digest());
  require_material(function, body.material);
  const InfluenceNumbers reference = expand(
      function, {.dx = numbers.dx, .offsets = numbers.offsets, .structural = StructuralCompliance::included});
  for (const bool removed : {false, true}) {
    print_out("{}\n", removed ? "rigid motion of the differences removed:" : "as computed:");
    print_check(compare(numbers, reference, function.reference_radius, removed));
  }
}

} // namespace

void solid_command(const std::string& body_file, const std::string& mesh, const SolidOptions& options) {
  const BodyFile body = read_body_file(body_file);
  check_files({body_file, profile_file_of(body), mesh, options.check}, options);
  if (!options.output.empty())
    require_replaceable_influence(options.output);
  const ProfileCurve curve = body_profile(body);
  require_mesh_of(body, curve, mesh);
  const std::size_t stations = make_stations(body.strip, curve).size();
  const std::vector<int> chosen =
      options.load_stations.empty() ? std::vector{static_cast<int>(stations / 2)} : options.load_stations;
  std::vector<int> loads = chosen;
  if (!options.output.empty()) { // a file needs them all
    loads.resize(stations);
    std::iota(loads.begin(), loads.end(), 0);
  }
  ProgressBar bar("loaded stations");
  const SolidNumbers numbers =
      solid_numbers(body, curve, mesh,
                    {.loads = loads,
                     .field = {options.vtu, chosen.front(), options.component},
                     .progress = [&](std::size_t done, std::size_t all) { bar.show(done, all); }});
  const SolidReport& report = numbers.report;
  print_error("{}: {} cells, {} unknowns, {:.1f} s, {:.2f} GiB, Maxwell-Betti {:.1e}\n", mesh, report.cells,
              report.unknowns, report.seconds, report.peak_memory, report.betti_error);
  if (!options.vtu.empty())
    print_error("{}: field displacement_mm under 1 MPa along {} on station {}, half of the body\n",
                options.vtu, "xsn"[options.component], chosen.front());
  if (!options.output.empty())
    write_table(body, curve, mesh, numbers, options.output);
  if (!options.check.empty())
    compare_with(options.check, body, curve, numbers);
}

} // namespace bem_contact::fem
