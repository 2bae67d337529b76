#pragma once

#include "bem_contact/sequence/scene_record.hpp"
#include "bem_contact/sequence/sequence.hpp"

#include <memory>
#include <string>
#include <vector>

namespace bem_contact {

/// Python's Sequence: a scene whose text was read, and whose paths were fixed, when the object was made.
///
/// After Ctrl-C the call ends at once with KeyboardInterrupt (stoppable.hpp), and the solution with its next
/// product. A call to an object that is busy waits.
class PythonSequence {
public:
  explicit PythonSequence(SceneText scene, int threads = 1);

  /// A result, and the scene that was solved.
  struct Solved {
    std::shared_ptr<const SceneResult> result;
    std::shared_ptr<const GivenScene> given;
  };
  /// Throws InputError, ConvergenceError, and whatever a signal handler of Python raises.
  Solved solve(std::vector<SceneChange> changes, std::string model) const;

  const SceneText& text() const { return shared_->text; }
  int threads() const { return shared_->threads; }

private:
  struct Shared { ///< with a solution that outlives the call (Ctrl-C), and perhaps this object
    SceneText text;
    int threads;
    Sequence sequence;
  };
  std::shared_ptr<Shared> shared_;
};

} // namespace bem_contact
