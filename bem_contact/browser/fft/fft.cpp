#include <fftw3.h>

#include <array>
#include <cmath>
#include <new>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

namespace bem_contact::fft {

/// Lines that are transformed side by side: as many floats as a register of WebAssembly has.
constexpr int side_by_side = 4;
constexpr std::align_val_t alignment{64}; ///< bytes, a cache line

/// The transform of R numbers, in place: a radix of the whole one.
template <int R, class Real> inline void small_transform(std::array<Real, R>& re, std::array<Real, R>& im) {
  if constexpr (R == 2) {
    re = {re[0] + re[1], re[0] - re[1]};
    im = {im[0] + im[1], im[0] - im[1]};
  } else if constexpr (R == 4) {
    const std::array<Real, 4> r{re[0] + re[2], re[0] - re[2], re[1] + re[3], re[1] - re[3]},
        i{im[0] + im[2], im[0] - im[2], im[1] + im[3], im[1] - im[3]};
    re = {r[0] + r[2], r[1] + i[3], r[0] - r[2], r[1] - i[3]};
    im = {i[0] + i[2], i[1] - r[3], i[0] - i[2], i[1] + r[3]};
  } else { // odd: numbers j and R - j have conjugate factors
    constexpr double pi = std::numbers::pi;
    static const auto factors = [] {
      std::array<std::pair<Real, Real>, R> out;
      for (int k = 0; k < R; ++k)
        out[k] = {static_cast<Real>(std::cos(2 * pi * k / R)), static_cast<Real>(std::sin(2 * pi * k / R))};
      return out;
    }();
    const auto a = re, b = im;
    for (int j = 1; j <= R / 2; ++j) {
      re[0] += a[j] + a[R - j];
      im[0] += b[j] + b[R - j];
    }
    for (int k = 1; k <= R / 2; ++k) {
      Real even_re = a[0], even_im = b[0], odd_re = 0, odd_im = 0;
      for (int j = 1; j <= R / 2; ++j) {
        const auto [c, s] = factors[j * k % R];
        even_re += c * (a[j] + a[R - j]);
        even_im += c * (b[j] + b[R - j]);
        odd_re += s * (b[j] - b[R - j]);
        odd_im -= s * (a[j] - a[R - j]);
      }
      re[k] = even_re + odd_re;
      im[k] = even_im + odd_im;
      re[R - k] = even_re - odd_re;
      im[R - k] = even_im - odd_im;
    }
  }
}

/// Real and imaginary parts apart, so that neighbours fill a register.
template <class Real> struct Split { Real *re, *im; };

/// The transforms along lines by Stockham's method: each step reads in strides, writes in runs, and leaves
/// the numbers in order (Van Loan, Computational Frameworks for the FFT, SIAM 1992, section 1.7).
template <class Real> class Lines {
public:
  Lines(int length, int lines, bool backward) : length_(length), lines_(lines), backward_(backward) {
    int rest = length, run = 1;
    for (const int radix : {4, 2, 3, 5})
      for (; rest % radix == 0; rest /= radix, run *= radix)
        steps_.push_back(step(radix, rest / radix, run));
    if (rest != 1)
      throw std::invalid_argument("a transform's length has a prime factor beyond 5");
    work_.resize(std::size_t(4) * side_by_side * length);
  }

  void run(const Real* in, Real* out) {
    int line = 0;
    for (; line + side_by_side <= lines_; line += side_by_side)
      run<side_by_side>(in + 2 * offset(line), out + 2 * offset(line));
    for (; line < lines_; ++line)
      run<1>(in + 2 * offset(line), out + 2 * offset(line));
  }

private:
  struct Step {
    int radix, parts, run;
    std::vector<Real> cosines, sines; ///< [part][1 .. radix - 1]
  };

  static Step step(int radix, int parts, int run) {
    Step out{radix, parts, run, {}, {}};
    for (int p = 0; p < parts; ++p)
      for (int k = 1; k < radix; ++k) {
        const double angle = -2 * std::numbers::pi * p * k / (static_cast<double>(radix) * parts);
        out.cosines.push_back(static_cast<Real>(std::cos(angle)));
        out.sines.push_back(static_cast<Real>(std::sin(angle)));
      }
    return out;
  }

  std::ptrdiff_t offset(int line) const { return static_cast<std::ptrdiff_t>(line) * length_; }

  /// `in` and `out` alternate real and imaginary parts. The way back is the way there with the two exchanged.
  template <int Count> void run(const Real* in, Real* out) {
    const std::ptrdiff_t size = offset(Count);
    Split<Real> from{work_.data(), work_.data() + size}, to{from.im + size, from.im + 2 * size};
    const auto parts = [&] { return backward_ ? std::pair(from.im, from.re) : std::pair(from.re, from.im); };
    {
      const auto [re, im] = parts();
      for (int line = 0; line < Count; ++line)
        for (int i = 0; i < length_; ++i) {
          re[i * Count + line] = in[2 * (offset(line) + i)];
          im[i * Count + line] = in[2 * (offset(line) + i) + 1];
        }
    }
    for (const Step& one : steps_) {
      const std::ptrdiff_t run = static_cast<std::ptrdiff_t>(one.run) * Count;
      one.radix == 4   ? apply<4>(one, run, from, to)
      : one.radix == 2 ? apply<2>(one, run, from, to)
      : one.radix == 3 ? apply<3>(one, run, from, to)
                       : apply<5>(one, run, from, to);
      std::swap(from, to);
    }
    const auto [re, im] = parts();
    for (int line = 0; line < Count; ++line)
      for (int i = 0; i < length_; ++i) {
        out[2 * (offset(line) + i)] = re[i * Count + line];
        out[2 * (offset(line) + i) + 1] = im[i * Count + line];
      }
  }

  template <int R>
  static void apply(const Step& one, std::ptrdiff_t run, const Split<Real>& from, const Split<Real>& to) {
    for (std::ptrdiff_t p = 0; p < one.parts; ++p) {
      const Real* __restrict x = from.re + p * run, * __restrict y = from.im + p * run;
      Real* __restrict out_re = to.re + R * p * run, * __restrict out_im = to.im + R * p * run;
      const Real *c = &one.cosines[p * (R - 1)], *s = &one.sines[p * (R - 1)];
      for (std::ptrdiff_t q = 0; q < run; ++q) {
        std::array<Real, R> re, im;
        for (int j = 0; j < R; ++j) {
          re[j] = x[one.parts * j * run + q];
          im[j] = y[one.parts * j * run + q];
        }
        small_transform<R>(re, im);
        out_re[q] = re[0];
        out_im[q] = im[0];
        for (int k = 1; k < R; ++k) {
          out_re[k * run + q] = re[k] * c[k - 1] - im[k] * s[k - 1];
          out_im[k * run + q] = re[k] * s[k - 1] + im[k] * c[k - 1];
        }
      }
    }
  }

  int length_, lines_;
  bool backward_;
  std::vector<Step> steps_;
  std::vector<Real> work_;
};

} // namespace bem_contact::fft

#define BEM_CONTACT_FFT(Real, prefix)                                                                        \
  struct prefix##plan_s {                                                                                    \
    bem_contact::fft::Lines<Real> lines;                                                                     \
  };                                                                                                         \
  Real* prefix##alloc_real(std::size_t n) {                                                                  \
    return static_cast<Real*>(::operator new(n * sizeof(Real), bem_contact::fft::alignment));                \
  }                                                                                                          \
  void prefix##free(void* p) {                                                                               \
    ::operator delete(p, bem_contact::fft::alignment);                                                       \
  }                                                                                                          \
  void prefix##destroy_plan(prefix##plan plan) {                                                             \
    delete plan;                                                                                             \
  }                                                                                                          \
  void prefix##execute_dft(prefix##plan plan, prefix##complex* in, prefix##complex* out) {                   \
    plan->lines.run(*in, *out);                                                                              \
  }                                                                                                          \
  prefix##plan prefix##plan_many_dft(int, const int* n, int howmany, prefix##complex*, const int*, int, int, \
                                     prefix##complex*, const int*, int, int, int sign, unsigned) {           \
    return new prefix##plan_s{{*n, howmany, sign == FFTW_BACKWARD}};                                         \
  }
BEM_CONTACT_FFT(double, fftw_)
BEM_CONTACT_FFT(float, fftwf_)
