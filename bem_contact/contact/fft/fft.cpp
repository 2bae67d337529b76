#include <fftw3.h>

#include "bem_contact/base/simd.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

namespace bem_contact::fft {

constexpr std::align_val_t alignment{64}; ///< bytes, a cache line
constexpr int register_size = 32;         ///< bytes, of AVX2. Narrower ones take two for one

/// Lines that are transformed side by side: they fill a register.
template <class Real> constexpr int side_by_side = register_size / static_cast<int>(sizeof(Real));

/// What is compiled anew for each kind of processor must be part of what is chosen for it.
#define BEM_CONTACT_INLINE inline __attribute__((always_inline))

/// As it is computed with, and as it lies in memory: anywhere.
template <class Real> struct Register;
template <> struct Register<float> {
  using Type __attribute__((vector_size(register_size))) = float;
  using InMemory __attribute__((vector_size(register_size), aligned(sizeof(float)), may_alias)) = float;
};
template <> struct Register<double> {
  using Type __attribute__((vector_size(register_size))) = double;
  using InMemory __attribute__((vector_size(register_size), aligned(sizeof(double)), may_alias)) = double;
};
/// The numbers from here on.
template <class Real> BEM_CONTACT_INLINE typename Register<Real>::InMemory& in_register(Real* from) {
  return *reinterpret_cast<typename Register<Real>::InMemory*>(from);
}
template <class Real>
BEM_CONTACT_INLINE const typename Register<Real>::InMemory& in_register(const Real* from) {
  return *reinterpret_cast<const typename Register<Real>::InMemory*>(from);
}

/// A square of numbers, a register for each row, with rows and columns exchanged: halves, quarters, ...
template <int Part, class V, std::size_t... lane>
BEM_CONTACT_INLINE void exchange(V* rows, std::index_sequence<lane...> lanes) {
  constexpr int count = sizeof...(lane);
  for (int i = 0; i < count; ++i)
    if ((i & Part) == 0) {
      const V a = rows[i], b = rows[i + Part];
      rows[i] = __builtin_shufflevector(a, b, ((lane & Part) == 0 ? lane : count + lane - Part)...);
      rows[i + Part] = __builtin_shufflevector(a, b, ((lane & Part) == 0 ? lane + Part : count + lane)...);
    }
  if constexpr (Part > 1)
    exchange<Part / 2>(rows, lanes);
}

/// The transform of R numbers, in place: a radix of the whole one. A number is a register of them, of as many
/// lines.
template <int R, class Real, class V> BEM_CONTACT_INLINE void small_transform(V* re, V* im) {
  if constexpr (R == 2) {
    const V r = re[1], i = im[1];
    re[1] = re[0] - r;
    im[1] = im[0] - i;
    re[0] += r;
    im[0] += i;
  } else if constexpr (R == 4) {
    const V r[4] = {re[0] + re[2], re[0] - re[2], re[1] + re[3], re[1] - re[3]},
            i[4] = {im[0] + im[2], im[0] - im[2], im[1] + im[3], im[1] - im[3]};
    re[0] = r[0] + r[2], re[1] = r[1] + i[3], re[2] = r[0] - r[2], re[3] = r[1] - i[3];
    im[0] = i[0] + i[2], im[1] = i[1] - r[3], im[2] = i[0] - i[2], im[3] = i[1] + r[3];
  } else { // odd: numbers j and R - j have conjugate factors
    static_assert(R == 3 || R == 5);
    constexpr std::array<Real, 5> cosines =
        R == 3 ? std::array<Real, 5>{1, Real(-0.5), Real(-0.5)}
               : std::array<Real, 5>{1, Real(0.30901699437494742), Real(-0.80901699437494742),
                                     Real(-0.80901699437494742), Real(0.30901699437494742)};
    constexpr std::array<Real, 5> sines =
        R == 3 ? std::array<Real, 5>{0, Real(0.86602540378443865), Real(-0.86602540378443865)}
               : std::array<Real, 5>{0, Real(0.95105651629515357), Real(0.58778525229247313),
                                     Real(-0.58778525229247313), Real(-0.95105651629515357)};
    constexpr int half = R / 2;
    V sum_re[half + 1], sum_im[half + 1], less_re[half + 1], less_im[half + 1];
    const V first_re = re[0], first_im = im[0];
    for (int j = 1; j <= half; ++j) {
      re[0] += sum_re[j] = re[j] + re[R - j];
      im[0] += sum_im[j] = im[j] + im[R - j];
      less_re[j] = re[j] - re[R - j];
      less_im[j] = im[j] - im[R - j];
    }
    for (int k = 1; k <= half; ++k) {
      V even_re = first_re, even_im = first_im, odd_re{}, odd_im{};
      for (int j = 1; j <= half; ++j) {
        const Real c = cosines[j * k % R], s = sines[j * k % R];
        even_re += c * sum_re[j];
        even_im += c * sum_im[j];
        odd_re += s * less_im[j];
        odd_im += s * less_re[j];
      }
      re[k] = even_re + odd_re;
      im[k] = even_im - odd_im;
      re[R - k] = even_re - odd_re;
      im[R - k] = even_im + odd_im;
    }
  }
}

/// Real and imaginary parts apart, so that neighbours fill a register.
template <class Real> struct Split { Real *re, *im; };

/// Of length radix * parts * run / (lines side by side).
template <class Real> struct Step {
  int radix, parts, run;
  std::vector<Real> cosines, sines; ///< [part][1 .. radix - 1]
};

/// Several lines of numbers, real and imaginary parts in turn, to be transformed to others.
template <class Real> struct Lines {
  int length, lines;
  bool backward;
  std::vector<Step<Real>> steps;
  std::vector<Real> work;
};

template <class Real> Step<Real> make_step(int radix, int parts, int run) {
  Step<Real> out{radix, parts, run, {}, {}};
  for (int p = 0; p < parts; ++p)
    for (int k = 1; k < radix; ++k) {
      const double angle = -2 * std::numbers::pi * p * k / (static_cast<double>(radix) * parts);
      out.cosines.push_back(static_cast<Real>(std::cos(angle)));
      out.sines.push_back(static_cast<Real>(std::sin(angle)));
    }
  return out;
}

template <class Real> Lines<Real> make_lines(int length, int lines, bool backward) {
  Lines<Real> out{length, lines, backward, {}, {}};
  int rest = length, run = 1;
  for (const int radix : {4, 2, 3, 5})
    for (; rest % radix == 0; rest /= radix, run *= radix)
      out.steps.push_back(make_step<Real>(radix, rest / radix, run));
  if (rest != 1)
    throw std::invalid_argument("a transform's length has a prime factor beyond 5");
  out.work.resize(std::size_t(4) * side_by_side<Real> * length);
  return out;
}

template <int R, bool turned, class Real>
BEM_CONTACT_INLINE void apply(const Step<Real>& one, const Split<Real>& from, const Split<Real>& to) {
  using V = typename Register<Real>::Type;
  const std::ptrdiff_t run = static_cast<std::ptrdiff_t>(one.run) * side_by_side<Real>,
                       apart = one.parts * run;
  for (std::ptrdiff_t p = 0; p < one.parts; ++p) {
    const Real *x = from.re + p * run, *y = from.im + p * run;
    Real *out_re = to.re + R * p * run, *out_im = to.im + R * p * run;
    const Real *c = &one.cosines[p * (R - 1)], *s = &one.sines[p * (R - 1)];
    for (std::ptrdiff_t q = 0; q < run; q += side_by_side<Real>) {
      V re[R], im[R];
      for (int j = 0; j < R; ++j) {
        re[j] = in_register(x + j * apart + q);
        im[j] = in_register(y + j * apart + q);
      }
      small_transform<R, Real>(re, im);
      in_register(out_re + q) = re[0];
      in_register(out_im + q) = im[0];
      for (int k = 1; k < R; ++k) {
        in_register(out_re + k * run + q) = turned ? re[k] * c[k - 1] - im[k] * s[k - 1] : re[k];
        in_register(out_im + k * run + q) = turned ? re[k] * s[k - 1] + im[k] * c[k - 1] : im[k];
      }
    }
  }
}

template <int R, class Real>
BEM_CONTACT_INLINE void apply(const Step<Real>& one, const Split<Real>& from, const Split<Real>& to) {
  if (one.parts == 1) // all of its factors are 1
    apply<R, false>(one, from, to);
  else
    apply<R, true>(one, from, to);
}

/// Between lines and numbers side by side, in either direction. The lines begin at line[0], line[1], ...
template <bool there, class Real, class At>
BEM_CONTACT_INLINE void turn(int length, const At* line, const Split<Real>& side) {
  using V = typename Register<Real>::Type;
  constexpr int count = side_by_side<Real>, numbers = count / 2; // of a register: as many complex ones
  int i = 0;
  for (; i + numbers <= length; i += numbers) {
    V rows[count];
    for (int k = 0; k < count; ++k)
      rows[k] = there ? in_register(line[k] + 2 * i)
                      : in_register((k % 2 ? side.im : side.re) + (i + k / 2) * count);
    exchange<count / 2>(rows, std::make_index_sequence<count>());
    for (int k = 0; k < count; ++k)
      if constexpr (there)
        in_register((k % 2 ? side.im : side.re) + (i + k / 2) * count) = rows[k];
      else
        in_register(line[k] + 2 * i) = rows[k];
  }
  for (; i < length; ++i)
    for (int k = 0; k < count; ++k)
      if constexpr (there) {
        side.re[i * count + k] = line[k][2 * i];
        side.im[i * count + k] = line[k][2 * i + 1];
      } else {
        line[k][2 * i] = side.re[i * count + k];
        line[k][2 * i + 1] = side.im[i * count + k];
      }
}

/// The transforms along lines by Stockham's method: each step reads in strides, writes in runs, and leaves
/// the numbers in order (Van Loan, Computational Frameworks for the FFT, SIAM 1992, section 1.7). `in` and
/// `out` are different memory. The way back is the way there with real and imaginary parts exchanged.
template <class Real> BEM_CONTACT_INLINE void run_lines(Lines<Real>& lines, const Real* in, Real* out) {
  constexpr int count = side_by_side<Real>;
  const std::ptrdiff_t size = static_cast<std::ptrdiff_t>(lines.length) * count;
  Real* const work = lines.work.data();
  for (int first = 0; first < lines.lines; first += count) {
    Split<Real> from{work, work + size}, to{work + 2 * size, work + 3 * size};
    const auto parts = [&] { return lines.backward ? Split<Real>{from.im, from.re} : from; };
    const Real* read[count];
    Real* written[count];
    for (int k = 0; k < count; ++k) { // where lines are missing the last one is taken again
      const std::ptrdiff_t at =
          2 * static_cast<std::ptrdiff_t>(std::min(first + k, lines.lines - 1)) * lines.length;
      read[k] = in + at;
      written[k] = out + at;
    }
    turn<true>(lines.length, read, parts());
    for (const Step<Real>& one : lines.steps) {
      one.radix == 4   ? apply<4>(one, from, to)
      : one.radix == 2 ? apply<2>(one, from, to)
      : one.radix == 3 ? apply<3>(one, from, to)
                       : apply<5>(one, from, to);
      std::swap(from, to);
    }
    turn<false>(lines.length, written, parts());
  }
}
BEM_CONTACT_WIDE void run(Lines<double>& lines, const double* in, double* out) {
  run_lines(lines, in, out);
}
BEM_CONTACT_WIDE void run(Lines<float>& lines, const float* in, float* out) {
  run_lines(lines, in, out);
}

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
    run(plan->lines, *in, *out);                                                                             \
  }                                                                                                          \
  prefix##plan prefix##plan_many_dft(int, const int* n, int howmany, prefix##complex*, const int*, int, int, \
                                     prefix##complex*, const int*, int, int, int sign, unsigned) {           \
    return new prefix##plan_s{bem_contact::fft::make_lines<Real>(*n, howmany, sign == FFTW_BACKWARD)};       \
  }
BEM_CONTACT_FFT(double, fftw_)
BEM_CONTACT_FFT(float, fftwf_)
#undef BEM_CONTACT_FFT
