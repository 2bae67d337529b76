#pragma once

#include "bem_contact/contact/problem.hpp"
#include "bem_contact/contact/result.hpp"
#include "bem_contact/contact/solver_options.hpp"

#include <array>
#include <string>
#include <vector>

namespace bem_contact::contact {

/// Joins pairs of elements in x and in s to elements twice as large; a direction of one element stays. It
/// carries grids and fields over from the fine elements to the large ones.
class LargerElements {
public:
  /// Joins the elements of the whole grid. The last row or column of an odd number is left out.
  explicit LargerElements(const ContactGrid& fine);
  /// Does the same, but an odd row or column is left out at the end that is farther from the contact (pn >
  /// 0).
  LargerElements(const ContactGrid& fine, const std::vector<double>& pn);

  /// The first of `fine_count` elements that is joined, where those of the contact are lowest .. highest.
  static int first_joined(int fine_count, int lowest, int highest) {
    return join(fine_count, lowest, highest).first;
  }

  ContactGrid grid() const;
  /// Says whether both join the same elements of a grid, wherever it lies along x.
  bool joins_like(const LargerElements& other) const { return x_ == other.x_ && s_ == other.s_; }
  /// Mean over the joined elements; fields.
  std::vector<double> mean(const std::vector<double>& field) const;
  /// The other way: linear between the centres of the large elements, and constant beyond; fields.
  std::vector<double> between(const std::vector<double>& coarse) const;
  /// Value at the new centres by cubic interpolation, linear at the ends of the grid; fields.
  std::vector<double> at_centres(const std::vector<double>& field) const;
  /// Rows at the new centres, likewise.
  std::vector<ContactRow> rows_at_centres(const std::vector<ContactRow>& rows) const;
  /// Rows with the mean position, arc length and inclination of the joined ones.
  std::vector<ContactRow> mean_rows(const std::vector<ContactRow>& rows) const;
  /// Mean over the joined rows, one value a row; empty stays empty.
  std::vector<double> mean_of_rows(const std::vector<double>& values) const;
  /// Laws of the joined rows, with means of their numbers; one law for all rows, or none, stays.
  std::vector<FallingFriction> of_rows(const std::vector<FallingFriction>& laws) const;
  /// The undeformed distance at the new centres. Elements without an opposite surface have a distance far
  /// beyond `far`, next to which a cubic would dig a hole: there it is the mean.
  std::vector<double> gap_at_centres(const std::vector<double>& gap, double far) const;
  /// Exact influence numbers: means over the joined target elements of sums over the joined loaded ones,
  /// because those of the fine elements are averages over elements. Offsets beyond the known ones are
  /// extrapolated linearly: only the first columns act over them, ahead of the grid.
  InfluenceNumbers numbers(const InfluenceNumbers& fine, bool only_normal, int threads = 1) const;

private:
  /// Fine elements of one direction: large element k joins first + factor k and the next.
  struct Joined {
    int factor = 1, first = 0, count = 0;

    bool operator==(const Joined&) const = default;
  };
  /// Weights of the fine elements first, first + 1, ... for the value at the centre of a large one.
  struct Interpolation {
    int first = 0, count = 1;
    std::array<double, 4> weight{1};
  };
  static Joined join(int fine_count, int lowest, int highest);
  static std::vector<Interpolation> centres_of(const Joined& joined, int fine_count);
  double mean_at(const std::vector<double>& field, int ix, int is) const;
  void join_pairs(const std::vector<double>& fine, double share, double* coarse) const;
  void join_distances(const std::vector<double>& fine, double share, double* coarse) const;

  ContactGrid fine_;
  Joined x_, s_;
};

/// Holds the same problem on larger elements and a guess at its solution.
struct Companion {
  ContactProblem problem;
  StartingPoint start; ///< means of the result's tractions over the joined elements
};

/// Why there is no companion: the contact touches the border of the grid, there is no contact, the grid is
/// one element, or it is a transient rolling step, which is another step on larger elements. "": there is
/// one.
std::string why_no_companion(const ContactProblem& problem, const ContactResult& result);

/// Returns the problem for the estimate of the discretisation, where why_no_companion() says nothing.
/// Undeformed distance, rigid slip and rows are taken at the new centres. It has no influence numbers: those
/// of `larger` are exact.
Companion companion_of(const ContactProblem& problem, const ContactResult& result,
                       const LargerElements& larger);

/// Returns a problem to start from: everything is a mean, and all pairs of rows at the same distance have the
/// influence numbers of the pair about the row `middle`. Only steady rolling without prescribed shear forces
/// keeps its friction. It has no influence numbers: starting_numbers() makes them.
ContactProblem starting_problem(const ContactProblem& problem);
/// The fine row about which starting_numbers() takes them: that of the smallest undeformed distance, 0 for
/// translational numbers.
int starting_row(const ContactProblem& problem);
InfluenceNumbers starting_numbers(const InfluenceNumbers& fine, const ContactGrid& coarse, int middle,
                                  bool only_normal);

} // namespace bem_contact::contact
