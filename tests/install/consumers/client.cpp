// Solves a scene for some forces and prints the largest pressure of each, in MPa.
#include <bem_contact/base/error.hpp>
#include <bem_contact/scene/scene_reader.hpp>
#include <bem_contact/sequence/sequence.hpp>

#include <cstdio>
#include <fstream>
#include <iterator>

int main(int argc, char** argv) {
  try {
    const std::filesystem::path file = argc > 1 ? argv[1] : "";
    std::ifstream in(file);
    bem_contact::SceneReader scene(std::string(std::istreambuf_iterator<char>(in), {}), file.string(),
                                   file.parent_path());
    bem_contact::Sequence sequence;
    for (int i = 1; i <= 3; ++i) {
      scene.set({"load.force", 1e5 / i});
      const bem_contact::SceneResult result = sequence.solve(scene.scene());
      if (!result.result.converged)
        return 3;
      std::printf("%.17g\n", largest_pressure(result.result));
    }
  } catch (const bem_contact::Error& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 1;
  }
}
