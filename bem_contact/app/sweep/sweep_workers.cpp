#include "bem_contact/app/sweep/sweep_workers.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/said_by.hpp"
#include "bem_contact/uses/sweep/sweep_case.hpp"

#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <deque>
#include <fmt/format.h>
#include <iterator>
#include <optional>
#include <thread>

namespace bem_contact::app {

namespace {

/// The ends of the pipes in a worker.
constexpr int orders = 3, answers = 4;

/// Calls read() or write() until all bytes are through; false where that fails.
bool transfer(const auto& call, int handle, auto* at, std::size_t count) {
  while (count > 0) {
    const ssize_t n = call(handle, at, count);
    if (n < 0 && errno == EINTR)
      continue;
    if (n <= 0)
      return false;
    at += n;
    count -= static_cast<std::size_t>(n);
  }
  return true;
}

bool read_bytes(int handle, void* to, std::size_t count) {
  return transfer(::read, handle, static_cast<char*>(to), count);
}

bool write_bytes(int handle, const void* from, std::size_t count) {
  return transfer(::write, handle, static_cast<const char*>(from), count);
}

/// What a worker says of a case.
struct Answer {
  std::uint64_t how = 0; ///< 0: it has a result; else a CaseFailure
  std::string text;      ///< the result, or the message

  Answer() = default;
  Answer(CaseFailure failure, std::string message)
      : how(static_cast<std::uint64_t>(failure)), text(std::move(message)) {}
};

Answer answer_of(const CaseSolver& solver, std::size_t index) {
  try {
    Answer solved;
    solved.text = solver(index);
    return solved;
  } catch (const InputError& error) {
    return {CaseFailure::refused, error.what()};
  } catch (const ConvergenceError& error) {
    return {CaseFailure::not_converged, error.what()};
  } catch (const std::exception& error) {
    return {CaseFailure::fault, said_by(error)};
  }
}

bool write_answer(const Answer& answer) {
  const std::uint64_t head[] = {answer.how, answer.text.size()};
  return write_bytes(answers, head, sizeof head) && write_bytes(answers, answer.text.data(), head[1]);
}

/// Nothing if the worker has died.
std::optional<Answer> read_answer(int handle) {
  std::uint64_t head[2];
  if (!read_bytes(handle, head, sizeof head))
    return std::nullopt;
  Answer answer;
  answer.how = head[0];
  answer.text.resize(head[1]);
  if (!read_bytes(handle, answer.text.data(), head[1]))
    return std::nullopt;
  return answer;
}

/// Never returns: takes a chunk, answers with its cases, until there are no more orders.
[[noreturn]] void work(const WorkerCalls& calls) {
  for (std::uint64_t count = 0; read_bytes(orders, &count, sizeof count);) {
    Chunk chunk(count);
    if (!read_bytes(orders, chunk.data(), count * sizeof chunk[0]))
      _exit(1);
    const CaseSolver solver = calls.make_solver();
    for (const std::size_t index : chunk)
      if (!write_answer(answer_of(solver, index)))
        _exit(1);
  }
  _exit(0);
}

struct Worker {
  pid_t process = 0;
  int orders = -1, answers = -1;
  Chunk chunk;
  std::size_t solved = 0; ///< of its chunk

  bool busy() const { return solved < chunk.size(); }

  void start(const WorkerCalls& calls) {
    int to[2] = {-1, -1}, from[2] = {-1, -1};
    const pid_t started = pipe(to) == 0 && pipe(from) == 0 ? fork() : -1;
    if (started < 0) { // never kept: kill(-1) would end every process of the user
      const std::string why = std::strerror(errno);
      for (const int end : {to[0], to[1], from[0], from[1]})
        close(end);
      throw Error("No process to solve cases can be started", why,
                  "Give a smaller --jobs, or end other programs.");
    }
    process = started;
    if (process == 0) {
      prctl(PR_SET_PDEATHSIG, SIGKILL);
      const int read_end = dup(to[0]), write_end = dup(from[1]); // both above `answers`
      dup2(read_end, app::orders);
      dup2(write_end, app::answers);
      close_range(app::answers + 1, ~0U, 0); // above all the journal, whose lock must end with its owner
      work(calls);
    }
    close(to[0]);
    close(from[1]);
    orders = to[1];
    answers = from[0];
  }

  /// If the worker has died, reading its answers will meet the end of the file.
  void give(Chunk next) {
    chunk = std::move(next);
    solved = 0;
    const std::uint64_t count = chunk.size();
    if (write_bytes(orders, &count, sizeof count))
      write_bytes(orders, chunk.data(), count * sizeof chunk[0]);
  }

  /// Closes its pipes and says how it ended.
  std::string end() {
    close(orders);
    close(answers);
    int status = 0;
    while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
    process = 0;
    chunk.clear();
    return WIFSIGNALED(status)
               ? fmt::format("the process that solved it was ended by signal {} ({})", WTERMSIG(status),
                             strsignal(WTERMSIG(status)))
               : fmt::format("the process that solved it ended with code {}", WEXITSTATUS(status));
  }
};

/// A worker that dies must not take this process with it.
class NoPipeSignal {
public:
  NoPipeSignal() : before_(std::signal(SIGPIPE, SIG_IGN)) {}
  ~NoPipeSignal() { std::signal(SIGPIPE, before_); }

private:
  void (*before_)(int);
};

/// The workers, and the chunks that no worker has yet.
class Pool {
public:
  Pool(std::vector<Chunk> chunks, int jobs, const WorkerCalls& calls)
      : calls_(calls), open_(std::make_move_iterator(chunks.begin()), std::make_move_iterator(chunks.end())),
        workers_(std::min<std::size_t>(std::max(jobs, 1), open_.size())) {}

  void solve_all() {
    for (Worker& w : workers_)
      w.start(calls_);
    for (;;) {
      std::vector<pollfd> waiting;
      std::vector<Worker*> who;
      for (Worker& w : workers_) {
        if (!w.busy() && !open_.empty()) {
          w.give(std::move(open_.front()));
          open_.pop_front();
        }
        if (w.busy()) {
          waiting.push_back({w.answers, POLLIN, 0});
          who.push_back(&w);
        }
      }
      if (waiting.empty())
        return;
      if (poll(waiting.data(), waiting.size(), -1) < 0)
        continue;
      for (std::size_t i = 0; i < waiting.size(); ++i)
        if (waiting[i].revents != 0)
          take_answer(*who[i]);
    }
  }

  void end() {
    for (Worker& w : workers_)
      if (w.process != 0)
        w.end();
  }

  void kill_all() {
    for (Worker& w : workers_)
      if (w.process != 0) {
        kill(w.process, SIGKILL);
        w.end();
      }
  }

private:
  /// Of one case; if the worker has died, the case is lost, the rest of its chunk is not.
  void take_answer(Worker& w) {
    if (std::optional<Answer> answer = read_answer(w.answers)) {
      const std::size_t index = w.chunk[w.solved++];
      if (answer->how == 0)
        calls_.done(index, std::move(answer->text));
      else
        calls_.failed(index, static_cast<CaseFailure>(answer->how), answer->text);
      return;
    }
    const std::size_t lost = w.chunk[w.solved];
    Chunk rest(w.chunk.begin() + static_cast<std::ptrdiff_t>(w.solved) + 1, w.chunk.end());
    calls_.failed(lost, CaseFailure::died, w.end());
    if (!rest.empty())
      open_.push_front(std::move(rest));
    w.start(calls_);
  }

  const WorkerCalls& calls_;
  std::deque<Chunk> open_;
  std::vector<Worker> workers_;
};

} // namespace

std::vector<Chunk> chunks_of(std::size_t cases) {
  const std::size_t length = chunk_size(cases);
  std::vector<Chunk> chunks;
  for (std::size_t i = 0; i < cases; ++i) {
    if (i % length == 0)
      chunks.emplace_back();
    chunks.back().push_back(i);
  }
  return chunks;
}

void solve_in_processes(std::vector<Chunk> chunks, int jobs, const WorkerCalls& calls) {
  const NoPipeSignal no_signal;
  const int cores = static_cast<int>(std::thread::hardware_concurrency());
  Pool pool(std::move(chunks), jobs > 0 ? jobs : cores, calls);
  try {
    pool.solve_all();
  } catch (...) {
    pool.kill_all();
    throw;
  }
  pool.end();
}

} // namespace bem_contact::app
