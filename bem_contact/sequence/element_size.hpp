#pragma once

#include "bem_contact/sequence/contact_case.hpp"
#include "bem_contact/sequence/element_count.hpp"
#include "bem_contact/sequence/scene_result.hpp"

#include <optional>
#include <string>

namespace bem_contact {

/// The largest relative error, estimated, of what the scene's grid.accuracy_of names; < 0: not estimated. An
/// error of adhesion is one of its share. What does not converge has no error: then that of the forces
/// counts.
double asked_error(const SceneFile::Grid& grid, const SceneResult& result);

/// Chooses dx and ds for the cases of a sequence that ask for grid.elements or grid.accuracy. It learns from
/// each case how many elements the next one needs, and how large its contact is.
class ElementSize {
public:
  /// `learn_area`: learn from each case the area in contact over the area that ContactEstimate predicts.
  explicit ElementSize(bool learn_area) : learn_area_(learn_area) {}

  /// Before a case. `alike`: its contact is like that of the case before, so that what was learnt holds.
  void begin(const ContactCase& asked, bool alike);
  /// The grid asked for, with the dx and ds that are chosen where the scene leaves them open.
  SceneFile::Grid grid(const ContactCase& asked) const;
  int wanted() const { return count_->wanted(); } ///< elements in contact
  /// After a solution: true where the case is to be solved again, on the smaller elements of grid().
  bool learn(const ContactCase& asked, const SceneResult& result);
  /// For a warning: why elements of length `dx` (mm) are not made smaller.
  std::string limit(double dx) const;

private:
  struct Request {
    int elements = 0;
    double accuracy = 0;
    bool operator==(const Request&) const = default;
  };

  bool learn_area_;
  Request request_;
  std::optional<ElementCount> count_; ///< of the request; nothing before the first case
  double shortest_ = 0;               ///< least length that the influence files serve, mm; 0: any
  double longest_ = longest_element;  ///< length over width, at most
  double area_ratio_ = 1;             ///< area in contact over the predicted one
};

} // namespace bem_contact
