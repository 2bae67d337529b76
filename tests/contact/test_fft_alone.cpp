#include <fftw3.h>

#include <complex>
#include <gtest/gtest.h>
#include <numbers>
#include <random>
#include <vector>

namespace {

/// The transform of each line by its sum.
std::vector<std::complex<double>> sums(const std::vector<std::complex<double>>& in, int n, int sign) {
  std::vector<std::complex<double>> out(in.size());
  for (std::size_t at = 0; at < in.size(); ++at) {
    const std::size_t line = at / n * n, k = at % n;
    for (std::size_t j = 0; j < static_cast<std::size_t>(n); ++j)
      out[at] +=
          in[line + j] * std::polar(1.0, sign * 2 * std::numbers::pi * static_cast<double>(j * k % n) / n);
  }
  return out;
}

/// How far the transforms are from the sums, relative to the root of the length.
template <class Real, class Plan, class Execute, class Destroy>
double worst(int n, int lines, int sign, Plan plan_many, Execute execute, Destroy destroy) {
  std::mt19937 random(7);
  std::normal_distribution<> normal;
  std::vector<std::complex<double>> in(static_cast<std::size_t>(n) * lines);
  for (auto& z : in)
    z = {normal(random), normal(random)};
  std::vector<std::complex<Real>> from(in.begin(), in.end()), to(in.size());
  auto* const a = reinterpret_cast<Real(*)[2]>(from.data());
  auto* const b = reinterpret_cast<Real(*)[2]>(to.data());
  const auto plan = plan_many(1, &n, lines, a, nullptr, 1, n, b, nullptr, 1, n, sign, FFTW_ESTIMATE);
  execute(plan, a, b);
  destroy(plan);
  const auto exact = sums(in, n, sign);
  double out = 0;
  for (std::size_t i = 0; i < exact.size(); ++i)
    out = std::max(out, std::abs(std::complex<double>(to[i]) - exact[i]) / std::sqrt(n));
  return out;
}

} // namespace

TEST(Fft, EachLineBecomesItsSum) {
  for (const int n :
       {1, 2, 3, 4, 5, 6, 8, 10, 12, 15, 16, 18, 20, 25, 30, 48, 60, 64, 90, 100, 128, 150, 240})
    for (const int lines : {1, 3, 4, 9})
      for (const int sign : {FFTW_FORWARD, FFTW_BACKWARD}) {
        EXPECT_LT(worst<double>(n, lines, sign, fftw_plan_many_dft, fftw_execute_dft, fftw_destroy_plan),
                  1e-14)
            << n << " " << lines << " " << sign;
        EXPECT_LT(worst<float>(n, lines, sign, fftwf_plan_many_dft, fftwf_execute_dft, fftwf_destroy_plan),
                  5e-6)
            << n << " " << lines << " " << sign;
      }
}

TEST(Fft, OtherLengthsAreRefused) {
  const int n = 14;
  EXPECT_THROW(fftw_plan_many_dft(1, &n, 1, nullptr, nullptr, 1, n, nullptr, nullptr, 1, n, FFTW_FORWARD,
                                  FFTW_ESTIMATE),
               std::invalid_argument);
}
