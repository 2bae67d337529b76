#include "bem_contact/app/study/run_line.hpp"

#include "bem_contact/app/command.hpp"
#include "bem_contact/app/run_program.hpp"
#include "bem_contact/base/child_process.hpp"
#include "bem_contact/base/message_file.hpp"
#include "bem_contact/base/printable.hpp"
#include "bem_contact/base/program.hpp"
#include "bem_contact/base/temporary_folder.hpp"

#include <fmt/format.h>

namespace bem_contact::app {

namespace {

LineOutcome in_process(const std::filesystem::path& text, std::set<std::string>& said, ChildWork work) {
  LineOutcome out;
  const TemporaryFolder folder;
  MessageFile told(folder / "messages.txt");
  work.variables = {{message_file_variable, told.file().string()}};
  ChildProcess child(text, work);
  if (!child.why_not_started().empty()) {
    out.code = wrong_input;
    out.errors.push_back(
        fmt::format("'{}' cannot be started ({}) Give influence.program a program that is there.",
                    work.words.front(), child.why_not_started()));
    print_error("error: {}\n", out.errors.back());
    return out;
  }
  while (const auto line = child.next_line())
    if (line->empty() || said.insert(*line).second)
      print_error("{}\n", *line);
  std::string how;
  out.code = child.wait(how);
  for (const ToldMessage& message : told.next())
    if (message.kind != Told::progress)
      (message.kind == Told::error ? out.errors : out.warnings).push_back(message.text);
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
  std::vector<std::string> line{this_program().string()};
  line.insert(line.end(), words.begin(), words.end());
  const auto here = [&line] {
    std::vector<char*> pointers;
    for (std::string& word : line)
      pointers.push_back(word.data());
    pointers.push_back(nullptr);
    return run_program(static_cast<int>(line.size()), pointers.data());
  };
  return in_process(text, said, {.words = line, .here = here});
}

LineOutcome run_other(const std::vector<std::string>& words, const std::filesystem::path& text,
                      std::set<std::string>& said) {
  return in_process(text, said, {.words = words});
}

} // namespace bem_contact::app
