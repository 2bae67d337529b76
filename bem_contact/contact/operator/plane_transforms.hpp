#pragma once

#include "bem_contact/contact/operator/fft.hpp"
#include "bem_contact/contact/operator/settings.hpp"
#include "bem_contact/contact/operator/strip_transforms.hpp"

#include <complex>
#include <list>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

namespace bem_contact::contact {

/// Lengths of the transforms of a plane, and how many fields go through them at once.
struct PlaneShape {
  int length_x = 0, length_s = 0;
  int lines = 0; ///< rows of a field, at least: a whole multiple of PlaneShape::step
  int inputs = 1, outputs = 1;

  static constexpr int step = 4;
  bool operator==(const PlaneShape&) const = default;
  int frequencies() const { return length_x / 2 + 1; } ///< along x
};

/// Even lengths, at least these, for which the transforms of `lines` rows, along x in pairs and then along s,
/// cost least.
std::pair<int, int> good_lengths(int least_x, int least_s, int lines);

/// The transforms of fields [..][lines][length_x], and the order in which a product works on scratch memory.
/// Operators of the same shape share them, one after the other.
///
/// Along x two rows are transformed as the real and the imaginary part of one: FFTW does complex transforms
/// line by line fastest, and it remembers its plan for a length, whatever the number of lines. One thread
/// does it all: a second one needs what the first has in its cache, and made products of 30,000 elements
/// slower.
template <class Real> class PlaneTransforms {
public:
  using Complex = std::complex<Real>;
  using Shape = PlaneShape;
  PlaneTransforms(const PlaneShape& shape, std::shared_ptr<Scratch> scratch);

  const PlaneShape shape;

  void begin_product();

  /// Two rows of a field, 2 `pair` and the next, element by element in turn; length_x of each.
  Real* rows_in(int input, int pair) { return rows(first_, input, pair); }
  const Real* rows_out(int output, int pair) const { return rows(second_, output, pair); }
  /// Frequencies along x that are transformed along s at once: as many as stay in the cache; fewer at the
  /// end.
  struct Group {
    int first = 0, count = 0;
    Complex* in = nullptr;  ///< [count][input][length_s]
    Complex* out = nullptr; ///< [count][output][length_s]
  };
  int groups() const { return (shape.frequencies() + together_ - 1) / together_; }

  void forward();                            ///< rows_in to spectra along x
  Group forward_s(int group) const;          ///< those of the frequencies of a group to Group::in
  void backward_s(const Group& group) const; ///< Group::out to spectra along x
  void backward();                           ///< those to rows_out, times both lengths

  /// kernel [length_s][length_x] to symbol [frequency], each frequency's length_s values `stride` after those
  /// of the one before.
  Real* kernel();
  void transform_kernel(Complex* symbol, std::ptrdiff_t stride);
  /// Takes real spectra [frequency][length_s] of kernels even in x and gives those of their halves behind, in
  /// which what lies at 0 and at the far end counts half; until the next kernel or product.
  const Complex* half_behind(const std::vector<Real>& spectra);

private:
  struct ColumnPlans {
    FftPlan<Real> forward, backward;
  };
  Real* rows(Real* space, int field, int pair) const {
    return space + 2 * (static_cast<std::size_t>(field) * shape.lines / 2 + pair) * shape.length_x;
  }
  FftPlan<Real> plan(int length, int lines, int sign) const;
  void run(const FftPlan<Real>& plan, Real* from, Real* to) const;
  const ColumnPlans& column_plans(int count) const { return count == together_ ? whole_ : rest_; }
  void make_product_plans();

  int together_ = 1;
  std::size_t space_size_ = 0, column_size_ = 0, kernel_size_ = 0; ///< reals
  std::shared_ptr<Scratch> scratch_;
  /// rows_in, then the spectra of the result; the spectra of rows_in, then rows_out. So no transform is in
  /// place: FFTW plans and does those in twice the time. For the same reason there are two blocks of
  /// columns, one after the other. Kernels go to and fro between `first_` and `second_` as well.
  Real *first_ = nullptr, *second_ = nullptr, *columns_ = nullptr;
  FftPlan<Real> x_forward_, x_backward_;
  ColumnPlans whole_, rest_; ///< of `together_` frequencies, and of the last group
  FftPlan<Real> kernel_x_, kernel_s_;
};

/// Keeps transforms of planes and strips, the last used first, and the memory in which they all work. All
/// operators that share one pool serve one thread at a time.
class TransformPool {
public:
  /// `threads`: how many work on one product with numbers that depend on both rows (base/parallel.hpp).
  explicit TransformPool(int threads = 1) : threads_(threads) {}

  int threads() const { return threads_; }
  const std::shared_ptr<Scratch>& scratch() const { return scratch_; }
  /// `Transforms`: PlaneTransforms or StripTransforms, of either precision.
  template <class Transforms> std::shared_ptr<Transforms> get(const typename Transforms::Shape& shape) {
    auto& list = std::get<List<Transforms>>(lists_);
    for (auto it = list.begin(); it != list.end(); ++it)
      if ((*it)->shape == shape) {
        list.splice(list.begin(), list, it);
        return list.front();
      }
    list.push_front(std::make_shared<Transforms>(shape, scratch_));
    if (list.size() > std::size_t(most_transforms))
      list.pop_back(); // those who use it keep it
    return list.front();
  }

private:
  template <class Transforms> using List = std::list<std::shared_ptr<Transforms>>;
  int threads_;
  std::shared_ptr<Scratch> scratch_ = std::make_shared<Scratch>();
  std::tuple<List<PlaneTransforms<float>>, List<PlaneTransforms<double>>, List<StripTransforms<float>>,
             List<StripTransforms<double>>>
      lists_;
};

extern template class PlaneTransforms<double>;
extern template class PlaneTransforms<float>;

} // namespace bem_contact::contact
