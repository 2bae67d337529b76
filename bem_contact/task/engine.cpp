#include "bem_contact/task/engine.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/said_by.hpp"
#include "bem_contact/base/temporary_folder.hpp"
#include "bem_contact/base/workers.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <sstream>
#include <thread>

namespace bem_contact::task {

namespace {

/// How a child has ended that has written a file: its answer, or what is wrong.
enum class Ended { answered, wrong_input, no_convergence, unforeseen };

int write(const std::filesystem::path& file, const std::string& content, Ended ended) {
  std::ofstream out(file, std::ios::binary);
  out << content;
  if (!out.flush() && ended == Ended::answered)
    throw Error("Numbers cannot be kept", "the folder of temporary files may be full", "Make room there.");
  return static_cast<int>(ended);
}

int answer_in_child(const Portions& all, std::size_t portion, const std::filesystem::path& file) {
  try {
    return write(file, all.answer(portion, nullptr), Ended::answered);
  } catch (const InputError& error) {
    return write(file, error.what(), Ended::wrong_input);
  } catch (const ConvergenceError& error) {
    return write(file, error.what(), Ended::no_convergence);
  } catch (const std::exception& error) {
    return write(file, said_by(error), Ended::unforeseen);
  }
}

/// The answer of a child. What it has thrown is thrown here.
std::string answer_of(const EndOfWork& end, const std::filesystem::path& file, const std::string& name) {
  std::ostringstream content;
  content << std::ifstream(file, std::ios::binary).rdbuf();
  const std::string said = std::move(content).str(), problem = fmt::format("{} has no result", name);
  switch (end.code) {
  case static_cast<int>(Ended::answered):
    return said;
  case static_cast<int>(Ended::wrong_input):
    throw InputError(said);
  case static_cast<int>(Ended::no_convergence):
    throw ConvergenceError(said);
  case static_cast<int>(Ended::unforeseen):
    throw Error(problem, said,
                "The machine or the program is to blame: look for free memory, then report it.");
  default: // here it would end this process too
    throw ConvergenceError(problem, end.how,
                           "If memory ran out, give a smaller --jobs; else solve it alone to see why.");
  }
}

} // namespace

Engine here(const std::atomic<bool>* stop) {
  return [stop](const Portions& all) {
    for (std::size_t i = 0; i < all.asked.size(); ++i)
      all.take(i, all.answer(i, stop));
  };
}

Engine in_children(int jobs) {
  return [jobs](const Portions& all) {
    const TemporaryFolder folder;
    const auto file = [&](std::size_t portion) { return folder / fmt::format("{}", portion); };
    Workers children(folder.path());
    for (std::size_t next = 0; next < all.asked.size() || children.size() > 0;) {
      if (next < all.asked.size() && children.size() < processes_of(jobs)) {
        children.start(next, [&, next] { return answer_in_child(all, next, file(next)); });
        ++next;
        continue;
      }
      const EndOfWork end = children.wait();
      all.take(end.number, answer_of(end, file(end.number), all.name(end.number)));
    }
  };
}

std::size_t processes_of(int jobs) {
  return jobs > 0 ? static_cast<std::size_t>(jobs) : std::max(1U, std::thread::hardware_concurrency());
}

} // namespace bem_contact::task
