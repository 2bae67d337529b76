#include "bem_contact/app/sweep_inputs.hpp"

#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/provenance.hpp"
#include "bem_contact/influence/file_seal.hpp"

#include <filesystem>
#include <fmt/format.h>
#include <limits>

namespace bem_contact::app {

void check_values(const SweepFile& sweep) {
  std::set<std::size_t> cases{0};
  if (sweep.zip)
    for (std::size_t i = 0; i < sweep.size(); ++i)
      cases.insert(i);
  std::size_t stride = sweep.size();
  for (const SweepFile::Axis& axis : sweep.axes) {
    stride /= axis.values.size();
    for (std::size_t k = 0; k < axis.values.size() && !sweep.zip; ++k)
      cases.insert(k * stride);
  }
  for (const std::size_t index : cases)
    sweep.scene(index);
}

std::set<std::string> input_paths(const SweepFile& sweep) {
  std::set<std::string> names;
  for (const std::filesystem::path& file : input_files(sweep.scene(0)))
    if (is_regular(file))
      names.insert(file.string());
  for (const SweepFile::Axis& axis : sweep.axes)
    for (const SchemaValue& value : axis.values)
      if (const auto* text = std::get_if<std::string>(&value))
        if (!text->empty() && is_regular(sweep.folder / *text))
          names.insert((sweep.folder / *text).string());
  return names;
}

GivenScene given_sweep(const SweepFile& sweep, const std::string& model) {
  GivenScene out{sweep.source, sweep.text, model, sweep.folder, sweep.scene(0), {}};
  out.inputs = inputs_of(out.scene);
  for (const SweepFile::Axis& axis : sweep.axes)
    for (std::size_t k = 0; k < axis.values.size(); ++k) {
      const auto* text = std::get_if<std::string>(&axis.values[k]);
      if (text && !text->empty() && is_regular(sweep.folder / *text))
        out.inputs.push_back(
            record_of(NamedFile{fmt::format("{}[{}]", axis.key, k), *text, sweep.folder / *text}));
    }
  if (!model.empty())
    out.scene.solver.model = model_named(model);
  return out;
}

std::string digest_of(const SweepFile& sweep, const std::string& options) {
  std::string all = provenance("bem_contact") + "\n" + std::string(commit()) + "\n" + options + "\n" +
                    sha256(sweep.text) + "\n";
  for (const std::string& name : input_paths(sweep))
    all += sha256(read_text_file(name, "input", std::numeric_limits<std::size_t>::max() / 4)) + "\n";
  return sha256(all);
}

} // namespace bem_contact::app
