#include "bem_contact/halfspace/wave_stress.hpp"

#include "bem_contact/influence/dense.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace bem_contact::halfspace {

namespace {

using Complex = std::complex<double>;
using ComplexStress = std::array<Complex, 6>; ///< xx, ss, nn, xs, xn, sn

/// 1 (over the depth). Waves beyond this have decayed to 1e-12.
constexpr double last_exponent = 28;
/// rad. By so much the phase turns at most within a panel of the integral, which has eight Gauss points.
constexpr double phase_of_panel = 6;
constexpr std::array<double, 4> gauss_place{0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                            0.9602898564975363},
    gauss_weight{0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763};

struct Wave {
  double q, weight;
};

/// Panels that grow from the scale of k, at which the integrand bends, to the widest.
std::vector<Wave> waves_along_s(double k, double last, double widest) {
  std::vector<Wave> out;
  double width = k > 0 ? std::min(k, widest) : widest;
  for (double from = 0; from < last; from += width) {
    if (from > 0)
      width = std::min(std::max(from, width), widest);
    for (std::size_t i = 0; i < gauss_place.size(); ++i)
      for (const double side : {-1.0, 1.0})
        out.push_back({from + 0.5 * width * (1 + side * gauss_place[i]), 0.5 * width * gauss_weight[i]});
  }
  return out;
}

/// Under the traction exp(i (kx + qs)) along x, s or n. In the plane of the wave vector and n: Airy's
/// (A + B n) exp(-kappa n); across it a shear.
ComplexStress under_wave(double poisson, double k, double q, double depth, std::size_t load) {
  constexpr Complex i{0, 1};
  const double kappa = std::hypot(k, q), c = k / kappa, t = q / kappa, kn = kappa * depth,
               decay = std::exp(-kn);
  const double along = load == 0   ? c
                       : load == 1 ? t
                                   : 0,
               across = load == 0   ? -t
                        : load == 1 ? c
                                    : 0,
               press = load == 2 ? 1 : 0;
  const Complex b = press - i * along;
  const Complex ll = -press + 2.0 * i * along + b * kn, nn = -(press + b * kn),
                ln = -along + (i * press + along) * kn, tt = poisson * (ll + nn), tn = -across,
                lt = i * across;
  ComplexStress out{c * c * ll + t * t * tt - 2 * c * t * lt,
                    t * t * ll + c * c * tt + 2 * c * t * lt,
                    nn,
                    c * t * (ll - tt) + (c * c - t * t) * lt,
                    c * ln - t * tn,
                    t * ln + c * tn};
  for (Complex& value : out)
    value *= decay;
  return out;
}

/// Whether a component is even in s: that under px or pn, or under ps.
bool is_even(std::size_t load, std::size_t component) {
  const bool turns = component == 3 || component == 5; // xs, sn
  return turns == (load == 1);
}

/// exp(ikx) -> cos(kx) of ps and pn, and sin(kx) of px: the amplitude that is there, the other part is 0.
double amplitude(Complex value, std::size_t load, std::size_t component) {
  const bool odd_in_x = component == 3 || component == 4; // xs, xn
  if (load == 0)
    return odd_in_x ? value.real() : value.imag();
  return odd_in_x ? -value.imag() : value.real();
}

double& part(Stress& stress, std::size_t component) {
  constexpr std::array<double Stress::*, 6> members{&Stress::xx, &Stress::ss, &Stress::nn,
                                                    &Stress::xs, &Stress::xn, &Stress::sn};
  return stress.*members[component];
}

/// Of one depth: for each wave the amplitudes that are even in s, and those that are odd, by load and
/// component.
struct Integrand {
  Eigen::MatrixXd even, odd; ///< [amplitude][wave]

  Integrand(double poisson, double k, double width, double depth, const std::vector<Wave>& waves)
      : even(10, static_cast<Eigen::Index>(waves.size())), odd(8, even.cols()) {
    for (Eigen::Index w = 0; w < even.cols(); ++w) {
      const auto [q, weight] = waves[static_cast<std::size_t>(w)];
      const double strip = 2 * std::sin(0.5 * q * width) / q * weight / std::numbers::pi;
      Eigen::Index even_row = 0, odd_row = 0;
      for (std::size_t load = 0; load < 3; ++load) {
        const ComplexStress at = under_wave(poisson, k, q, depth, load);
        for (std::size_t c = 0; c < at.size(); ++c)
          if (is_even(load, c)) // together with the wave of -q
            even(even_row++, w) = strip * amplitude(at[c], load, c);
          else
            odd(odd_row++, w) = strip * amplitude(Complex(0, 1) * at[c], load, c);
      }
    }
  }
};

} // namespace

std::vector<UnitStresses> strip_wave_stresses(double poisson, double k, double width, std::size_t count,
                                              std::span<const double> depths) {
  std::vector<UnitStresses> out(depths.size() * count);
  const auto places = static_cast<Eigen::Index>(count);
  for (std::size_t d = 0; d < depths.size(); ++d) {
    const std::vector<Wave> waves =
        waves_along_s(k, last_exponent / depths[d], phase_of_panel / (static_cast<double>(count) * width));
    const Integrand integrand(poisson, k, width, depths[d], waves);
    Eigen::MatrixXd cosine(integrand.even.cols(), places), sine(integrand.even.cols(), places);
    for (Eigen::Index w = 0; w < cosine.rows(); ++w) {
      const Complex step = std::polar(1.0, waves[static_cast<std::size_t>(w)].q * width);
      Complex at = 1;
      for (Eigen::Index p = 0; p < places; ++p, at *= step) {
        cosine(w, p) = at.real();
        sine(w, p) = at.imag();
      }
    }
    Eigen::MatrixXd even(integrand.even.rows(), places), odd(integrand.odd.rows(), places);
    dense_product(integrand.even, cosine, even.data());
    dense_product(integrand.odd, sine, odd.data());
    for (Eigen::Index p = 0; p < places; ++p) {
      Eigen::Index even_row = 0, odd_row = 0;
      for (std::size_t load = 0; load < 3; ++load)
        for (std::size_t c = 0; c < 6; ++c)
          part(out[d * count + static_cast<std::size_t>(p)][load], c) =
              is_even(load, c) ? even(even_row++, p) : odd(odd_row++, p);
    }
  }
  return out;
}

UnitStresses mirrored(const UnitStresses& at) {
  UnitStresses out = at;
  for (std::size_t load = 0; load < 3; ++load)
    for (std::size_t c = 0; c < 6; ++c)
      if (!is_even(load, c))
        part(out[load], c) *= -1;
  return out;
}

} // namespace bem_contact::halfspace
