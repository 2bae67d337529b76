#pragma once

#include "bem_contact/scene/scene_file.hpp"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace bem_contact {

/// A scene that is read once and changed often: for programs that call the solver at each time step. Setting
/// a key and taking the scene costs a fraction of reading the text again.
class SceneReader {
public:
  /// Throws InputError for a text that is no scene. Keys may still be missing that set() will give.
  explicit SceneReader(SceneText given);
  ~SceneReader();
  SceneReader(SceneReader&&) noexcept; ///< can be moved

  /// Sets a key as if the text said so from here on. Throws InputError for an unknown key (with the
  /// nearest ones), a wrong type, or a value out of range; the key then keeps its value.
  void set(const SceneChange& change);

  /// Does the same for a number, which the key may want whole or as a flag (Schema::number_for).
  void set_number(const std::string& key, double number);
  /// Every key is again what the text says.
  void reset();
  /// Throws InputError for an unknown key, with the nearest ones.
  void require_key(const std::string& key) const;

  /// Throws InputError for a key of `swept` that another key overrules, so that its values change nothing.
  void require_effect(std::span<const std::string> swept) const;

  /// The scene as it is now, checked like any scene. Throws InputError.
  SceneFile scene() const;

private:
  struct State;

  SceneText given_;
  std::vector<SceneChange> changes_; ///< the last of each key
  std::unique_ptr<State> state_;
};

} // namespace bem_contact
