#include "bem_contact/uses/shakedown/shakedown_in_body.hpp"

#include "bem_contact/base/parallel.hpp"
#include "bem_contact/base/temporary_folder.hpp"
#include "bem_contact/influence/file_seal.hpp"
#include "bem_contact/inside/stresses_by_file.hpp"
#include "bem_contact/inside/stresses_in_body.hpp"
#include "bem_contact/record/hdf5.hpp"
#include "bem_contact/sequence/result_file.hpp"

#include <fmt/format.h>

namespace bem_contact::shakedown {

void for_each_in_body(std::span<const SceneResult> results, const std::filesystem::path& body, int threads,
                      const UseOfStresses& use) {
  if (begins_with_seal(body)) {
    const inside::FileOfStresses file(body);
    in_parts(threads, static_cast<int>(results.size()), [&](int first, int end, int) {
      for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(end); ++i)
        use(i, inside::stresses_by_file(result_file(results[i]), file));
    });
    return;
  }
  const TemporaryFolder folder;
  std::vector<std::filesystem::path> files;
  for (const SceneResult& result : results) {
    files.push_back(folder / fmt::format("result_{}.h5", files.size()));
    record::write_hdf5(files.back(), result_file(result));
  }
  inside::stresses_in_body(files, body, "",
                           [&](std::size_t i, const inside::StressesInside& stresses) { use(i, stresses); });
}

std::vector<Shakedown> shakedown_in_body(std::span<const SceneResult> results,
                                         const std::filesystem::path& body,
                                         const ShakedownProperties& properties, int threads) {
  validate(properties);
  std::vector<Shakedown> out(results.size());
  for_each_in_body(results, body, threads, [&](std::size_t i, const inside::StressesInside& stresses) {
    out[i] = shakedown_of(stresses, properties);
  });
  return out;
}

} // namespace bem_contact::shakedown
