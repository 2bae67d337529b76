#include "bem_contact/app/study/run_line.hpp"

#include "bem_contact/app/command.hpp"
#include "bem_contact/app/run_program.hpp"
#include "bem_contact/base/child_process.hpp"
#include "bem_contact/base/printable.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fmt/format.h>
#include <functional>
#include <string_view>

namespace bem_contact::app {

namespace {

void take_line(const std::string& text, LineOutcome& outcome, std::set<std::string>& said) {
  const auto keep = [&](std::string_view begin, std::vector<std::string>& kept) {
    if (text.starts_with(begin))
      kept.push_back(text.substr(begin.size()));
  };
  keep("error: ", outcome.errors);
  keep("warning: ", outcome.warnings);
  const bool message = text.starts_with("info: ") || text.starts_with("warning: ");
  if (!message || said.insert(text).second)
    print_error("{}\n", text);
}

LineOutcome in_process(const std::filesystem::path& text, std::set<std::string>& said,
                       const std::function<int()>& work) {
  LineOutcome out;
  ChildProcess child(text, work);
  while (const auto line = child.next_line())
    take_line(*line, out, said);
  std::string how;
  out.code = child.wait(how);
  if (out.code >= 0)
    return out;
  out.code = unforeseen;
  out.errors.push_back(
      fmt::format("Its process was ended ({}) If memory ran out, give it less to do; then call "
                  "bem_contact study again.",
                  how));
  return out;
}

} // namespace

LineOutcome run_line(const std::vector<std::string>& words, const std::filesystem::path& text,
                     std::set<std::string>& said) {
  return in_process(text, said, [&] {
    std::vector<std::string> line{"bem_contact"};
    line.insert(line.end(), words.begin(), words.end());
    std::vector<char*> pointers;
    for (std::string& word : line)
      pointers.push_back(word.data());
    pointers.push_back(nullptr);
    return run_program(static_cast<int>(line.size()), pointers.data());
  });
}

LineOutcome run_other(const std::vector<std::string>& words, const std::filesystem::path& text,
                      std::set<std::string>& said) {
  return in_process(text, said, [&] {
    ProgramLine(words).become();
    print_error("error: '{}' cannot be started ({}) Give influence.program a program that is there.\n",
                words.front(), std::strerror(errno));
    return static_cast<int>(wrong_input);
  });
}

} // namespace bem_contact::app
