#pragma once

#include "bem_contact/explore/asked_scenes.hpp"
#include "bem_contact/explore/server.hpp"
#include "bem_contact/sequence/sequence.hpp"

#include <array>
#include <atomic>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

namespace bem_contact::explore {

/// Answers the page's questions, one solution at a time. Each function takes a question (asked_scenes.hpp)
/// as JSON. What is wrong with it is said in the reply: {"problem": {"kind", "message"}}, where "kind" is
/// "refused", "not converged", "replaced" (the same window has asked again) or "fault". Several threads may
/// ask at once.
class Answers {
public:
  explicit Answers(const Start& start) : scenes_(start) {}

  /// The result of the scene, as JSON for the page (record/json.hpp).
  Reply answer(const std::string& question);
  /// The scene as a file.
  Reply scene(const std::string& question);
  /// The file of bem_contact solve -o.
  Reply result(const std::string& question);
  /// The page of bem_contact report.
  Reply report(const std::string& question);

  /// Ends the solution that is under way, and answers nothing more.
  void end();

private:
  using Stop = std::shared_ptr<std::atomic<bool>>;

  SceneResult solve(const Question& question, Sequence& sequence, const Stop& stop);
  record::Record file_of(const Question& question, const SceneResult& result);
  Stop newest(const std::string& window);
  template <class Answer> Reply replied(const std::string& question, const Answer& answer);

  AskedScenes scenes_;
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
inline constexpr std::array all_asked{Asked{"answer", &Answers::answer}, Asked{"scene", &Answers::scene},
                                      Asked{"result", &Answers::result}, Asked{"report", &Answers::report}};

} // namespace bem_contact::explore
