#pragma once

#include <cstddef>

/// What the room contact calls of FFTW, with FFTW's names and meaning, where FFTW itself is not there:
/// complex transforms of lines that lie one after the other, whose length has no prime factor but 2, 3 and 5.
/// Input and output are different memory.

constexpr int FFTW_FORWARD = -1, FFTW_BACKWARD = 1;
constexpr unsigned FFTW_ESTIMATE = 1U << 6;

#define BEM_CONTACT_FFT(Real, prefix)                                                                        \
  using prefix##complex = Real[2];                                                                           \
  struct prefix##plan_s;                                                                                     \
  using prefix##plan = prefix##plan_s*;                                                                      \
  Real* prefix##alloc_real(std::size_t n);                                                                   \
  void prefix##free(void* p);                                                                                \
  void prefix##destroy_plan(prefix##plan plan);                                                              \
  void prefix##execute_dft(prefix##plan plan, prefix##complex* in, prefix##complex* out);                    \
  prefix##plan prefix##plan_many_dft(int rank, const int* n, int howmany, prefix##complex* in,               \
                                     const int* inembed, int istride, int idist, prefix##complex* out,       \
                                     const int* onembed, int ostride, int odist, int sign, unsigned flags);
BEM_CONTACT_FFT(double, fftw_)
BEM_CONTACT_FFT(float, fftwf_)
#undef BEM_CONTACT_FFT
