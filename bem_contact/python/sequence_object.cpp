#include "bem_contact/python/sequence_object.hpp"

#include "bem_contact/python/stoppable.hpp"

#include <utility>

namespace bem_contact {

PythonSequence::PythonSequence(SceneText scene, int threads)
    : shared_(std::make_shared<Shared>(Shared{std::move(scene), threads, Sequence({.threads = threads})})) {}

PythonSequence::Solved PythonSequence::solve(std::vector<SceneChange> changes, std::string model) const {
  return stoppable([shared = shared_, changes = std::move(changes),
                    model = std::move(model)](const std::atomic<bool>* stop) -> Solved {
    const SceneFile scene = with_model(parse_scene_file(shared->text, changes), model);
    auto result = std::make_shared<const SceneResult>(shared->sequence.solve(scene, stop));
    return {std::move(result),
            std::make_shared<const GivenScene>(GivenScene{shared->text, model, scene, {}})};
  });
}

} // namespace bem_contact
