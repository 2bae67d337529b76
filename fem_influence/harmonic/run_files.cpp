#include "fem_influence/harmonic/run_files.hpp"

#include "bem_contact/base/fnv1a.hpp"
#include "bem_contact/influence/lower_triangle.hpp"
#include "fem_influence/shared/body_description.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <limits>
#include <span>

namespace bem_contact::fem {

namespace {
constexpr std::size_t errors_each = 3; // of a wavenumber: Betti, reaction, smallest eigenvalue
}

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
        double(body.harmonic.samples_per_decade), body.harmonic.remote_distance, double(body.stress.depths),
        body.stress.deepest, body.stress.beyond})
    hash.add(std::as_bytes(std::span(&value, 1)));
  return "harmonic 7 " + std::to_string(hash.value());
}

std::vector<double> packed(const WavenumberResult& r) {
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

RunFiles::RunFiles(const std::filesystem::path& output, const std::string& print, const RunPlan& plan)
    : run_(output, print, plan.function.station_count(), plan.function.wavenumber) {
  if (plan.companion)
    companion_.emplace(output.string() + ".companion", print + " companion",
                       plan.companion->function.station_count(), plan.companion->function.wavenumber);
}

bool RunFiles::has(const WavenumberTask& task) const {
  return (task.companion ? *companion_ : run_).has(task.k);
}

void RunFiles::write(const WavenumberTask& task, std::vector<double> numbers) {
  (task.companion ? *companion_ : run_).write(task.k, std::move(numbers));
}

KernelErrors RunFiles::take_into(RunPlan& plan) {
  std::vector<double> errors;
  run_.take_into(plan.function, errors);
  KernelErrors all{.smallest_eigenvalue = std::numeric_limits<double>::max()};
  for (std::size_t k = 0; k < plan.function.wavenumber_count(); ++k) {
    all.betti = std::max(all.betti, errors.at(errors_each * k));
    all.reaction = std::max(all.reaction, errors.at(errors_each * k + 1));
    all.smallest_eigenvalue = std::min(all.smallest_eigenvalue, errors.at(errors_each * k + 2));
  }
  if (companion_)
    companion_->take_into(plan.companion->function, errors);
  return all;
}

void RunFiles::remove() {
  run_.remove();
  if (companion_)
    companion_->remove();
}

} // namespace bem_contact::fem
