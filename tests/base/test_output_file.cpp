#include "bem_contact/base/output_file.hpp"

#include "message.hpp"
#include "temporary_folder.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <stdexcept>
#include <thread>

namespace bem_contact {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

void write_word(std::ostream& out) {
  out << "word";
}

/// Files of the folder that a write has left beside its output.
int files_in(const fs::path& folder) {
  return static_cast<int>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(OutputFile, ReplacesARegularFileWholeAndKeepsItsPermissions) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("a", "something longer");
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  for (const auto& write : {write_text, write_whole}) {
    write(file, write_word);
    EXPECT_EQ(text_of(file), "word");
    EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  }
  EXPECT_EQ(files_in(folder / ""), 1);
}

TEST(OutputFile, KeepsTheOldFileWhereWritingFails) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("a", "old");
  EXPECT_THAT(fault_of([&] { write_text(file, [](std::ostream& out) { out.setstate(std::ios::badbit); }); }),
              StartsWith("The file '" + file.string() + "' cannot be written"));
  EXPECT_EQ(text_of(file), "old");
  EXPECT_EQ(files_in(folder / ""), 1);
}

TEST(OutputFile, LeavesNothingBehindWhereTheWriterThrows) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("a", "old");
  const auto give_up = [](std::ostream& out) {
    out << "half";
    throw std::out_of_range("no more");
  };
  EXPECT_THROW(write_whole(file, give_up), std::out_of_range);
  EXPECT_THROW(write_text(folder / "new", give_up), std::out_of_range);
  EXPECT_EQ(text_of(file), "old");
  EXPECT_EQ(files_in(folder / ""), 1);
}

TEST(WholeFile, WhatIsNotCommittedLeavesNothing) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("a", "old");
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  {
    const WholeFile whole(file, ".msh");
    EXPECT_EQ(whole.temporary().extension(), ".msh");
    EXPECT_EQ(whole.temporary().parent_path(), folder.path());
    folder.write(whole.temporary().filename(), "half");
  }
  EXPECT_EQ(text_of(file), "old");
  EXPECT_EQ(files_in(folder / ""), 1);
  const WholeFile whole(file);
  folder.write(whole.temporary().filename(), "new");
  whole.commit();
  EXPECT_EQ(text_of(file), "new");
  EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(files_in(folder / ""), 1);
}

/// What a process that was killed has left goes with the next one that writes the file; all else stays.
TEST(WholeFile, RemovesWhatKilledProcessesHaveLeft) {
  const TemporaryFolder folder;
  const pid_t ended = fork();
  if (ended == 0)
    _exit(0);
  waitpid(ended, nullptr, 0);
  const auto mine = {fmt::format("a.tmp{}", getppid()), std::string("a.tmp"),
                     fmt::format("a.tmp{}.msh", ended), fmt::format("a.tmp{}x", ended),
                     fmt::format("b.tmp{}", ended),     std::string("a.tmp-1")};
  for (const std::string& name : mine)
    folder.write(name, "mine");
  folder.write(fmt::format("a.tmp{}", ended), "half");
  write_whole(folder / "a", write_word);
  EXPECT_FALSE(fs::exists(folder / fmt::format("a.tmp{}", ended)));
  for (const std::string& name : mine)
    EXPECT_TRUE(fs::exists(folder / name)) << name;
  { const WholeFile mesh(folder / "a", ".msh"); }
  EXPECT_FALSE(fs::exists(folder / fmt::format("a.tmp{}.msh", ended)));
}

TEST(WholeFile, ARenameThatFailsLeavesNothing) {
  const TemporaryFolder folder;
  folder.write("a/b", "a folder took the name");
  {
    const WholeFile whole(folder / "a");
    folder.write(whole.temporary().filename(), "new");
    EXPECT_THAT(fault_of([&] { whole.commit(); }), HasSubstr("cannot be written"));
  }
  EXPECT_EQ(files_in(folder / ""), 1);
}

TEST(OutputFile, FollowsALinkAndReplacesItsTarget) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "far");
  const fs::path target = folder.write("far/target", "old"), link = folder / "link",
                 second = folder / "second";
  fs::create_symlink("far/target", link);
  fs::create_symlink(link, second);
  for (const auto& write : {write_text, write_whole}) {
    write(second, write_word);
    EXPECT_TRUE(fs::is_symlink(link) && fs::is_symlink(second));
    EXPECT_FALSE(fs::is_symlink(target));
    EXPECT_EQ(text_of(target), "word");
    fs::remove(target); // the second round makes what the link leads to
  }
  fs::create_symlink("round", folder / "round");
  EXPECT_THAT(message_of([&] { write_text(folder / "round", write_word); }), HasSubstr("back to itself"));
}

TEST(OutputFile, WritesTextThroughAPipe) {
  const TemporaryFolder folder;
  const fs::path pipe = folder / "pipe", link = folder / "link";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  fs::create_symlink("pipe", link);
  for (const fs::path& name : {pipe, link}) {
    std::string read;
    std::thread reader([&] { read = text_of(pipe); });
    write_text(name, write_word);
    reader.join();
    EXPECT_EQ(read, "word");
    EXPECT_TRUE(fs::is_fifo(pipe));
  }
  for (const fs::path& name : {pipe, link})
    EXPECT_THAT(message_of([&] { write_whole(name, write_word); }), HasSubstr("a device or a pipe"));
  EXPECT_TRUE(fs::is_fifo(pipe));
}

/// Nodes of our own with the numbers of /dev/null and /dev/full: those of the machine are left alone.
TEST(OutputFile, WritesTextThroughADevice) {
  const TemporaryFolder folder;
  const fs::path null = folder / "null", full = folder / "full";
  if (mknod(null.c_str(), S_IFCHR | 0600, makedev(1, 3)) != 0 ||
      mknod(full.c_str(), S_IFCHR | 0600, makedev(1, 7)) != 0)
    GTEST_SKIP() << "only root can make a device";
  write_text(null, write_word);
  EXPECT_TRUE(fs::is_character_file(null));
  EXPECT_THAT(fault_of([&] { write_text(full, write_word); }),
              AllOf(StartsWith("The file"), HasSubstr("No space left")));
  EXPECT_TRUE(fs::is_character_file(full));
  EXPECT_THAT(message_of([&] { write_whole(null, write_word); }), HasSubstr("a device or a pipe"));
  EXPECT_TRUE(fs::is_character_file(null));
  EXPECT_EQ(files_in(folder / ""), 2);
  const fs::path disk = folder / "disk"; // no driver has these numbers; nothing opens it
  ASSERT_EQ(mknod(disk.c_str(), S_IFBLK | 0600, makedev(240, 0)), 0);
  EXPECT_THAT(message_of([&] { write_text(disk, write_word); }), HasSubstr("it is a disk"));
}

TEST(OutputFile, WhatIsOpenUnderANumberIsWrittenThrough) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const fs::path name = "/proc/self/fd/" + std::to_string(ends[1]);
  write_text(name, write_word);
  close(ends[1]);
  std::string read(10, ' ');
  read.resize(static_cast<std::size_t>(::read(ends[0], read.data(), read.size())));
  close(ends[0]);
  EXPECT_EQ(read, "word");
}

TEST(OutputFile, RefusesWhatCannotBeWrittenBeforeAnythingIsComputed) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("read-only", "old");
  fs::permissions(file, fs::perms::owner_read);
  fs::create_symlink("read-only", folder / "link");
  for (const auto form : {OutputForm::text, OutputForm::whole_file}) {
    const auto refused = [&](const fs::path& output) {
      return message_of([&] { output_target(output, form); });
    };
    EXPECT_THAT(refused(file), AllOf(HasSubstr("protected from writing"), HasSubstr("read-only")));
    EXPECT_THAT(refused(folder / "link"), HasSubstr("protected from writing"));
    EXPECT_THAT(refused(folder / "none/a"), HasSubstr("there is no folder"));
    EXPECT_THAT(refused(folder / "."), HasSubstr("it is a folder"));
    EXPECT_THAT(refused(folder / "read-only/a"), HasSubstr("there is no folder"));
    EXPECT_THAT(refused(""), HasSubstr("no file"));
    EXPECT_THAT(refused("-"), HasSubstr("not the standard output"));
    EXPECT_EQ(refused(folder / "new"), "no error");
  }
  EXPECT_EQ(text_of(file), "old");
}

/// 255 bytes are allowed, and the temporary name needs some of them.
TEST(OutputFile, NamesMayBeAsLongAsTheSystemAllows) {
  const TemporaryFolder folder;
  for (const std::size_t length : {240u, 250u, 255u}) {
    const fs::path file = folder / std::string(length, 'a');
    for (const auto& write : {write_text, write_whole}) {
      write(file, write_word);
      EXPECT_EQ(text_of(file), "word");
    }
    EXPECT_EQ(files_in(folder.path()), 1) << length;
    fs::remove(file);
  }
  for (const auto form : {OutputForm::text, OutputForm::whole_file})
    for (const fs::path& file : {folder / std::string(256, 'a'), folder / std::string(300, 'a'),
                                 folder / std::string(5000, 'a'), folder / std::string(300, 'a') / "b"})
      EXPECT_THAT(message_of([&] {
                    require_outputs({folder / "input"}, {{"--csv", file, form}});
                  }),
                  HasSubstr("cannot be written (the name is too long)"));
}

/// By whatever name: another spelling, a link, a hard link, a link to a file that is not there yet.
TEST(OutputFile, RefusesToOverwriteAnInputOrAnotherOutput) {
  const TemporaryFolder folder;
  const fs::path input = folder.write("scene.toml", "mine");
  fs::create_symlink("scene.toml", folder / "link");
  fs::create_hard_link(input, folder / "hard");
  fs::create_symlink("later", folder / "to_later");
  const auto refused = [&](const std::vector<Output>& outputs) {
    return message_of([&] { require_outputs({"", input}, outputs); });
  };
  for (const fs::path& name : {input, folder / "./scene.toml", folder / "link", folder / "hard"})
    EXPECT_EQ(refused({{"--csv", name}}), "The output '" + name.string() + "' of --csv would overwrite '" +
                                              input.string() +
                                              "' (this run reads it) Give the output another name.");
  for (const fs::path& name : {folder / "later", folder / "to_later"})
    EXPECT_EQ(refused({{"--output", folder / "later", OutputForm::whole_file}, {"--csv", name}}),
              "The output '" + name.string() + "' of --csv would overwrite '" + (folder / "later").string() +
                  "' (it is the output of --output) Give the output another name.");
  EXPECT_THAT(refused({{"--csv", folder / "none/a"}}), HasSubstr("there is no folder"));
  EXPECT_THAT(refused({{"--output", "", OutputForm::text, true}}), HasSubstr("it names no file"));
  EXPECT_EQ(refused({{"--output", ""}, {"--csv", ""}, {"--vtk", folder / "new"}}), "no error");
  EXPECT_EQ(text_of(input), "mine");
}

TEST(OutputFile, RefusesASocket) {
  const TemporaryFolder folder;
  const fs::path name = folder / "socket";
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  name.string().copy(address.sun_path, sizeof address.sun_path - 1);
  const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
  ASSERT_EQ(bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  EXPECT_THAT(message_of([&] { write_text(name, write_word); }), HasSubstr("it is a socket"));
  close(socket);
}

} // namespace
} // namespace bem_contact
