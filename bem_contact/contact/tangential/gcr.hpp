#pragma once

#include <Eigen/Core>

#include <vector>

namespace bem_contact::contact {

/// GCR (Eisenstat, Elman, Schultz 1983), preconditioned from the right, in single precision: what it solves
/// for is a correction, whose first digits are enough. From the same start it finds what GMRES finds.
///
/// Newton's systems J x = r differ in J, but all J are made from one matrix B, and the product B z is the
/// dear part of J z. So the last solutions and directions are kept with their products. In the next system
/// they cost no product, and every further direction is orthogonal to them (recycling: de Sturler 1996; Parks
/// et al. 2006). Keeps its memory too, so that a further solution of the same size allocates nothing.
class Gcr {
public:
  using Vector = Eigen::VectorXf;

  /// How many solutions and directions are kept for the next system.
  struct Keeps {
    int solutions, directions;
  };
  explicit Gcr(Keeps keeps) : keeps_(keeps) {}

  /// Keeps nothing of what was solved so far.
  void forget();
  /// What follows is solved with the matrix B of these elements. What was kept with another one is forgotten.
  void use_elements(const std::vector<int>& elements);

  /// When solve() ends.
  struct Until {
    double tolerance; ///< of the residual, over |rhs|
    int products;     ///< at most so many
  };

  /// product(z, Bz), image(z, Bz, Jz) and precondition(v, out) write Vectors of rhs's size. True when the
  /// residual fell to the tolerance, or near it and no further; x is the best there is in any case.
  template <class Product, class Image, class Precondition>
  bool solve(const Product& product, const Image& image, const Precondition& precondition,
             const Eigen::VectorXd& rhs, const Until& until, Eigen::VectorXd& x) {
    const double length = rhs.norm();
    x.setZero(rhs.size());
    products_ = 0;
    if (length == 0)
      return true;
    begin(rhs, length);
    while (next_kept())
      try_direction(image, true);
    for (bool found = true; found && left_ > until.tolerance && products_ < until.products; ++products_) {
      make_room();
      precondition(residual_, z_.col(used_));
      product(z_.col(used_), bz_.col(used_));
      found = try_direction(image, false) && !stalls(until.tolerance);
    }
    finish(length, x);
    return left_ <= until.tolerance || stalled_;
  }

  int products() const { return products_; } ///< of the last solution

private:
  /// False where the image of direction number `used` has too little that is new.
  template <class Image> bool try_direction(const Image& image, bool kept) {
    image(z_.col(used_), bz_.col(used_), image_);
    return take_image(kept);
  }
  void begin(const Eigen::VectorXd& rhs, double length);
  bool stalls(double tolerance);
  bool next_kept();
  void make_room();
  bool take_image(bool kept);
  void finish(double length, Eigen::VectorXd& x);
  void keep(int column, const Eigen::Ref<const Vector>& z, const Eigen::Ref<const Vector>& bz);

  Keeps keeps_;
  std::vector<int> elements_;
  Eigen::MatrixXf kept_z_, kept_bz_; ///< solutions, the oldest of which is overwritten; then directions
  std::vector<char> is_kept_;        ///< which of these columns there are
  int oldest_ = 0;
  Eigen::MatrixXf z_, bz_; ///< directions and their products,
  Eigen::MatrixXf q_;      ///< and their images made orthonormal:
  Eigen::MatrixXf h_;      ///< images = q h, with an upper triangle h
  Eigen::VectorXd g_;      ///< the residual's share of each column of q
  Vector residual_, image_, share_;
  double left_ = 0, least_left_ = 0; ///< of the residual; when it last fell
  int without_fall_ = 0;             ///< products since then
  bool stalled_ = false;
  int used_ = 0, from_kept_ = 0, candidate_ = 0, products_ = 0;
};

} // namespace bem_contact::contact
