#include "bem_contact/python/sequence_object.hpp"

#include "bem_contact/python/stoppable.hpp"

#include <utility>

namespace bem_contact {

namespace {

using Result = std::shared_ptr<const SceneResult>;

} // namespace

PythonSequence::PythonSequence(SceneText scene, int threads)
    : shared_(std::make_shared<Shared>(Shared{std::move(scene), Sequence({.threads = threads})})) {}

Result PythonSequence::solve(std::vector<SceneChange> changes, std::string model) const {
  return stoppable([shared = shared_, changes = std::move(changes),
                    model = std::move(model)](const std::atomic<bool>* stop) -> Result {
    const SceneFile scene = with_model(parse_scene_file(shared->text, changes), model);
    return std::make_shared<const SceneResult>(shared->sequence.solve(scene, stop));
  });
}

} // namespace bem_contact
