#include "bem_contact/base/interrupt_note.hpp"

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>

namespace bem_contact {
namespace {

/// What a process that `work`s writes to standard error, and the signal that ends it (0: none).
template <class Work> std::pair<std::string, int> end_of(const Work& work) {
  int ends[2];
  EXPECT_EQ(pipe(ends), 0);
  const pid_t child = fork();
  if (child == 0) {
    dup2(ends[1], STDERR_FILENO);
    close(ends[0]);
    close(ends[1]);
    work();
    _exit(0);
  }
  close(ends[1]);
  std::string text;
  char buffer[500];
  for (ssize_t n = 0; (n = read(ends[0], buffer, sizeof buffer)) > 0;)
    text.append(buffer, static_cast<std::size_t>(n));
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  return {text, WIFSIGNALED(status) ? WTERMSIG(status) : 0};
}

TEST(InterruptNote, SaysHowMuchIsDoneAndTheSignalStillEndsTheProcess) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const auto [text, ended_by] = end_of([&] {
      InterruptNote note("cases", "The same command goes on.");
      for (std::size_t i = 1; i <= 5; ++i)
        note.done(i, 12);
      raise(signal);
    });
    EXPECT_EQ(text, "\ninterrupted: 5 of 12 cases are done. The same command goes on.\n");
    EXPECT_EQ(ended_by, signal);
  }
}

TEST(InterruptNote, IsGoneAfterwardsAndNotOfChildren) {
  const auto after = end_of([] {
    { InterruptNote("cases", "").done(1, 2); }
    raise(SIGINT);
  });
  EXPECT_EQ(after.first, "");
  EXPECT_EQ(after.second, SIGINT);
  const auto child = end_of([] {
    InterruptNote note("cases", "");
    note.done(1, 2);
    if (fork() == 0)
      raise(SIGINT);
    else
      wait(nullptr);
  });
  EXPECT_EQ(child.first, "");
  EXPECT_EQ(child.second, 0);
}

} // namespace
} // namespace bem_contact
