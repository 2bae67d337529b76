#include "bem_contact/uses/shakedown/shakedown_in_body.hpp"

#include "bem_contact/base/temporary_folder.hpp"
#include "bem_contact/inside/stresses_in_body.hpp"
#include "bem_contact/record/hdf5.hpp"
#include "bem_contact/sequence/result_file.hpp"

#include <fmt/format.h>

namespace bem_contact::shakedown {

std::vector<Shakedown> shakedown_in_body(std::span<const SceneResult> results,
                                         const std::filesystem::path& body,
                                         const ShakedownProperties& properties) {
  validate(properties);
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
