#pragma once

#include "bem_contact/sequence/contact_estimate.hpp"
#include "bem_contact/sequence/settings.hpp"

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
  /// For a case that is nothing like the one before: no more elements than are usual.
  void forget();
  /// After a case with `contact` elements and an estimated error (< 0: too few to estimate). True where the
  /// case is to be solved again with wanted(), which is larger then.
  bool learn(int contact, double error);

private:
  double accuracy_ = 0;
  int least_ = fewest_elements;
  int usual_ = 0, most_ = 0, wanted_ = 0;
};

/// Elements of a size that `elements` of them cover an area like the estimate's, `area_ratio` times as large,
/// about as many along x as along s, but none more than `longest` times as long as wide: dx, not below
/// `shortest`, and ds, not below a quarter of it, mm. Powers of 2^(1/4) else, so that numbers serve several
/// cases.
std::pair<double, double> size_of_elements(const ContactEstimate& estimate, int elements, double area_ratio,
                                           double shortest, double longest);

} // namespace bem_contact
