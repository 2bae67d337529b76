#pragma once

namespace bem_contact::contact {

/// Real rows of n elements in pairs. A pair goes through one complex transform, the first row as its real
/// part and the second as its imaginary part. These are frequencies from .. to - 1 of them. Complex numbers
/// are two reals here.
struct RowPairs {
  int n, pairs, from, to; ///< n is even, to <= n / 2 + 1
  int stride;             ///< complex numbers from one frequency to the next, where rows are apart
};

/// Frequencies that are exchanged at once, so that what lies far apart stays in the cache: 8 complex floats
/// are a cache line.
constexpr int exchanged_together = 8;

/// The spectra of both rows of each pair, from the spectra of the pairs: z [pairs][n] to
/// out [k - from][row].
void separate(const RowPairs& rows, const double* z, double* out);
void separate(const RowPairs& rows, const float* z, float* out);

/// The way back.
void join(const RowPairs& rows, const double* in, double* z);
void join(const RowPairs& rows, const float* in, float* z);

} // namespace bem_contact::contact
