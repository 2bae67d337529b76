#pragma once

#include "bem_contact/record/record.hpp"
#include "bem_contact/sequence/comparison.hpp"
#include "bem_contact/sequence/scene_result.hpp"

#include <optional>
#include <string_view>

namespace bem_contact {

/// Which parts of a result a record has besides its texts.
struct RecordParts {
  bool fields = true; ///< what lies on the grid: coordinates, tractions ..., of every step too, and outlines
  bool quantities = true; ///< and how the solver went; false: dx and ds alone, for the cases of a sweep
};

/// What a result says at every door. Fields look into the result, which must outlive the record.
///
///     model, why_this_model, certified, why_not_certified, warnings ...   in words
///     quantities/Fx, patches/0/Fn, history/0/Fx, ...                      numbers (quantities.hpp)
///     x, s, gap, p_n, ...                                                 fields
record::Record record_of(const SceneResult& result, const RecordParts& parts = {});
/// A temporary is gone before its fields are looked at.
record::Record record_of(const SceneResult&& result, const RecordParts& parts = {}) = delete;

/// `warnings`: the texts, the most important first; `warning_kinds`: what each is of (WarningKind);
/// `warning_about`: the key, where a kind has several. Two of one kind about the same thing differ in figures
/// alone.
record::Record record_of(const Warnings& warnings);

/// A result that is asked by path, "patches/0/Fn". Its records are made once, when a path first needs them:
/// most paths need no fields. The result must outlive this, and stay where it is.
class ResultByPath {
public:
  explicit ResultByPath(const SceneResult& result) : result_(&result) {}

  /// A record that has something at this path. Throws InputError, which names the nearest paths.
  const record::Record& record_with(std::string_view path);
  /// The number there. Throws InputError.
  double number(std::string_view path);

private:
  const SceneResult* result_;
  std::optional<record::Record> numbers_, whole_;
};

/// These make its tables, and the parts that only some scenes ask for.
record::Table patches_of(const SceneResult& result);
record::Table history_of(const SceneResult& result);
record::Content structure_of(const std::optional<StructuralResult>& structure);
record::Content stresses_of(const std::optional<StressesBelow>& stresses);

/// The same of a comparison: at_equal_forces/MODEL and at_equal_position/MODEL, each with `difference` (what
/// the reference has more, over its scale), and creep_forces.
record::Record record_of(const Comparison& comparison, const RecordParts& parts = {});
record::Record record_of(const Comparison&& comparison, const RecordParts& parts = {}) = delete;

} // namespace bem_contact
