#pragma once

#include "bem_contact/sequence/sequence.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace bem_contact {

/// A scene that Python hands over.
struct PythonScene {
  std::string text;             ///< TOML
  std::string source;           ///< of the text, for messages
  std::filesystem::path folder; ///< absolute: where relative paths start
};

/// Python's Sequence: a scene whose text was read, and whose paths were fixed, when the object was made.
///
/// After Ctrl-C the call ends at once with KeyboardInterrupt (stoppable.hpp), and the solution with its next
/// product. A call to an object that is busy waits.
class PythonSequence {
public:
  explicit PythonSequence(PythonScene scene, int threads = 1);

  /// Throws InputError, ConvergenceError, and whatever a signal handler of Python raises.
  std::shared_ptr<const SceneResult> solve(std::vector<SceneChange> changes, std::string model) const;

private:
  struct Shared { ///< with a solution that outlives the call (Ctrl-C), and perhaps this object
    PythonScene scene;
    Sequence sequence;
  };
  std::shared_ptr<Shared> shared_;
};

} // namespace bem_contact
