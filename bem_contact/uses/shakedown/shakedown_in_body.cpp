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

namespace {

std::vector<Shakedown> by_influence_file(std::span<const SceneResult> results,
                                         const std::filesystem::path& path,
                                         const ShakedownProperties& properties, int threads) {
  const inside::FileOfStresses file(path);
  std::vector<Shakedown> out(results.size());
  in_parts(threads, static_cast<int>(results.size()), [&](int first, int end, int) {
    for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(end); ++i)
      out[i] = shakedown_of(inside::stresses_by_file(result_file(results[i]), file), properties);
  });
  return out;
}

} // namespace

std::vector<Shakedown> shakedown_in_body(std::span<const SceneResult> results,
                                         const std::filesystem::path& body,
                                         const ShakedownProperties& properties, int threads) {
  validate(properties);
  if (begins_with_seal(body))
    return by_influence_file(results, body, properties, threads);
  const TemporaryFolder folder;
  std::vector<std::filesystem::path> files;
  for (const SceneResult& result : results) {
    files.push_back(folder / fmt::format("result_{}.h5", files.size()));
    record::write_hdf5(files.back(), result_file(result));
  }
  std::vector<Shakedown> out(results.size());
  inside::stresses_in_body(files, body, "", [&](std::size_t i, const inside::StressesInside& stresses) {
    out[i] = shakedown_of(stresses, properties);
  });
  return out;
}

} // namespace bem_contact::shakedown
