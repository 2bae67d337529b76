#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

#include <utility>
#include <vector>

namespace bem_contact::contact {

/// A few further unknowns y of a system J x = r, and as many equations: J x + columns y = r, rows' x = sums.
struct Border {
  Eigen::MatrixXd columns, rows;
  Eigen::VectorXd sums;
};

struct BorderedSolution {
  Eigen::VectorXd x, y;
};

/// GCR (Eisenstat, Elman, Schultz 1983), preconditioned from the right, in single precision: what it solves
/// for is a correction, whose first digits are enough. From the same start it finds what GMRES finds.
///
/// Newton's systems J x = r differ in J, but all J are made from one matrix B, and the product B z is the
/// dear part of J z. So the last solutions and directions are kept with their products. In the next system
/// they cost no product, and every further direction is orthogonal to them (recycling: de Sturler 1996; Parks
/// et al. 2006). Keeps its memory too, so that a further solution of the same size allocates nothing.
///
/// The equations of a border hold for the start, and each direction is made such that they stay so. To that
/// end it gets a share of the preconditioner's answers to the columns.
class Gcr {
public:
  using Vector = Eigen::VectorXf;

  /// How many solutions and directions are kept for the next system.
  struct Keeps {
    int solutions, directions;
  };
  explicit Gcr(Keeps keeps) : keeps_(keeps) {}

  /// What follows has one matrix J and no borders: all directions serve all right sides, without products or
  /// images of their own.
  void keep_all_directions() { keeps_all_ = true; }
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
  /// residual fell to the tolerance, or near it and no further; the solution is the best there is in any
  /// case.
  template <class Product, class Image, class Precondition>
  bool solve(const Product& product, const Image& image, const Precondition& precondition,
             const Eigen::VectorXd& rhs, const Border& border, const Until& until,
             BorderedSolution& solution) {
    products_ = 0;
    const Eigen::Index further = border.columns.cols();
    begin(rhs, border);
    for (Eigen::Index k = 0; k < further; ++k, ++products_) {
      precondition(-columns_.col(k), answers_.col(k));
      product(answers_.col(k), b_answers_.col(k));
      image(answers_.col(k), b_answers_.col(k), image_);
      missed_.col(k) = image_ + columns_.col(k);
    }
    if (!set_start(rhs, border)) {
      finish(solution);
      return true;
    }
    if (keeps_all_)
      take_former_directions();
    while (!keeps_all_ && next_kept()) {
      constrain(true);
      try_direction(image, true);
    }
    const int most = products_ + until.products;
    for (bool found = true; found && left_ > until.tolerance && products_ < most; ++products_) {
      make_room();
      precondition(residual_, z_.col(used_));
      constrain(false);
      product(z_.col(used_), bz_.col(used_));
      found = try_direction(image, false) && !stalls(until.tolerance);
    }
    finish(solution);
    return left_ <= until.tolerance || stalled_;
  }
  /// The same without a border.
  template <class Product, class Image, class Precondition>
  bool solve(const Product& product, const Image& image, const Precondition& precondition,
             const Eigen::VectorXd& rhs, const Until& until, Eigen::VectorXd& x) {
    BorderedSolution solution{std::move(x), {}}; // its memory serves again
    const bool converged = solve(product, image, precondition, rhs, Border{}, until, solution);
    x = std::move(solution.x);
    return converged;
  }

  int products() const { return products_; } ///< of the last solution

private:
  /// False where the image of direction number `used` has too little that is new.
  template <class Image> bool try_direction(const Image& image, bool kept) {
    image(z_.col(used_), bz_.col(used_), image_);
    if (columns_.cols() > 0)
      image_ += columns_ * y_.col(used_);
    return take_image(kept);
  }
  void begin(const Eigen::VectorXd& rhs, const Border& border);
  bool set_start(const Eigen::VectorXd& rhs, const Border& border);
  void constrain(bool with_product);
  bool stalls(double tolerance);
  bool next_kept();
  void take_former_directions();
  void make_room();
  bool take_image(bool kept);
  void finish(BorderedSolution& solution);
  void keep_solution();
  void keep(int column, const Eigen::Ref<const Vector>& z, const Eigen::Ref<const Vector>& bz);

  Keeps keeps_;
  bool keeps_all_ = false;
  std::vector<int> elements_;
  Eigen::MatrixXf kept_z_, kept_bz_; ///< solutions, the oldest of which is overwritten; then directions
  std::vector<char> is_kept_;        ///< which of these columns there are
  int oldest_ = 0;
  Eigen::MatrixXf z_, bz_; ///< directions and their products,
  Eigen::MatrixXf q_;      ///< and their images made orthonormal:
  Eigen::MatrixXf h_;      ///< images = q h, with an upper triangle h
  Eigen::VectorXd g_;      ///< the residual's share of each column of q
  Vector residual_, image_, share_;
  Eigen::MatrixXf columns_, rows_; ///< of the border, over their norms
  double of_columns_ = 1, of_rows_ = 1;
  Eigen::MatrixXf y_; ///< of each direction: the further unknowns, for these columns
  /// The preconditioner's answers to the border's columns (about -J^-1 of them), their products, and what
  /// they miss: J answers + columns.
  Eigen::MatrixXf answers_, b_answers_, missed_;
  Eigen::FullPivLU<Eigen::MatrixXd> sums_; ///< of the answers
  Eigen::VectorXd start_;                  ///< the further unknowns to begin with
  double length_ = 0;                      ///< what residuals are relative to
  double left_ = 0, least_left_ = 0;       ///< of the residual; when it last fell
  int without_fall_ = 0;                   ///< products since then
  bool stalled_ = false;
  int used_ = 0, from_kept_ = 0, candidate_ = 0, products_ = 0;
};

} // namespace bem_contact::contact
