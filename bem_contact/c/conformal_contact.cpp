#include "bem_contact/c/conformal_contact.h"

#include "bem_contact/base/provenance.hpp"
#include "bem_contact/c/calls.hpp"
#include "bem_contact/c/result_values.hpp"
#include "bem_contact/record/file_kinds.hpp"
#include "bem_contact/record/json.hpp"
#include "bem_contact/scene/scene_reader.hpp"
#include "bem_contact/sequence/quantities.hpp"
#include "bem_contact/sequence/result_record.hpp"
#include "bem_contact/sequence/scene_record.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "bem_contact/sequence/uncertified.hpp"

#include <algorithm>
#include <atomic>
#include <fmt/format.h>
#include <optional>
#include <string>
#include <vector>

using namespace bem_contact;

/// What a handle points to.
struct conformal_contact {
  explicit conformal_contact(SceneReader scene) : reader(std::move(scene)) {}

  SceneReader reader;
  Sequence sequence;
  std::vector<std::string> keys; ///< by index
  std::optional<SceneResult> result;
  std::optional<ResultByPath> by_path; ///< of this result
  std::atomic<bool> stop = false;
  std::string message, why_no_errors, json;
};

namespace {

template <class Action> int with(conformal_contact* handle, const Action& action) noexcept {
  return handle ? guarded(handle->message, action) : CONFORMAL_WRONG_INPUT;
}

const std::string& key_of(const conformal_contact* handle, int key) {
  if (key < 0 || key >= static_cast<int>(handle->keys.size()))
    throw InputError(fmt::format("There is no key with the index {}", key),
                     fmt::format("this handle has given out {}", handle->keys.size()),
                     "Ask conformal_key() for it, with the same handle.");
  return handle->keys[static_cast<std::size_t>(key)];
}

const SceneResult& result_of(const conformal_contact* handle) {
  if (!handle->result)
    throw InputError("There is no result", "nothing was solved, or the last solution failed",
                     "Call conformal_solve(), and look at what it returns.");
  return *handle->result;
}

/// Throws InputError if there is no such warning.
const Warning& warning_of(const conformal_contact* handle, int index) {
  const Warnings& warnings = result_of(handle).warnings;
  if (index < 0 || index >= static_cast<int>(warnings.size()))
    throw InputError(fmt::format("There is no warning {}", index),
                     fmt::format("there are {}", warnings.size()),
                     "Count them with conformal_warning_count(); the first is 0.");
  return warnings[static_cast<std::size_t>(index)];
}

/// Throws InputError if there is no such patch.
std::size_t patch_at(const SceneResult& result, int index) {
  const std::size_t count = result.result.patches.size();
  if (index < 0 || index >= static_cast<int>(count))
    throw InputError(fmt::format("There is no patch {}", index), fmt::format("there are {}", count),
                     "Count them with conformal_patch_count(); the first is 0.");
  return static_cast<std::size_t>(index);
}

template <class Open>
int open(conformal_contact** handle, char* message, int size, const Open& open_scene) noexcept {
  return told(message, size, [&] {
    require(handle, "the handle");
    *handle = nullptr;
    *handle = new conformal_contact(open_scene());
  });
}

/// A stop holds until it has ended a solution: one that came before the solution began is not lost.
SceneResult solved_or_stopped(conformal_contact* handle) {
  try {
    end_if_stopped(&handle->stop);
    return handle->sequence.solve(handle->reader.scene(), &handle->stop);
  } catch (const Stopped&) {
    handle->stop = false;
    throw;
  }
}

/// Like the program's: no certificate, no success.
void solve(conformal_contact* handle) {
  handle->by_path.reset();
  handle->result.reset();
  handle->result = solved_or_stopped(handle);
  require_certified(*handle->result);
}

} // namespace

extern "C" {

const char* conformal_version(void) {
  return version().data(); // a literal
}

int conformal_open_file(const char* scene_file, conformal_contact** handle, char* message, int size) {
  return open(handle, message, size, [&] {
    require(scene_file, "the name of the scene file");
    SceneText given = read_scene_text(scene_file);
    given.folder = std::filesystem::absolute(scene_file).parent_path();
    return SceneReader(std::move(given));
  });
}

int conformal_open_text(const char* toml, const char* folder, conformal_contact** handle, char* message,
                        int size) {
  return open(handle, message, size, [&] {
    require(toml, "the text of the scene");
    return SceneReader({toml, "text", std::filesystem::absolute(folder && *folder ? folder : ".")});
  });
}

void conformal_close(conformal_contact* handle) {
  delete handle;
}

const char* conformal_message(const conformal_contact* handle) {
  return handle ? handle->message.c_str()
                : "there is no handle (a null pointer was given) Open a scene first.";
}

int conformal_key(conformal_contact* handle, const char* name, int* key) {
  return with(handle, [&] {
    require(name && key, "the name or the index");
    handle->reader.require_key(name);
    const auto known = std::ranges::find(handle->keys, name);
    *key = static_cast<int>(known - handle->keys.begin());
    if (known == handle->keys.end())
      handle->keys.emplace_back(name);
  });
}

int conformal_set_number(conformal_contact* handle, int key, double value) {
  return with(handle, [&] { handle->reader.set_number(key_of(handle, key), value); });
}

int conformal_set_numbers(conformal_contact* handle, int key, const double* values, int count) {
  return with(handle, [&] {
    require(count == 0 || values, "the list");
    if (count < 0)
      throw InputError("There is no such list", fmt::format("it has {} numbers", count), "Give at least 0.");
    handle->reader.set({key_of(handle, key), std::vector<double>(values, values + count)});
  });
}

int conformal_set_text(conformal_contact* handle, int key, const char* value) {
  return with(handle, [&] {
    require(value, "the text");
    handle->reader.set({key_of(handle, key), std::string(value)});
  });
}

int conformal_set_flag(conformal_contact* handle, int key, int value) {
  return with(handle, [&] { handle->reader.set({key_of(handle, key), value != 0}); });
}

int conformal_reset(conformal_contact* handle) {
  return with(handle, [&] { handle->reader.reset(); });
}

int conformal_solve(conformal_contact* handle) {
  return with(handle, [&] { solve(handle); });
}

int conformal_stop(conformal_contact* handle) {
  if (!handle)
    return CONFORMAL_WRONG_INPUT;
  handle->stop = true; // nothing else: the message belongs to the thread that solves
  return CONFORMAL_OK;
}

int conformal_totals(conformal_contact* handle, double* totals, int count) {
  return with(handle, [&] {
    require(totals, "the array");
    copy_first(totals_of(result_of(handle)), totals, count);
  });
}

int conformal_total_errors(conformal_contact* handle, double* errors, int count) {
  return with(handle, [&] {
    require(errors, "the array");
    copy_first(total_errors_of(result_of(handle)), errors, count);
  });
}

int conformal_number(conformal_contact* handle, const char* path, double* value) {
  return with(handle, [&] {
    require(path && value, "the path or the value");
    const SceneResult& result = result_of(handle);
    if (!handle->by_path)
      handle->by_path.emplace(result);
    *value = handle->by_path->number(path);
  });
}

int conformal_json(conformal_contact* handle, const char** text) {
  return with(handle, [&] {
    require(text, "the text");
    const SceneResult& result = result_of(handle);
    handle->json = record::to_json(headed(result_format).append(record_of(result, {.fields = false})));
    *text = handle->json.c_str();
  });
}

int conformal_model(conformal_contact* handle, const char** name, const char** why_this_model) {
  return with(handle, [&] {
    require(name && why_this_model, "the name or why_this_model");
    const SceneResult& result = result_of(handle);
    *name = name_of(result.choice.model).data(); // a literal
    *why_this_model = result.choice.why_this_model.c_str();
  });
}

int conformal_why_no_errors(conformal_contact* handle, const char** text) {
  return with(handle, [&] {
    require(text, "the text");
    handle->why_no_errors = why_no_errors(result_of(handle));
    *text = handle->why_no_errors.c_str();
  });
}

int conformal_patch_count(conformal_contact* handle, int* count) {
  return with(handle, [&] {
    require(count, "the count");
    *count = static_cast<int>(result_of(handle).result.patches.size());
  });
}

int conformal_patch(conformal_contact* handle, int index, double* values, int count) {
  return with(handle, [&] {
    require(values, "the array");
    const SceneResult& result = result_of(handle);
    copy_first(values_of(result, patch_at(result, index)), values, count);
  });
}

int conformal_patch_errors(conformal_contact* handle, int index, double* errors, int count) {
  return with(handle, [&] {
    require(errors, "the array");
    const SceneResult& result = result_of(handle);
    copy_first(errors_of(result, patch_at(result, index)), errors, count);
  });
}

int conformal_grid(conformal_contact* handle, int* mx, int* ms) {
  return with(handle, [&] {
    require(mx && ms, "mx or ms");
    const ContactGrid& grid = result_of(handle).problem.grid;
    *mx = grid.mx;
    *ms = grid.ms;
  });
}

int conformal_array(conformal_contact* handle, int which, double* values, int count) {
  return with(handle, [&] {
    require(values, "the array");
    copy_array(result_of(handle), which, {values, static_cast<std::size_t>(std::max(count, 0))});
  });
}

int conformal_warning_count(conformal_contact* handle, int* count) {
  return with(handle, [&] {
    require(count, "the count");
    *count = static_cast<int>(result_of(handle).warnings.size());
  });
}

int conformal_warning(conformal_contact* handle, int index, const char** text) {
  return with(handle, [&] {
    require(text, "the text");
    *text = warning_of(handle, index).text.c_str();
  });
}

int conformal_warning_kind(conformal_contact* handle, int index, const char** kind) {
  return with(handle, [&] {
    require(kind, "the kind");
    *kind = name_of(warning_of(handle, index).kind).data(); // of a literal, so it ends with 0
  });
}

} // extern "C"
