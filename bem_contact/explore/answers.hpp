#pragma once

#include "bem_contact/explore/asked_scenes.hpp"
#include "bem_contact/explore/computer.hpp"
#include "bem_contact/explore/profile_remarks.hpp"
#include "bem_contact/explore/server.hpp"
#include "bem_contact/sequence/result_record.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "bem_contact/uses/wheelset/solve_wheelset.hpp"

#include <array>
#include <atomic>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

namespace bem_contact::explore {

/// A record and what it looks at: its fields are not copied.
struct KeptRecord {
  std::shared_ptr<const void> owner;
  record::Record record;
};

/// Answers the page's questions, one solution at a time. Each function takes a question (asked_scenes.hpp)
/// as JSON. What is wrong with it is said in the reply: {"problem": {"kind", "message"}}, where "kind" is
/// the name of a record::Outcome ("replaced": the same window has asked again). Several threads may
/// ask at once.
class Answers {
public:
  /// `computer`: of influence functions; null: this page has none.
  explicit Answers(const Start& start, Computer* computer = nullptr) : scenes_(start), computer_(computer) {}

  /// The result of the scene, as JSON for the page (record/json.hpp); of a wheelset "wheels" has both, and
  /// "wheelset" its own numbers.
  Reply answer(const std::string& question);
  /// The same for programs: what bem_contact solve --json prints, of a wheelset bem_contact wheelset --json.
  Reply numbers(const std::string& question);
  /// And what lies on the grid: coordinates, tractions ...
  Reply fields(const std::string& question);
  /// The same as fields() with meanings and errors beside the values, in the form of the page.
  Reply described(const std::string& question);
  /// The files that the scene names: {"files": [{"key", "name", "influence", "advice"}]}, the last for one
  /// that is not there. No file need come with the question.
  Reply names(const std::string& question);
  /// Whether the solution may read influence files: {"influence": true}.
  Reply needs(const std::string& question);
  /// The scene as a file.
  Reply scene(const std::string& question);
  /// The file of bem_contact solve -o, of a wheelset that of bem_contact wheelset -o.
  Reply result(const std::string& question);
  /// The page of bem_contact report.
  Reply report(const std::string& question);
  /// Body files for the influence functions of the scene: {"bodies": [{"side", "name", "text"}]}.
  Reply bodies(const std::string& question);
  /// Begins to compute these. Replies as computing() does.
  Reply compute(const std::string& question);
  /// How far they are: {"stage": "idle", "running", "done", "failed" or "cancelled", "what", "share",
  /// "missing", "changes"}. "changes" are those of a scene that takes them, once they are done. The question
  /// may be {}.
  Reply computing(const std::string& question);
  /// Ends the computation. Replies as computing() does.
  Reply cancel(const std::string& question);

  /// From now on a scene may name this file.
  void hold(const std::string& name, const std::filesystem::path& file) { scenes_.hold(name, file); }

  /// Ends the solution that is under way, and answers nothing more.
  void end();

private:
  using Stop = std::shared_ptr<std::atomic<bool>>;

  SceneResult solve(const Question& question, Sequence& sequence, const Stop& stop);
  WheelsetResult solve_both(const SceneFile& scene, const Stop& stop);
  record::Record remarks_on(const SceneFile& scene);
  template <class Make> KeptRecord as_by_the_command(const Question& question, const Make& make);
  KeptRecord file_of(const Question& question);
  Reply printed_as(const std::string& question, const RecordParts& parts);
  std::vector<NamedBody> named_bodies(const Question& question);
  Stop newest(const std::string& window);
  template <class Answer> Reply replied(const std::string& question, const Answer& answer);

  AskedScenes scenes_;
  ProfileRemarks remarks_; ///< used by whoever holds solving_
  Computer* computer_;
  Sequence sequence_;
  std::mutex solving_;                              ///< held by whoever uses the processor
  std::mutex counting_;                             ///< held for the members below
  std::list<std::pair<std::string, Stop>> windows_; ///< the newest question of each, the latest one first
  bool ended_ = false;
};

/// What the page asks for, by name.
struct Asked {
  std::string_view name;
  Reply (Answers::*reply)(const std::string& question);
};
inline constexpr std::array all_asked{
    Asked{"needs", &Answers::needs},         Asked{"answer", &Answers::answer},
    Asked{"numbers", &Answers::numbers},     Asked{"fields", &Answers::fields},
    Asked{"described", &Answers::described}, Asked{"names", &Answers::names},
    Asked{"scene", &Answers::scene},         Asked{"result", &Answers::result},
    Asked{"report", &Answers::report},       Asked{"bodies", &Answers::bodies},
    Asked{"compute", &Answers::compute},     Asked{"computing", &Answers::computing},
    Asked{"cancel", &Answers::cancel}};

} // namespace bem_contact::explore
