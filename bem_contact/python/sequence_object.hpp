#pragma once

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

  /// Throws InputError, ConvergenceError, and whatever a signal handler of Python raises.
  std::shared_ptr<const SceneResult> solve(std::vector<SceneChange> changes, std::string model) const;

private:
  struct Shared { ///< with a solution that outlives the call (Ctrl-C), and perhaps this object
    SceneText text;
    Sequence sequence;
  };
  std::shared_ptr<Shared> shared_;
};

} // namespace bem_contact
