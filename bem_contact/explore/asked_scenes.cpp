#include "bem_contact/explore/asked_scenes.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/sha256.hpp"
#include "bem_contact/explore/changed_text.hpp"
#include "bem_contact/explore/settings.hpp"
#include "bem_contact/profile/standard_profiles.hpp"
#include "bem_contact/scene/directly_named.hpp"

#include <algorithm>
#include <cstdint>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace bem_contact::explore {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

[[noreturn]] void refuse_question(const std::string& why) {
  throw InputError("The page's question cannot be read", why, "Load the page again.");
}

SchemaValue value_of(const json& value) {
  if (value.is_boolean())
    return value.get<bool>();
  const bool too_large = value.is_number_unsigned() && value.get<std::uint64_t>() > INT64_MAX;
  if (value.is_number_integer() && !too_large)
    return value.get<std::int64_t>();
  if (value.is_number())
    return value.get<double>();
  if (value.is_string())
    return value.get<std::string>();
  refuse_question("a value is no number, flag or text");
}

/// The same for each way to write a path.
fs::path plain(const fs::path& file) {
  std::error_code problem;
  fs::path whole = fs::weakly_canonical(file, problem);
  return problem ? fs::absolute(file).lexically_normal() : whole;
}

/// Files: a wheelset has four profiles, and a question of another window may be read at the same time.
/// Chosen.
constexpr std::size_t most_of_a_question = 16;

/// "FILE#2" is a part of FILE.
std::string without_part(const std::string& key, const std::string& name) {
  return names_profile(key) ? name.substr(0, name.rfind('#')) : name;
}

} // namespace

Question parse_question(const std::string& text) {
  const json asked = json::parse(text, nullptr, false);
  if (!asked.is_object() || !asked.contains("text") || !asked["text"].is_string())
    refuse_question("it is no JSON object with a text");
  Question out{.text = asked["text"]};
  const auto entries_of = [&](const char* name) {
    const json entries = asked.value(name, json::object());
    if (!entries.is_object())
      refuse_question(fmt::format("its {} are no object", name));
    return entries;
  };
  const json changes = entries_of("changes"), files = entries_of("files");
  for (const auto& [key, value] : changes.items())
    out.changes.push_back({key, value_of(value)});
  for (const auto& [name, content] : files.items()) {
    if (!content.is_string())
      refuse_question("a file has no text");
    out.files.emplace(name, content.get<std::string>());
  }
  if (const auto window = asked.find("window"); window != asked.end() && window->is_string())
    out.window = window->get<std::string>().substr(0, 64);
  return out;
}

AskedScenes::AskedScenes(const Start& start) : source_(start.scene.source), folder_(start.scene.folder) {
  try {
    for (const NamedFile& named : named_files(parse_scene_file(start.scene, start.changes)))
      if (!start.files.contains(without_part(named.key, named.name)))
        readable_.insert(plain(named.file));
  } catch (const InputError&) { // the page says what is wrong; then nothing is readable
  }
}

SceneText AskedScenes::text_of(const Question& question) const {
  return {question.text, source_, folder_};
}

fs::path AskedScenes::copy_of(const std::string& name, const std::string& content) {
  const std::scoped_lock lock(writing_);
  const fs::path place = fs::path(sha256(content).substr(0, 16)) / fs::path(name).filename();
  if (const auto before = std::ranges::find(written_, place, &Copy::place); before != written_.end())
    written_.splice(written_.begin(), written_, before);
  else {
    copies_.write(place, content);
    written_.push_front({place, content.size()});
    forget_old_copies();
  }
  return copies_ / place;
}

/// Those of this question were used last.
void AskedScenes::forget_old_copies() {
  std::size_t bytes = 0;
  for (const Copy& copy : written_)
    bytes += copy.bytes;
  while (bytes > most_dropped && written_.size() > most_of_a_question) {
    std::error_code ignored;
    fs::remove(copies_ / written_.back().place, ignored);
    bytes -= written_.back().bytes;
    written_.pop_back();
  }
}

void AskedScenes::hold(const std::string& name, const fs::path& file) {
  const std::scoped_lock lock(writing_);
  ours_[name] = file;
}

std::optional<fs::path> AskedScenes::of_ours(const std::string& name) {
  const std::scoped_lock lock(writing_);
  const auto found = ours_.find(name);
  return found == ours_.end() ? std::nullopt : std::optional(found->second);
}

void AskedScenes::require_readable(const NamedFile& file) const {
  const bool bare = file.name.find_first_of("./") == std::string::npos;
  if (!readable_.contains(plain(file.file)) && names_profile(file.key) && bare)
    throw InputError(fmt::format("Unknown profile '{}'", file.name),
                     "it is no standard's name, and no profile of this name was dropped on this page",
                     advice_on_name(file.name));
  if (!readable_.contains(plain(file.file)))
    throw InputError(
        fmt::format("The file '{}' is not read", file.name),
        fmt::format("{} names it; this page reads the files of the scene that it was started with, "
                    "standard profiles, and profiles dropped on it",
                    file.key),
        "Drop the file on the page, or start bem_contact explore with a scene that names it.");
}

SceneReader AskedScenes::reader_of(const Question& question) const {
  SceneReader reader(text_of(question));
  for (const SceneChange& change : question.changes)
    reader.set(change);
  return reader;
}

std::vector<NamedFile> AskedScenes::names(const Question& question) const {
  std::vector<NamedFile> out;
  for (NamedFile& named : directly_named(reader_of(question).scene()))
    if (!names_profile(named.key) || !is_standard_profile(named.name)) {
      named.name = without_part(named.key, named.name);
      out.push_back(std::move(named));
    }
  return out;
}

SceneFile AskedScenes::scene(const Question& question) {
  SceneReader reader = reader_of(question);
  // Names alone: a body file is not opened before it is known that it may be.
  for (const NamedFile& named : directly_named(reader.scene())) {
    const std::string name = without_part(named.key, named.name);
    if (names_profile(named.key) && is_standard_profile(named.name))
      continue;
    if (const auto held = question.files.find(name); held != question.files.end())
      reader.set({named.key, copy_of(name, held->second).string() + named.name.substr(name.size())});
    else if (const auto own = of_ours(name))
      reader.set({named.key, own->string()});
    else
      require_readable(named);
  }
  SceneFile scene = reader.scene();
  for (const NamedFile& named : named_files(scene)) // with those that body files name
    if (named.key.ends_with(".body.profile"))
      require_readable(named);
  return scene;
}

GivenScene AskedScenes::given(const Question& question) {
  GivenScene out{.text = text_of(question), .model = "", .scene = {}, .inputs = {}};
  const SceneFile to_solve = scene(question);
  out.text.toml = changed_text(out.text, question.changes);
  out.scene = parse_scene_file(out.text);
  out.inputs = inputs_of(to_solve);
  return out;
}

std::string AskedScenes::in_plain_names(std::string message) const {
  const std::string folder = copies_.path().string() + "/";
  constexpr std::size_t digest = 17; // copy_of(), with the slash
  for (std::size_t at = 0; (at = message.find(folder, at)) != std::string::npos;)
    message.erase(at, folder.size() + digest);
  const std::scoped_lock lock(writing_);
  for (const auto& [name, file] : ours_)
    for (std::size_t at = 0; (at = message.find(file.string(), at)) != std::string::npos;)
      message.replace(at, file.string().size(), name);
  return message;
}

} // namespace bem_contact::explore
