#include "bem_contact/base/sealed_journal.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/file_lock.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/base/sha256.hpp"
#include "bem_contact/base/system/files.hpp"

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fmt/format.h>
#include <fstream>

namespace bem_contact {

namespace {

std::string header_of(const JournalKind& kind, const std::string& digest) {
  return fmt::format("{}{}\n", kind.magic, digest);
}

[[noreturn]] void fail_writing(const std::filesystem::path& file) {
  throw Error(fmt::format("The file '{}' cannot be written", file.string()), std::strerror(errno),
              "Make room: the disk may be full. What was finished before is kept.");
}

} // namespace

std::size_t read_journal(const std::filesystem::path& file, const JournalKind& kind,
                         const std::string& digest, const RecordReader& seen) {
  if (!is_regular(file)) // before it is opened, because a pipe would wait
    return 0;
  std::ifstream in(file, std::ios::binary);
  if (!in)
    return 0;
  std::error_code unknown;
  const std::size_t size = std::filesystem::file_size(file, unknown);
  if (unknown)
    return 0;
  const std::string header = header_of(kind, digest);
  std::string found(header.size(), '\0');
  in.read(found.data(), static_cast<std::streamsize>(found.size()));
  found.resize(static_cast<std::size_t>(in.gcount()));
  const bool ours = found.starts_with(kind.magic);
  if (found != header) {
    if (header.starts_with(found) || (ours && size <= header.size()))
      return 0; // a kill left the header unfinished, or another run has finished nothing
    throw InputError(fmt::format("The file '{}' belongs to another {}", file.string(), kind.owner),
                     ours ? kind.of_another : kind.of_nobody, kind.what_to_do);
  }
  for (std::size_t good = header.size();;) {
    std::uint64_t bytes = 0;
    in.read(reinterpret_cast<char*>(&bytes), sizeof bytes);
    if (!in || bytes > size - good) // nothing more, or a record that a kill left unfinished
      return good;
    std::string record(bytes, '\0'), seal(sha256_size, '\0');
    in.read(record.data(), static_cast<std::streamsize>(bytes));
    in.read(seal.data(), sha256_size);
    if (!in || sha256(record) != seal)
      return good;
    seen(record);
    good += sizeof bytes + bytes + sha256_size;
  }
}

bool is_journal(const std::filesystem::path& file, const JournalKind& kind) {
  if (!is_regular(file))
    return false;
  std::string first(kind.magic.size(), '\0');
  std::ifstream in(file, std::ios::binary);
  return in.read(first.data(), static_cast<std::streamsize>(first.size())) && first == kind.magic;
}

SealedJournal::SealedJournal(const std::filesystem::path& file, const JournalKind& kind,
                             const std::string& digest, const RecordReader& seen)
    : file_(output_target(file, OutputForm::whole_file).file) {
  handle_ = system::open_file(file_, system::OpenFor::changing);
  if (handle_ < 0)
    fail_writing(file_);
  try {
    warning_ = lock_file(handle_, file_, kind.if_in_use);
    const std::size_t good = read_journal(file_, kind, digest, seen);
    if (!system::set_size(handle_, good))
      fail_writing(file_);
    if (good == 0)
      write(header_of(kind, digest));
  } catch (...) {
    system::close_file(handle_);
    throw;
  }
}

SealedJournal::~SealedJournal() {
  system::close_file(handle_);
}

void SealedJournal::append(std::string_view record) {
  const std::uint64_t bytes = record.size();
  std::string out(reinterpret_cast<const char*>(&bytes), sizeof bytes);
  out += record;
  out += sha256(record);
  write(out);
}

void SealedJournal::write(std::string_view bytes) {
  if (!system::write_all(handle_, bytes))
    fail_writing(file_);
}

void SealedJournal::remove() {
  std::error_code ignored;
  std::filesystem::remove(file_, ignored);
}

} // namespace bem_contact
