#include "bem_contact/base/child_process.hpp"

namespace bem_contact {

std::optional<std::string> ChildProcess::next_line(const std::atomic<bool>* stop,
                                                   const std::function<void()>& meanwhile) {
  constexpr int patience = 100; // ms, after which `stop` is looked at
  while (!stop || !*stop) {
    if (const std::size_t end = rest_.find('\n'); end != std::string::npos) {
      std::string line = rest_.substr(0, end);
      rest_.erase(0, end + 1);
      if (line.ends_with('\r'))
        line.pop_back();
      return line;
    }
    const Read read = read_more(stop ? patience : -1);
    if (read == Read::end)
      break;
    if (read == Read::nothing_yet && meanwhile)
      meanwhile();
  }
  return rest_.empty() ? std::nullopt : std::optional(std::exchange(rest_, {}));
}

} // namespace bem_contact
