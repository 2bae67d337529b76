#pragma once

#include "bem_contact/scene/case_table.hpp"
#include "bem_contact/scene/scene_file.hpp"
#include "bem_contact/scene/scene_reader.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bem_contact {

/// Cases that follow each other: first, first + 1 ... last - 1.
struct CaseRange {
  std::size_t first = 0, last = 0;

  std::size_t size() const { return last - first; }
  bool operator==(const CaseRange&) const = default;
};

/// A scene file with a table [sweep]: lists or ranges for any of its keys.
///
///     [sweep]
///     mode = "product"            # or "zip": the first of each list, the second of each ...
///     position.lateral = { from = 6.2, to = 7.1, step = 0.05 }   # or count = 19
///     load.force = [ 5e4, 1e5 ]
///     rail.profile = [ "60E1", "worn.prr" ]
///
///     [sweep]
///     table = "collective.csv"     # instead of lists: one line a case
///     columns = { time = "note", y = "position.lateral" } # what columns are whose names are no keys
///
///     [[sweep.together]]           # lists side by side, as one list of the product; or table = "rails.csv"
///     rail.profile = [ "60E1", "worn.prr" ]
///     rail.influence = [ "new.h5", "worn.h5" ]
///
/// A product runs through the last list fastest, in the order of the file; lists of `together` come first,
/// because bodies should change least often. A table [passage] (passage.hpp) is a list over the place along
/// the track, beside those of [sweep] or alone. Cases that follow each other should be alike, because each
/// starts from the one before. Each case is the scene with its values, and is checked like any scene.
struct SweepFile {
  static constexpr const char* time_note = "note.time"; ///< the key of a replay's time

  struct Axis {
    std::string key;
    std::vector<SchemaValue> values;
    int line = 0;
    bool range = false;     ///< given by its ends
    bool beside = false;    ///< goes side by side with the axis before: the two are one list of the product
    std::string table = {}; ///< the file that has its values; "": the scene
    std::vector<int> lines = {}; ///< of each value in that file; empty: `line`

    bool is_note() const { return key.starts_with(CaseTable::Column::note_prefix); } ///< no key of the scene
    std::string unit() const; ///< of the key, s of the time of a replay, "" for none
  };

  SceneText text;              ///< with the table
  std::vector<Axis> axes = {}; ///< in the order of the file
  /// sweep.weight: how often each case occurs compared with the others (a load collective); empty: alike. No
  /// result of a case depends on it. One for each case of the lists outside of `together`.
  std::vector<double> weights = {};
  /// CSV files of lists (case_table.hpp), and the key that named each: sweep.table, which has weights too,
  /// and the tables of `together`.
  std::vector<NamedFile> tables = {};
  std::optional<bool> fields = {}; ///< whether fields of each case are kept, not only its totals

  /// The cases are the steps of a vehicle program's run (uses/sweep/replay_file.hpp).
  struct Replay {
    /// A step is not solved if what lies between two solved steps is known within so many stated errors.
    double tolerance = 0;
    struct Compared {
      std::string quantity, unit; ///< of sequence/quantities.hpp; of the numbers
      std::vector<double> of_run; ///< what the run's own contact model gave, one a step
    };
    std::vector<Compared> compared = {};
  };
  std::optional<Replay> replay = {};

  std::size_t size() const;
  CaseRange all() const { return {0, size()}; }
  /// What `fields` says; if it says nothing, only few cases have fields: they take 200 kB a case.
  bool keeps_fields() const;
  /// How often a case occurs; 1 without sweep.weight.
  double weight(std::size_t index) const {
    return weights.empty() ? 1 : weights[index % weights.size()]; // `together` changes slowest
  }
  /// Which value of each axis a case has.
  std::vector<std::size_t> indices(std::size_t index) const;
  std::vector<SceneChange> changes(std::size_t index) const;
  /// Throws InputError naming the line of the value that is wrong.
  SceneFile scene(std::size_t index) const;
  /// The first case that is a scene: lines of a table may be none, as where a wheel lifts. Throws InputError.
  SceneFile first_scene() const;
  /// "position.lateral = 6.2, load.force = 50000"
  std::string describe(std::size_t index) const;
};

/// The scenes of a sweep, one after the other: the text is read once, and each case sets its keys.
class SweepScenes {
public:
  explicit SweepScenes(const SweepFile& sweep) : sweep_(sweep) {} ///< which outlives this
  /// As SweepFile::scene().
  SceneFile scene(std::size_t index);
  /// Throws InputError where a key of the scene() before overrules one that is swept.
  void require_effect() const;

private:
  const SweepFile& sweep_;
  std::optional<SceneReader> reader_;
};

/// Says whether a scene has a table [sweep] or [passage], or the other one that has lists
/// (parse_sweep_file()).
bool has_sweep(const SceneText& given, std::string_view section = "sweep");

/// Throws InputError for a file without [sweep] or [passage], an empty or endless range, a zip of lists of
/// unequal lengths, or a key that no scene has.
SweepFile read_sweep_file(const std::filesystem::path& file);
/// `section`: the table that has the lists. "table" (bem_contact table) has no mode or weight; its single
/// values are options of that command, and are passed over.
SweepFile parse_sweep_file(SceneText given, std::string_view section = "sweep");

/// Returns the value as TOML writes it, numbers with the fewest digits that give them back.
std::string to_text(const SchemaValue& value);

} // namespace bem_contact
