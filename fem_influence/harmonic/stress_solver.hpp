#pragma once

#include "bem_contact/influence/stress_kernel.hpp"
#include "bem_contact/profile/bodies/body_file.hpp"
#include "bem_contact/profile/profile_curve.hpp"

#include <filesystem>
#include <memory>
#include <vector>

namespace bem_contact::fem {

/// Stresses of the inside that a run computes beside the kernel (THEORY.md, section 10). It follows from the
/// body file alone, so every process has the same.
struct StressPlan {
  BodyFile body; ///< without halved borders: the remainder has no jumps
  std::vector<Station> stations;
  std::vector<ContactRow> places;
  std::vector<double> depths;
  std::vector<double> wavenumber;
  std::vector<char> has_error; ///< [wavenumber]: whether the coarser solution is computed, too
};
/// Throws InputError for depths or wavenumbers that cannot be.
StressPlan plan_stresses(const BodyFile& body, const ProfileCurve& curve);

/// Solves for all unit loads of a wavenumber, and takes stresses.
class StressSolver {
public:
  StressSolver(const StressPlan& plan, const ProfileCurve& curve, const std::filesystem::path& mesh);
  ~StressSolver();
  StressSolver(const StressSolver&) = delete;
  StressSolver& operator=(const StressSolver&) = delete;

  std::vector<char> there() const; ///< [place][depth]: whether the body is
  /// few_columns() of the remainder, then those of the error, or 0 where it is not computed.
  std::vector<double> at(std::size_t k);

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace bem_contact::fem
