#include "bem_contact/app/sweep/sweep_journal.hpp"

#include "bem_contact/app/output/scene_record.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/influence/file_seal.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <fstream>
#include <string_view>

namespace bem_contact::app {

namespace {

constexpr std::string_view magic = "bem_contact sweep 2\n";
constexpr std::size_t digest_size = 64;

std::string header_of(const std::string& digest) {
  return std::string(magic) + digest + "\n";
}

void write_all(int handle, const std::string& bytes, const std::filesystem::path& file) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t n = ::write(handle, bytes.data() + done, bytes.size() - done);
    if (n < 0 && errno == EINTR)
      continue;
    if (n <= 0)
      throw Error(fmt::format("The file '{}' cannot be written", file.string()), std::strerror(errno),
                  "Check that the disk is not full; the cases finished before are kept.");
    done += static_cast<std::size_t>(n);
  }
}

} // namespace

std::size_t read_journal(const std::filesystem::path& file, const std::string& digest,
                         const std::function<void(const CaseRecord&)>& seen) {
  std::ifstream in(file, std::ios::binary);
  if (!in)
    return 0;
  const std::string header = header_of(digest);
  std::string found(header.size(), '\0');
  in.read(found.data(), static_cast<std::streamsize>(found.size()));
  found.resize(static_cast<std::size_t>(in.gcount()));
  if (found.size() < header.size() && header.starts_with(found))
    return 0; // a kill left the header unfinished
  if (found != header)
    throw InputError(fmt::format("The file '{}' belongs to another sweep", file.string()),
                     found.starts_with(magic) ? digest_changed : "it was not made by bem_contact sweep",
                     "Finish that sweep with what it began with, give another output, or remove the file.");
  std::size_t good = header.size();
  const std::size_t size = std::filesystem::file_size(file);
  for (;;) {
    std::uint64_t bytes = 0;
    in.read(reinterpret_cast<char*>(&bytes), sizeof bytes);
    if (!in || bytes > size - good) // nothing more, or a record that a kill left unfinished
      return good;
    std::string record(bytes, '\0'), seal(digest_size, '\0');
    in.read(record.data(), static_cast<std::streamsize>(bytes));
    in.read(seal.data(), digest_size);
    if (!in || sha256(record) != seal)
      return good;
    seen(from_bytes(record));
    good += sizeof bytes + bytes + digest_size;
  }
}

SweepJournal::SweepJournal(std::filesystem::path file, const std::string& digest,
                           const std::function<void(const CaseRecord&)>& seen)
    : file_(std::move(file)) {
  handle_ = open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (handle_ < 0)
    throw InputError(fmt::format("The file '{}' cannot be written", file_.string()), std::strerror(errno),
                     "Check that its folder exists and that you may write there.");
  if (flock(handle_, LOCK_EX | LOCK_NB) != 0) {
    close(handle_);
    throw InputError(fmt::format("The file '{}' is in use", file_.string()),
                     "another process is solving this sweep", "Wait for it, or solve another --part.");
  }
  try {
    const std::size_t good = read_journal(file_, digest, seen);
    if (ftruncate(handle_, static_cast<off_t>(good)) != 0 || lseek(handle_, 0, SEEK_END) < 0)
      throw Error(fmt::format("The file '{}' cannot be written", file_.string()), std::strerror(errno),
                  "Check that you may write there.");
    if (good == 0)
      write_all(handle_, header_of(digest), file_);
  } catch (...) {
    close(handle_);
    throw;
  }
}

SweepJournal::~SweepJournal() {
  close(handle_);
}

void SweepJournal::append(const std::string& record) {
  const std::uint64_t bytes = record.size();
  std::string out(reinterpret_cast<const char*>(&bytes), sizeof bytes);
  out += record;
  out += sha256(record);
  write_all(handle_, out, file_);
}

std::filesystem::path journal_name(const std::filesystem::path& output, int part, int parts) {
  return output.string() + (parts > 1 ? fmt::format(".part-{}-of-{}", part, parts) : ".part");
}

std::vector<std::filesystem::path> journals_of(const std::filesystem::path& output) {
  std::vector<std::filesystem::path> found;
  const std::filesystem::path folder = output.has_parent_path() ? output.parent_path() : ".";
  const std::string whole = output.filename().string() + ".part", parts = whole + "-";
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (name == whole || (name.starts_with(parts) && name.find("-of-") != std::string::npos))
      found.push_back(output.has_parent_path() ? entry.path() : entry.path().filename());
  }
  std::ranges::sort(found);
  return found;
}

} // namespace bem_contact::app
