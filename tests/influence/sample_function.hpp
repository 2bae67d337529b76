#pragma once

#include "bem_contact/base/error.hpp"
#include "bem_contact/influence/file_seal.hpp"
#include "bem_contact/influence/influence_file.hpp"
#include "bem_contact/influence/influence_function.hpp"
#include "tests/base/message.hpp"
#include "tests/base/temporary_folder.hpp"

#include <cmath>
#include <fstream>
#include <numbers>
#include <span>
#include <string>

/// Gives a file that was changed a seal that holds.
inline void seal_again(const std::filesystem::path& file) {
  std::string bytes = text_of(file);
  bem_contact::seal(std::as_writable_bytes(std::span(bytes)), bem_contact::influence_format_major,
                    bem_contact::influence_format_minor);
  std::ofstream(file, std::ios::binary) << bytes;
}

/// A small body with every table filled: eleven wavenumbers, positive definite (three stations) and
/// symmetric.
inline bem_contact::InfluenceFunction sample_function(int stations = 3) {
  bem_contact::InfluenceFunction f;
  f.body = "sample of a body";
  f.profile = "60E1";
  f.profile_digest = 0xfedcba9876543210u;
  f.material = {81999.5, 0.27};
  f.held = "at its foot";
  f.method = "harmonic, made up for a test";
  f.half_period = 20;
  f.station_width = 0.25;
  for (int i = 0; i < stations; ++i)
    f.stations.push_back({-31 + 0.25 * i, {-30 + 0.2 * i, 4 - 0.1 * i}, -0.6 + 0.05 * i});
  for (int k = 0; k < 11; ++k)
    f.wavenumber.push_back(k <= 8 ? k * std::numbers::pi / 20 : 40.0 * (k - 8) / 2);
  const std::size_t n = 3 * f.station_count();
  f.kernel.resize(11 * f.kernel_size());
  for (std::size_t k = 0; k < 11; ++k) {
    const double fade = 1e-6 / (1 + f.wavenumber[k]);
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = 0; b <= a; ++b)
        f.kernel[f.kernel_index(k, a, b)] = fade * (a == b ? 3.0 + 0.1 * static_cast<double>(a)
                                                           : std::cos(double(a * b)) / (1.0 + double(a + b)));
    for (std::size_t d = 0; d < 6; ++d)
      for (std::size_t a = 0; a < n; ++a)
        f.remote.push_back(0.05 * fade * std::sin(1.0 + double(d) + 2.0 * double(a)));
    for (std::size_t d = 0; d < 6; ++d)
      for (std::size_t e = 0; e < 6; ++e)
        f.remote_self.push_back(fade * (d == e ? 0.5 : 0.02));
  }
  f.betti_error = 1e-12;
  f.reaction_error = 2e-13;
  f.estimated_error = 3e-4;
  return f;
}
