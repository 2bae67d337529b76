#include "bem_contact/uses/sweep/sweep_inputs.hpp"

#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/provenance.hpp"
#include "bem_contact/base/sha256.hpp"
#include "bem_contact/influence/file_seal.hpp"
#include "bem_contact/scene/command_tables.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>

namespace bem_contact {

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

namespace {

constexpr const char* origins_group = "made_from/";

/// Nothing where it has none.
Origins origins_in(const H5Reader& file) {
  const H5Table group = file.group("made_from");
  Origins out;
  for (int i = 0;; ++i) {
    const std::string name = text_attribute(group, fmt::format("{:04}/name", i));
    if (name.empty())
      return out;
    out[name] = text_attribute(group, fmt::format("{:04}/value", i));
  }
}

std::string difference(const std::string& name, const std::string* then, const std::string* now) {
  if (name == "program" && then && now)
    return fmt::format("it was made by {}, and this is {}", *then, *now);
  if (name == "options" && then && now)
    return fmt::format("its options were '{}', and are '{}'", *then, *now);
  if (name == "scene")
    return "the scene has changed";
  return fmt::format("the file '{}' {}", name,
                     !then  ? "was not read then"
                     : !now ? "is not read now"
                            : "has changed");
}

} // namespace

std::set<std::string> named_inputs(const SceneText& given) {
  std::set<std::string> names;
  const auto add = [&](const std::vector<NamedFile>& files) {
    for (const NamedFile& named :
         files) // a standard profile has no file, and an influence file may come later
      if (names_influence(named.key) || is_regular(named.file))
        names.insert(named.file.string());
  };
  const auto add_lists = [&](const SweepFile& sweep) {
    add(sweep.tables);
    for (const SweepFile::Axis& axis : sweep.axes)
      for (const SchemaValue& value : axis.values)
        if (const auto* text = std::get_if<std::string>(&value))
          add(files_of_key(axis.key, *text, given.folder));
  };
  if (has_sweep(given)) {
    const SweepFile sweep = parse_sweep_file(given);
    add(named_files(sweep.first_scene()));
    add_lists(sweep);
  } else
    add(named_files(parse_scene_file(given)));
  if (has_sweep(given, "table"))
    add_lists(parse_sweep_file(given, "table"));
  for (const std::string_view table : command_tables)
    for (const std::string& file : files_of_table(given, table))
      names.insert(file);
  return names;
}

Origins origins_of(const SweepFile& sweep, const std::string& options) {
  Origins out{{"program", fmt::format("{} (commit {})", provenance("bem_contact"), commit())},
              {"options", options},
              {"scene", sha256(text_for(sweep.text, {"sweep", "passage", "replay"}, {"replay.jobs"}))}};
  for (const std::string& name : input_paths(sweep)) {
    const std::string seal = seal_of(name); // of an influence file
    const std::filesystem::path seen = std::filesystem::path(name).lexically_proximate(sweep.text.folder);
    out["./" + seen.string()] = seal.empty() ? sha256_of_file(name) : sha256(seal);
  }
  return out;
}

std::string digest_of(const Origins& origins) {
  std::string all;
  for (const auto& [name, value] : origins)
    all += value + "\n";
  return sha256(all);
}

std::string digest_of(const SweepFile& sweep, const std::string& options) {
  return digest_of(origins_of(sweep, options));
}

void add_origins(H5Table& table, const Origins& origins) {
  int i = 0;
  for (const auto& [name, value] : origins) {
    const std::string group = fmt::format("{}{:04}/", origins_group, i++);
    table.attributes[group + "name"] = name;
    table.attributes[group + "value"] = value;
  }
}

std::string what_changed(const H5Reader& file, const Origins& now) {
  const Origins then = origins_in(file);
  std::vector<std::string> found;
  if (!then.empty()) {
    std::set<std::string> names;
    for (const Origins* all : {&then, &now})
      for (const auto& [name, value] : *all)
        names.insert(name);
    for (const std::string& name : names) {
      const auto a = then.find(name), b = now.find(name);
      const std::string *before = a == then.end() ? nullptr : &a->second,
                        *after = b == now.end() ? nullptr : &b->second;
      if (!before || !after || *before != *after)
        found.push_back(difference(name, before, after));
    }
  }
  return found.empty() ? digest_changed : fmt::format("{}", fmt::join(found, "; "));
}

} // namespace bem_contact
