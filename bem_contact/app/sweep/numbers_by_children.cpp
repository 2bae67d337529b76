#include "bem_contact/app/sweep/numbers_by_children.hpp"

#include "bem_contact/app/command.hpp"
#include "bem_contact/app/sweep/child_processes.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/said_by.hpp"
#include "bem_contact/base/temporary_folder.hpp"
#include "bem_contact/uses/sweep/sweep_case.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <sstream>

namespace bem_contact::app {

namespace {

/// In a child: writes the numbers of each item to a file at once, so that it says which item was the last. A
/// file beside it says what is wrong.
int write_items(const ItemsOfWork& work, CaseRange items, const std::filesystem::path& file) {
  const auto fail = [&](ExitCode code, const std::string& why) {
    std::ofstream(file.string() + ".error") << why;
    return code;
  };
  try {
    std::ofstream out(file, std::ios::binary);
    work.solve(items, [&](const std::vector<double>& numbers) {
      const std::size_t size = numbers.size();
      out.write(reinterpret_cast<const char*>(&size), sizeof size);
      out.write(reinterpret_cast<const char*>(numbers.data()),
                static_cast<std::streamsize>(size * sizeof(double)));
      if (!out.flush())
        throw Error("Numbers cannot be kept", "the folder of temporary files may be full",
                    "Make room there.");
    });
    return success;
  } catch (const InputError& error) {
    return fail(wrong_input, error.what());
  } catch (const ConvergenceError& error) {
    return fail(no_convergence, error.what());
  } catch (const std::exception& error) {
    return fail(unforeseen, said_by(error));
  }
}

/// The items that a child has written.
std::vector<std::vector<double>> read_items(const std::filesystem::path& file) {
  std::vector<std::vector<double>> out;
  std::ifstream in(file, std::ios::binary);
  for (std::size_t size = 0; in.read(reinterpret_cast<char*>(&size), sizeof size);) {
    std::vector<double> numbers(size);
    if (!in.read(reinterpret_cast<char*>(numbers.data()),
                 static_cast<std::streamsize>(size * sizeof(double))))
      break;
    out.push_back(std::move(numbers));
  }
  return out;
}

std::string said_in(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// Ends the work: a solver's own words name the item.
[[noreturn]] void refuse_item(const std::string& name, const EndOfChild& end, const std::string& said) {
  if (end.code == wrong_input)
    throw InputError(said);
  if (end.code == no_convergence)
    throw ConvergenceError(said);
  const std::string problem = fmt::format("{} has no result", name);
  if (end.code == unforeseen)
    throw Error(problem, said,
                "The machine or the program is to blame: look for free memory, then report it.");
  // here it would end this process too
  throw ConvergenceError(problem, end.how,
                         "If memory ran out, give a smaller --jobs; else solve it alone to see why.");
}

} // namespace

std::vector<std::vector<double>> numbers_by_children(const ItemsOfWork& work, int jobs) {
  std::vector<std::vector<double>> out(work.count);
  const TemporaryFolder folder;
  const auto file = [&](CaseRange chunk) { return folder / fmt::format("{}", chunk.first); };
  const std::size_t length = chunk_size(work.count), processes = processes_of(jobs);
  ChildProcesses children;
  for (std::size_t next = 0; next < work.count || children.size() > 0;) {
    if (next < work.count && children.size() < processes) {
      const CaseRange chunk{next, std::min(work.count, next + length)};
      children.start(chunk, [&, chunk] { return write_items(work, chunk, file(chunk)); });
      next = chunk.last;
      continue;
    }
    const EndOfChild end = children.wait();
    std::vector<std::vector<double>> found = read_items(file(end.cases));
    if (end.code != success)
      refuse_item(work.name(std::min(end.cases.first + found.size(), end.cases.last - 1)), end,
                  said_in(file(end.cases).string() + ".error"));
    std::ranges::move(found, out.begin() + static_cast<std::ptrdiff_t>(end.cases.first));
    if (work.done)
      work.done(end.cases.size());
  }
  return out;
}

} // namespace bem_contact::app
