#include "fem_influence/run.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/influence/influence_file.hpp"
#include "fem_influence/parallel.hpp"
#include "fem_influence/wavenumbers.hpp"

#include <mpi.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>

namespace bem_contact::fem {

namespace {

constexpr std::size_t errors_each = 2; // of a wavenumber: Betti, reaction

void require_writable(const std::filesystem::path& output) {
  const auto folder = output.has_parent_path() ? output.parent_path() : std::filesystem::path(".");
  if (!std::filesystem::is_directory(folder) || ::access(folder.c_str(), W_OK) != 0)
    throw InputError("The file '" + output.string() + "' cannot be written",
                     "'" + folder.string() + "' is not a folder that can be written to",
                     "make the folder, or choose another file");
  if (std::filesystem::is_directory(output))
    throw InputError("The file '" + output.string() + "' cannot be written", "a folder has that name",
                     "choose another file");
}

/// FNV-1a of all that the numbers depend on: finished wavenumbers of another run are not taken over.
std::string fingerprint(const BodyFile& body, const ProfileCurve& curve, const std::filesystem::path& mesh) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  const auto mix = [&hash](const void* data, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i)
      hash = (hash ^ static_cast<const unsigned char*>(data)[i]) * 0x100000001b3u;
  };
  std::ifstream in(mesh, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  mix(text.data(), text.size());
  const std::uint64_t digest = curve.digest();
  mix(&digest, sizeof digest);
  for (const double value :
       {reference_radius_of(body), half_period_of(body), body.material.shear_modulus, body.material.poisson,
        body.strip.from, body.strip.to, body.strip.station_width, double(body.harmonic.degree),
        body.harmonic.shortest_dx, double(body.harmonic.samples_per_decade), body.harmonic.remote_distance})
    mix(&value, sizeof value);
  return "harmonic 2 " + std::to_string(hash);
}

std::string body_name(const BodyFile& body) {
  const auto millimetres = [](double v) {
    return std::to_string(std::lround(v * 1000) / 1000.0).substr(0, 7) + " mm";
  };
  if (body.body.kind == "rail" || body.body.kind == "wheel")
    return body.body.kind + " " + body.body.profile;
  if (body.body.kind == "outline")
    return body.body.name;
  return body.body.kind + (body.body.kind == "block" ? " of half width " + millimetres(body.body.size)
                                                     : " of radius " + millimetres(body.body.radius));
}

InfluenceFunction describe(const BodyFile& body, const ProfileCurve& curve, const Section& section,
                           std::vector<Station> stations, std::vector<double> wavenumber) {
  InfluenceFunction f;
  f.body = body_name(body);
  f.profile = curve.name();
  f.profile_digest = curve.digest();
  f.material = body.material;
  f.held = "all three displacements are zero on the mesh's group 'held' (physical curve 2)";
  f.method = "harmonic, degree " + std::to_string(section.degree()) + ", " +
             std::to_string(section.cell_count()) + " quadrilaterals";
  f.reference_radius = reference_radius_of(body);
  f.invariance = f.reference_radius > 0 ? Invariance::revolution : Invariance::prismatic;
  f.half_period = half_period_of(body);
  f.station_width = body.strip.station_width;
  f.stations = std::move(stations);
  f.wavenumber = std::move(wavenumber);
  return f;
}

/// Numbers of one wavenumber as one message.
std::vector<double> pack(const WavenumberResult& r) {
  std::vector<double> all(r.kernel);
  all.insert(all.end(), r.remote.begin(), r.remote.end());
  all.insert(all.end(), r.remote_self.begin(), r.remote_self.end());
  all.push_back(r.betti_error);
  all.push_back(r.reaction_error);
  return all;
}

double peak_memory_gib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / (1024.0 * 1024.0);
}

double reduced(double mine, MPI_Op op) {
  double all = 0;
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, op, MPI_COMM_WORLD);
  return all;
}

/// shortest_dx as arc length at the reference radius: an element at the strip's largest radius is the
/// shortest.
double shortest_reference_dx(const BodyFile& body, std::span<const Station> stations) {
  const double reference = reference_radius_of(body);
  double longest = 1;
  if (reference > 0)
    for (const Station& station : stations)
      longest = std::max(longest, (reference + station.position.z) / reference);
  return body.harmonic.shortest_dx / longest;
}

} // namespace

double discretisation_error(const std::filesystem::path& mesh, const BodyFile& body,
                            const ProfileCurve& curve, double wavenumber, std::span<const double> kernel) {
  const int p = body.harmonic.degree;
  if (p < 2)
    return -1;
  const Section section(mesh, p - 1, curve, body.strip);
  const std::vector<double> other = HarmonicSolver(section, body, curve).at(wavenumber).kernel;
  const auto n = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(other.size()))));
  double difference = 0;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      difference = std::max(difference, std::abs(other[i * n + j] - kernel[i * n + j]) /
                                            std::sqrt(kernel[i * n + i] * kernel[j * n + j]));
  return difference / (std::pow(p / (p - 1.0), 4) - 1);
}

RunReport run_harmonic(const BodyFile& body, const ProfileCurve& curve, const std::filesystem::path& mesh,
                       const std::filesystem::path& output, const RunProgress& progress) {
  const auto start = std::chrono::steady_clock::now();
  const int rank = process_rank(), size = process_count();
  std::optional<Section> section;
  std::optional<HarmonicSolver> solver;
  std::optional<PartialInfluenceFile> partial;
  InfluenceFunction function;
  std::vector<char> done;
  RunReport report;
  together([&] {
    require_writable(output);
    section.emplace(mesh, body.harmonic.degree, curve, body.strip);
    solver.emplace(*section, body, curve);
    function =
        describe(body, curve, *section, solver->stations(),
                 wavenumber_samples(half_period_of(body), shortest_reference_dx(body, solver->stations()),
                                    body.harmonic.samples_per_decade));
    done.assign(function.wavenumber_count(), 0);
    if (rank != 0)
      return;
    partial.emplace(output, fingerprint(body, curve, mesh), function.station_count(), function.wavenumber);
    for (std::size_t k = 0; k < done.size(); ++k)
      done[k] = partial->has(k);
  });
  MPI_Bcast(done.data(), static_cast<int>(done.size()), MPI_CHAR, 0, MPI_COMM_WORLD);
  std::vector<std::size_t> left;
  for (std::size_t k = 0; k < done.size(); ++k)
    if (!done[k])
      left.push_back(k);
  report.resumed = done.size() - left.size();
  if (rank == 0 && progress)
    progress(report.resumed, done.size());

  const std::size_t n = 3 * function.station_count(), kernel_size = n * n, remote_size = 6 * n;
  const std::size_t message = kernel_size + remote_size + 36 + errors_each;
  for (std::size_t round = 0; round < left.size(); round += static_cast<std::size_t>(size)) {
    const std::size_t mine = round + static_cast<std::size_t>(rank);
    std::vector<double> packed(message, 0.0), gathered;
    together([&] {
      if (mine < left.size())
        packed = pack(solver->at(function.wavenumber[left[mine]]));
      if (rank == 0)
        gathered.resize(message * static_cast<std::size_t>(size));
    });
    MPI_Gather(packed.data(), static_cast<int>(message), MPI_DOUBLE, gathered.data(),
               static_cast<int>(message), MPI_DOUBLE, 0, MPI_COMM_WORLD);
    together([&] {
      if (rank != 0)
        return;
      const std::size_t last = std::min(left.size(), round + static_cast<std::size_t>(size));
      for (std::size_t i = round; i < last; ++i) {
        const auto part = std::span<const double>(gathered).subspan(message * (i - round), message);
        partial->write(left[i], part.first(kernel_size), part.subspan(kernel_size, remote_size),
                       part.subspan(kernel_size + remote_size, 36), part.last(errors_each));
      }
      if (progress)
        progress(report.resumed + last, done.size());
    });
  }

  report.cells = section->cell_count();
  report.unknowns = solver->unknowns();
  report.stations = function.station_count();
  report.wavenumbers = function.wavenumber_count();
  const Timing& timing = solver->timing();
  report.timing = {reduced(timing.assembly, MPI_SUM), reduced(timing.analysis, MPI_SUM),
                   reduced(timing.factorization, MPI_SUM), reduced(timing.solve, MPI_SUM),
                   reduced(timing.sampling, MPI_SUM)};
  solver.reset();
  together([&] {
    if (rank != 0)
      return;
    std::vector<double> errors;
    partial->read_into(function, errors);
    for (std::size_t k = 0; k < report.wavenumbers; ++k) {
      report.betti_error = std::max(report.betti_error, errors.at(errors_each * k));
      report.reaction_error = std::max(report.reaction_error, errors.at(errors_each * k + 1));
    }
    // The mesh matters most where the field is as short as a station.
    const auto middle =
        static_cast<std::size_t>(std::lower_bound(function.wavenumber.begin(), function.wavenumber.end() - 1,
                                                  1 / function.station_width) -
                                 function.wavenumber.begin());
    report.interpolation_error = interpolation_error(function.wavenumber, function.kernel, n);
    report.discretisation_error = discretisation_error(
        mesh, body, curve, function.wavenumber[middle],
        std::span<const double>(function.kernel).subspan(middle * kernel_size, kernel_size));
    function.betti_error = report.betti_error;
    function.reaction_error = report.reaction_error;
    function.estimated_error = report.discretisation_error < 0 || report.interpolation_error < 0
                                   ? -1
                                   : report.discretisation_error + report.interpolation_error;
    write_influence_file(output, function);
    partial->remove();
  });
  report.peak_memory = reduced(peak_memory_gib(), MPI_MAX);
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

} // namespace bem_contact::fem
