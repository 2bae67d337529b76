#pragma once

#include "bem_contact/sequence/plan/contact_case.hpp"
#include "bem_contact/sequence/plan/contact_estimate.hpp"
#include "bem_contact/sequence/plan/settings.hpp"
#include "bem_contact/sequence/scene_result.hpp"

#include <optional>
#include <string>
#include <utility>

namespace bem_contact {

/// How many elements in contact, kept near a number asked for or near what an accuracy needs.
///
/// The estimated discretisation error e is that of adhesion, first order, or of the normal problem, second:
/// with N elements e ~ N^-0.65 lies between. A conformal case, whose error is larger, gets more on its own.
class ElementCount {
public:
  /// `accuracy`: discretisation error wanted; 0: `elements` whatever the error. `limit`: never more; `least`:
  /// for an accuracy no fewer.
  ElementCount(int elements, double accuracy, int limit = most_elements, int least = fewest_elements);

  int wanted() const { return wanted_; }
  /// No more than this is tried: what 99 of 100 contacts need for this accuracy is less.
  int most() const { return most_; }
  /// Call it for a case that is not like the one before: the number of elements falls back to the usual one
  /// if it is larger.
  void forget();
  int least() const { return least_; } ///< fewest that are tried for an accuracy
  /// Is called after a case with `contact` elements and an estimated error (< 0: too few to estimate).
  /// Returns true where the case is to be solved again with wanted(), which is larger then.
  bool learn(int contact, double error);

private:
  double accuracy_ = 0;
  int least_ = fewest_elements;
  int usual_ = 0, most_ = 0, wanted_ = 0;
};

/// What sizes of elements a case may have.
struct ElementLimits {
  double shortest = 0;              ///< least length that the influence files serve, mm; 0: any
  double longest = longest_element; ///< length over width, at most
  int fewest = fewest_elements; ///< elements in contact that narrow rows make up for where dx is the shortest
};

/// dx and ds, mm, of which `elements` elements cover `area_ratio` times the area that the estimate predicts.
/// There are about as many along x as along s, but none is more than `limits.longest` times as long as wide.
/// Where dx is the shortest, ds is what it would be beside a shorter dx, so that there are fewer elements,
/// but not fewer than `limits.fewest` as long as ds is a quarter of dx. Otherwise both are powers of 2^(1/4),
/// so that influence numbers serve several cases.
std::pair<double, double> size_of_elements(const ContactEstimate& estimate, int elements, double area_ratio,
                                           const ElementLimits& limits);

/// Chooses dx and ds for the cases of a sequence that ask for grid.elements or grid.accuracy. It learns from
/// each case how many elements the next one needs, and how large its contact is.
class ElementSize {
public:
  /// `learn_area`: learn from each case the area in contact over the area that ContactEstimate predicts.
  explicit ElementSize(bool learn_area) : learn_area_(learn_area) {}

  /// Is called before a case. `alike`: its contact is like that of the case before, so that what was learnt
  /// holds.
  void begin(const ContactCase& asked, bool alike);
  /// The grid asked for, with the dx and ds that are chosen where the scene leaves them open.
  SceneFile::Grid grid(const ContactCase& asked) const;
  int wanted() const { return count_->wanted(); } ///< elements in contact
  /// Is called after a solution. Returns true where the case is to be solved again, on the smaller elements
  /// of grid().
  bool learn(const ContactCase& asked, const SceneResult& result);
  /// What learn() will say of this result, precise or rough.
  bool asks_for_more(const ContactCase& asked, const ContactProblem& problem,
                     const ContactResult& result) const;
  /// Says for a warning why elements of length `dx` (mm) are not made smaller.
  std::string limit(double dx) const;

private:
  struct Request {
    int elements = 0;
    double accuracy = 0;
    bool operator==(const Request&) const = default;
  };

  /// `by_elements`: the model has elements whose number matters.
  bool learn(const ContactCase& asked, const ContactProblem& problem, const ContactResult& result,
             bool by_elements);

  /// Elements in contact; where dx cannot get shorter, as many as there would be if it had followed ds.
  int counted(const ContactCase& asked, const ContactGrid& grid, int contact) const;

  bool learn_area_;
  Request request_;
  std::optional<ElementCount> count_; ///< of the request; nothing before the first case
  double shortest_ = 0;               ///< least length that the influence files serve, mm; 0: any
  double longest_ = longest_element;  ///< length over width, at most
  double area_ratio_ = 1;             ///< area in contact over the predicted one
};

} // namespace bem_contact
