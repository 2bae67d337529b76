// Solves a scene for some forces and prints the largest pressure of each, in MPa.
#include <bem_contact/base/error.hpp>
#include <bem_contact/scene/scene_reader.hpp>
#include <bem_contact/sequence/sequence.hpp>

#include <cstdio>

int main(int argc, char** argv) {
  try {
    bem_contact::SceneReader scene(bem_contact::read_scene_text(argc > 1 ? argv[1] : ""));
    bem_contact::Sequence sequence;
    for (int i = 1; i <= 3; ++i) {
      scene.set({"load.force", 1e5 / i});
      const bem_contact::SceneResult result = sequence.solve(scene.scene());
      if (!result.result.certified())
        return 3;
      std::printf("%.17g\n", result.result.totals.pmax.value);
    }
  } catch (const bem_contact::Error& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 1;
  }
}
