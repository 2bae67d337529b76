#include "bem_contact/app/sweep/sweep_inputs.hpp"

#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/provenance.hpp"
#include "bem_contact/base/sha256.hpp"
#include "bem_contact/influence/file_seal.hpp"
#include "bem_contact/scene/command_tables.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <iterator>

namespace bem_contact::app {

namespace {

/// The tables of cases, and the files that the lists name, with the key "rail.profile[1]" for the second of a
/// list.
std::vector<NamedFile> files_of_lists(const SweepFile& sweep) {
  std::vector<NamedFile> out = sweep.tables;
  for (const SweepFile::Axis& axis : sweep.axes)
    for (std::size_t k = 0; k < axis.values.size(); ++k)
      if (const auto* text = std::get_if<std::string>(&axis.values[k]))
        for (NamedFile& named : files_of_key(axis.key, *text, sweep.text.folder))
          if (is_regular(named.file)) {
            named.key.insert(axis.key.size(), fmt::format("[{}]", k));
            out.push_back(std::move(named));
          }
  return out;
}

} // namespace

std::set<std::string> input_paths(const SweepFile& sweep) {
  std::set<std::string> names;
  for (const std::filesystem::path& file : input_files(sweep.first_scene()))
    if (is_regular(file))
      names.insert(file.string());
  for (const NamedFile& named : files_of_lists(sweep))
    names.insert(named.file.string());
  return names;
}

std::vector<std::filesystem::path> files_read(const std::filesystem::path& file, const SweepFile& sweep) {
  const std::set<std::string> names = input_paths(sweep);
  std::vector<std::filesystem::path> files(names.begin(), names.end());
  files.push_back(file);
  return files;
}

GivenScene given_sweep(const SweepFile& sweep, const std::string& model) {
  GivenScene out{sweep.text, model, sweep.first_scene(), {}};
  out.inputs = inputs_of(out.scene);
  std::ranges::move(records_of(files_of_lists(sweep)), std::back_inserter(out.inputs));
  out.scene = with_model(std::move(out.scene), model);
  return out;
}

std::string digest_of(const SweepFile& sweep, const std::string& options) {
  std::string all = provenance("bem_contact") + "\n" + std::string(commit()) + "\n" + options + "\n" +
                    sha256(text_for(sweep.text, {"sweep"})) + "\n";
  for (const std::string& name : input_paths(sweep)) {
    const std::string seal = seal_of(name); // of an influence file
    all += (seal.empty() ? sha256_of_file(name) : sha256(seal)) + "\n";
  }
  return sha256(all);
}

} // namespace bem_contact::app
