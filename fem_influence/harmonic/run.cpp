#include "fem_influence/harmonic/run.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/fnv1a.hpp"
#include "bem_contact/influence/influence_file.hpp"
#include "bem_contact/influence/lower_triangle.hpp"
#include "bem_contact/influence/partial_influence_file.hpp"
#include "bem_contact/profile/standard_profiles.hpp"
#include "fem_influence/harmonic/lazy_solver.hpp"
#include "fem_influence/harmonic/wavenumbers.hpp"
#include "fem_influence/shared/parallel.hpp"

#include <mpi.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>

namespace bem_contact::fem {

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

void require_mesh_of(const BodyFile& body, const ProfileCurve& curve, const std::filesystem::path& mesh) {
  std::ifstream in(mesh, std::ios::binary | std::ios::ate);
  const auto size = static_cast<std::streamoff>(in.tellg());
  constexpr std::streamoff tail = 200;
  in.seekg(std::max<std::streamoff>(0, size - tail));
  const std::string text{std::istreambuf_iterator<char>(in), {}}, mark = "$Comments\nbody file ";
  const auto at = text.find(mark);
  if (at != std::string::npos && text.substr(at + mark.size(), 16) != mesh_digest(body, curve.digest()))
    throw InputError("The mesh '" + mesh.string() + "' was made from another body file",
                     "its digest of [body], [strip] and [mesh] is another one",
                     "make it anew: mesh_body BODY.toml -o " + mesh.string());
}

namespace {

constexpr std::size_t errors_each = 3; // of a wavenumber: Betti, reaction, smallest eigenvalue

/// Hash of all that the numbers depend on: finished wavenumbers of another run are not taken over.
std::string fingerprint(const BodyFile& body, const ProfileCurve& curve, const std::filesystem::path& mesh) {
  Fnv1a hash;
  std::ifstream in(mesh, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  hash.add(std::as_bytes(std::span(text)));
  const std::uint64_t digest = curve.digest();
  hash.add(std::as_bytes(std::span(&digest, 1)));
  for (const double value :
       {reference_radius_of(body), half_period_of(body), body.material.shear_modulus, body.material.poisson,
        body.strip.from, body.strip.to, body.strip.station_width, double(body.harmonic.degree),
        double(body.harmonic.border_levels), body.harmonic.shortest_dx,
        double(body.harmonic.samples_per_decade), body.harmonic.remote_distance})
    hash.add(std::as_bytes(std::span(&value, 1)));
  return "harmonic 7 " + std::to_string(hash.value());
}

std::string method_of(const BodyFile& body, std::size_t cells) {
  return "harmonic, degree " + std::to_string(body.harmonic.degree) + ", " + std::to_string(cells) +
         " quadrilaterals, halved " + std::to_string(body.harmonic.border_levels) +
         " times at the stations' borders";
}

InfluenceFunction describe(const BodyFile& body, const ProfileCurve& curve, std::vector<Station> stations,
                           std::vector<double> wavenumber) {
  InfluenceFunction f;
  f.body = body_name(body);
  f.profile = curve.name();
  f.profile_digest = curve.digest();
  f.material = body.material;
  f.held = held_part(body.body) +
           ": all three displacements are zero on the mesh's group 'held' (physical curve 2)";
  f.reference_radius = reference_radius_of(body);
  f.invariance = f.reference_radius > 0 ? Invariance::revolution : Invariance::prismatic;
  f.half_period = half_period_of(body);
  f.station_width = body.strip.station_width;
  f.stations = std::move(stations);
  f.wavenumber = std::move(wavenumber);
  return f;
}

/// Numbers of one wavenumber as PartialInfluenceFile takes them.
std::vector<double> pack(const WavenumberResult& r) {
  const std::size_t rows = r.remote.size() / 6;
  std::vector<double> all;
  all.reserve(lower_size(rows) + 6 * rows + 36 + errors_each + 1); // and the task's number behind them
  append_lower(all, r.kernel, rows);
  all.insert(all.end(), r.remote.begin(), r.remote.end());
  all.insert(all.end(), r.remote_self.begin(), r.remote_self.end());
  all.push_back(r.betti_error);
  all.push_back(r.reaction_error);
  all.push_back(r.smallest_eigenvalue);
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

/// One wavenumber of the run or of its companion that is still to be done.
struct Task {
  bool companion = false;
  std::size_t k = 0;
};

} // namespace

RunReport run_harmonic(const BodyFile& body, const ProfileCurve& curve, const std::filesystem::path& mesh,
                       const std::filesystem::path& output, const RunProgress& progress) {
  const auto start = std::chrono::steady_clock::now();
  const int rank = process_rank();
  const bool estimated = body.harmonic.degree > 1;
  BodyFile coarser = body;
  --coarser.harmonic.degree;
  coarser.harmonic.border_levels = std::max(0, body.harmonic.border_levels - 1);
  LazySolver run(body, curve, mesh), companion(coarser, curve, mesh);
  // Some processes begin with the companion, and the others need no mesh of it at all.
  const auto begins_with_companion = [&](int process) {
    return estimated && process > 0 && process >= process_count() - std::max(1, process_count() / 5);
  };
  const bool companion_first = begins_with_companion(rank);
  Fellows fellows;
  SharedCounters counters;
  // One process of each machine assembles for all, if it is one of those that begin with the run.
  const bool shared = fellows.count() > 1 && !begins_with_companion(fellows.first());
  InfluenceFunction function, coarse;
  std::optional<PartialInfluenceFile> partial, coarse_partial;
  RunReport report;
  std::vector<Task> tasks;
  std::vector<char> done;
  together([&] {
    require_writable(output);
    const std::vector<Station> stations = make_stations(body.strip, curve);
    function = describe(body, curve, stations,
                        wavenumber_samples(half_period_of(body), shortest_reference_dx(body, stations),
                                           body.harmonic.samples_per_decade));
    require_mesh_of(body, curve, mesh);
    const std::vector<std::size_t> compared = compared_stations(stations.size());
    companion.choose(compared);
    // What is wrong with the mesh is found before anything is written.
    if (companion_first)
      companion.prepare();
    else if (!shared || fellows.rank() == 0)
      run.prepare();
    for (std::size_t k = 0; k < function.wavenumber_count(); ++k)
      tasks.push_back({false, k});
    if (estimated) {
      coarse = function;
      coarse.wavenumber.clear();
      coarse.stations.clear();
      for (const std::size_t J : compared)
        coarse.stations.push_back(stations[J]);
      for (const std::size_t k : companion_samples(function.wavenumber_count())) {
        tasks.push_back({true, coarse.wavenumber_count()});
        coarse.wavenumber.push_back(function.wavenumber[k]);
      }
    }
    done.assign(tasks.size(), 0);
    if (rank != 0)
      return;
    const std::string print = fingerprint(body, curve, mesh);
    partial.emplace(output, print, function.station_count(), function.wavenumber);
    if (estimated)
      coarse_partial.emplace(output.string() + ".companion", print + " companion", coarse.station_count(),
                             coarse.wavenumber);
    for (std::size_t t = 0; t < tasks.size(); ++t)
      done[t] = (tasks[t].companion ? coarse_partial : partial)->has(tasks[t].k);
  });
  MPI_Bcast(done.data(), static_cast<int>(done.size()), MPI_CHAR, 0, MPI_COMM_WORLD);
  const std::size_t all = tasks.size();
  for (std::size_t t = all; t-- > 0;)
    if (done[t])
      tasks.erase(tasks.begin() + static_cast<std::ptrdiff_t>(t));
  report.resumed = all - tasks.size();
  std::size_t finished = report.resumed;
  if (rank == 0 && progress)
    progress(finished, all);

  std::exception_ptr not_assembled;
  if (shared && !tasks.empty() && !tasks.front().companion) {
    run.share(fellows);
    if (fellows.rank() == 0)
      try {
        run.assemble();
      } catch (...) {
        not_assembled = std::current_exception();
      }
  }
  const auto first_of_companion =
      std::find_if(tasks.begin(), tasks.end(), [](const Task& task) { return task.companion; });
  distribute(
      counters, tasks.size(), static_cast<std::size_t>(first_of_companion - tasks.begin()), companion_first,
      [&](std::size_t t) {
        if (not_assembled)
          std::rethrow_exception(not_assembled);
        if (tasks[t].companion != companion_first)
          (companion_first ? companion : run).release(); // the first kind is done
        return tasks[t].companion ? pack(companion.solver().at(coarse.wavenumber[tasks[t].k]))
                                  : pack(run.solver().at(function.wavenumber[tasks[t].k]));
      },
      [&](std::size_t t, std::vector<double> packed) {
        (tasks[t].companion ? coarse_partial : partial)->write(tasks[t].k, std::move(packed));
        if (progress)
          progress(++finished, all);
      });

  report.unknowns = run.unknowns();
  report.cells = run.cells();
  report.stations = function.station_count();
  report.wavenumbers = function.wavenumber_count();
  report.companion_wavenumbers = coarse.wavenumber_count();
  run.release();
  companion.release();
  const Timing timing = run.timing() + companion.timing();
  report.timing = {reduced(timing.assembly, MPI_SUM), reduced(timing.analysis, MPI_SUM),
                   reduced(timing.factorization, MPI_SUM)};
  together([&] {
    if (rank != 0)
      return;
    std::vector<double> errors;
    partial->take_into(function, errors);
    report.smallest_eigenvalue = std::numeric_limits<double>::max();
    for (std::size_t k = 0; k < report.wavenumbers; ++k) {
      report.betti_error = std::max(report.betti_error, errors.at(errors_each * k));
      report.reaction_error = std::max(report.reaction_error, errors.at(errors_each * k + 1));
      report.smallest_eigenvalue = std::min(report.smallest_eigenvalue, errors.at(errors_each * k + 2));
    }
    if (estimated) {
      coarse_partial->take_into(coarse, errors);
      report.error = estimate_error(function, coarse, shortest_reference_dx(body, function.stations),
                                    error_ratio(body.harmonic.degree, body.harmonic.border_levels),
                                    body.harmonic.samples_per_decade);
    }
    function.method = method_of(body, report.cells);
    function.betti_error = report.betti_error;
    function.reaction_error = report.reaction_error;
    function.estimated_error = estimated ? report.error.total : -1;
    write_influence_file(output, function);
    partial->remove();
    if (estimated)
      coarse_partial->remove();
  });
  report.peak_memory = reduced(peak_memory_gib(), MPI_MAX);
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

} // namespace bem_contact::fem
