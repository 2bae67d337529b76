#include "fem_influence/harmonic/stress_run.hpp"

#include "bem_contact/base/sha256.hpp"
#include "bem_contact/influence/partial_influence_file.hpp"
#include "fem_influence/harmonic/stress_forms.hpp"
#include "fem_influence/harmonic/task_distribution.hpp"
#include "fem_influence/shared/parallel.hpp"
#include "fem_influence/shared/settings.hpp"

#include <cstring>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace bem_contact::fem {

std::filesystem::path partial_stresses(const std::filesystem::path& output) {
  return output.string() + ".stresses.part";
}

namespace {

constexpr JournalKind stress_journals = wavenumber_journals("conformal-contact partial stresses 1\n");

/// The finished wavenumbers, on the first process. Each record has its number before its numbers.
class FinishedStresses {
public:
  FinishedStresses(const StressPlan& plan, const std::filesystem::path& file, const std::string& fingerprint)
      : plan_(plan), journal_(file, stress_journals, sha256(fingerprint), [this](std::string_view record) {
          std::vector<double> numbers(record.size() / sizeof(double));
          std::memcpy(numbers.data(), record.data(), numbers.size() * sizeof(double));
          if (!numbers.empty() && numbers[0] >= 0 &&
              numbers[0] < static_cast<double>(plan_.wavenumber.size()) &&
              is_whole(static_cast<std::size_t>(numbers[0]), std::span(numbers).subspan(1)))
            done_[static_cast<std::size_t>(numbers[0])] = {numbers.begin() + 1, numbers.end()};
        }) {}

  bool has(std::size_t k) const { return done_.contains(k); }
  std::size_t count() const { return done_.size(); }
  void write(std::size_t k, std::vector<double> numbers) {
    std::vector<double> record{static_cast<double>(k)};
    record.insert(record.end(), numbers.begin(), numbers.end());
    journal_.append({reinterpret_cast<const char*>(record.data()), record.size() * sizeof(double)});
    done_[k] = std::move(numbers);
  }
  StressKernel kernel(std::vector<char> there) const {
    StressKernel out{.places = plan_.places,
                     .depths = plan_.depths,
                     .there = std::move(there),
                     .remainder = {},
                     .error = {}};
    out.remainder = form(false, settings::stress_tolerance);
    out.error = form(true, settings::stress_error_tolerance);
    return out;
  }

private:
  StressForm form(bool of_error, double tolerance) const {
    std::vector<double> waves;
    std::vector<FewColumns> each;
    for (const auto& [k, numbers] : done_) {
      if (of_error && !plan_.has_error[k])
        continue;
      std::span<const double> rest = numbers;
      FewColumns columns = take(rest);
      each.push_back(of_error ? take(rest) : std::move(columns));
      waves.push_back(plan_.wavenumber[k]);
    }
    return common_columns(std::move(waves), each, tolerance);
  }
  FewColumns take(std::span<const double>& numbers) const {
    return take_few_columns(numbers, 6 * plan_.places.size(), 3 * plan_.stations.size());
  }
  bool is_whole(std::size_t k, std::span<const double> numbers) const {
    const auto has_all = [&](const FewColumns& form) { return form.left.size() == plan_.depths.size(); };
    return has_all(take(numbers)) && (!plan_.has_error[k] || has_all(take(numbers)));
  }

  const StressPlan& plan_;
  std::map<std::size_t, std::vector<double>> done_;
  SealedJournal journal_;
};

} // namespace

StressKernel run_stresses(const StressPlan& plan, const ProfileCurve& curve,
                          const std::filesystem::path& mesh, const std::filesystem::path& output,
                          const std::string& fingerprint,
                          const std::function<void(std::size_t done)>& progress) {
  SharedCounters counters;
  std::optional<FinishedStresses> finished;
  std::vector<char> done(plan.wavenumber.size(), 0);
  together([&] {
    if (process_rank() != 0)
      return;
    finished.emplace(plan, partial_stresses(output), fingerprint);
    for (std::size_t k = 0; k < done.size(); ++k)
      done[k] = finished->has(k);
  });
  broadcast_from_first(done);
  std::vector<std::size_t> tasks;
  for (std::size_t k = 0; k < done.size(); ++k)
    if (!done[k])
      tasks.push_back(k);
  std::unique_ptr<StressSolver> solver;
  const auto make_solver = [&]() -> StressSolver& {
    if (!solver)
      solver = std::make_unique<StressSolver>(plan, curve, mesh);
    return *solver;
  };
  distribute(
      counters, {.count = tasks.size(), .second = tasks.size()},
      [&](std::size_t t) { return make_solver().at(tasks[t]); },
      [&](std::size_t t, std::vector<double> numbers) {
        finished->write(tasks[t], std::move(numbers));
        progress(finished->count());
      });
  StressKernel out;
  together([&] {
    if (process_rank() == 0)
      out = finished->kernel(make_solver().there());
  });
  return out;
}

} // namespace bem_contact::fem
