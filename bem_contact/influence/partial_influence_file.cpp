#include "bem_contact/influence/partial_influence_file.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/sha256.hpp"

#include <cstring>
#include <fmt/format.h>
#include <map>

namespace bem_contact {
namespace {

/// 1. Error figures that a wavenumber may have in the file of finished ones: more mean a damaged file.
constexpr std::size_t most_errors = 1000;

constexpr JournalKind journals = wavenumber_journals("conformal-contact partial influence 3\n");

template <class T> void append(std::string& bytes, std::span<const T> data) {
  bytes.append(reinterpret_cast<const char*>(data.data()), data.size_bytes());
}

std::string digest_of(const std::string& fingerprint, std::size_t stations,
                      std::span<const double> wavenumber) {
  std::string all = fmt::format("{} {} {} ", fingerprint, stations, wavenumber.size());
  append(all, wavenumber);
  return sha256(all);
}

} // namespace

/// The records of the journal: [u64 k][kernel's lower triangle, remote, remote_self, errors].
struct PartialInfluenceFile::Impl {
  std::size_t rows; ///< 3 NS
  std::vector<double> wavenumber;
  std::size_t in_order = 0; ///< wavenumbers that these four have
  std::vector<double> kernel, remote, remote_self, errors;
  std::map<std::size_t, std::vector<double>> waiting; ///< for those before them
  SealedJournal journal;

  Impl(const std::filesystem::path& file, const std::string& fingerprint, std::size_t stations,
       std::span<const double> wavenumbers)
      : rows(3 * stations), wavenumber(wavenumbers.begin(), wavenumbers.end()),
        kernel(wavenumber.size() * lower_size(rows)),
        journal(file, journals, digest_of(fingerprint, stations, wavenumbers),
                [this](std::string_view record) { read(record); }) {}
  std::size_t numbers() const { return lower_size(rows) + 6 * rows + 36; } ///< without errors
  void keep(std::size_t k, std::vector<double> part) {
    if (k < in_order)
      return;
    waiting[k] = std::move(part);
    for (auto next = waiting.begin(); next != waiting.end() && next->first == in_order;
         next = waiting.erase(next), ++in_order) {
      auto from = next->second.begin();
      const auto take = [&](std::vector<double>& to, std::size_t count) {
        to.insert(to.end(), from, from + static_cast<std::ptrdiff_t>(count));
        from += static_cast<std::ptrdiff_t>(count);
      };
      for (std::size_t entry = 0; entry < lower_size(rows); ++entry)
        kernel[entry * wavenumber.size() + in_order] = *from++;
      take(remote, 6 * rows);
      take(remote_self, 36);
      take(errors, static_cast<std::size_t>(next->second.end() - from));
    }
  }
  void read(std::string_view record) {
    std::uint64_t k = 0;
    if (record.size() < sizeof k + numbers() * sizeof(double))
      return; // sealed, but no record of these stations: it counts as missing
    std::vector<double> values(record.size() / sizeof(double) - 1);
    std::memcpy(&k, record.data(), sizeof k);
    if (k >= wavenumber.size() || values.size() > numbers() + most_errors)
      return;
    std::memcpy(values.data(), record.data() + sizeof k, values.size() * sizeof(double));
    keep(k, std::move(values));
  }
};

PartialInfluenceFile::PartialInfluenceFile(const std::filesystem::path& file, const std::string& fingerprint,
                                           std::size_t stations, std::span<const double> wavenumber)
    : impl_(std::make_unique<Impl>(file.string() + ".part", fingerprint, stations, wavenumber)) {}

PartialInfluenceFile::~PartialInfluenceFile() = default;

bool PartialInfluenceFile::has(std::size_t k) const {
  return k < impl_->in_order || impl_->waiting.contains(k);
}

void PartialInfluenceFile::write(std::size_t k, std::vector<double> numbers) {
  const std::size_t needed = impl_->numbers();
  if (k >= impl_->wavenumber.size() || numbers.size() < needed || numbers.size() > needed + most_errors)
    throw Error("A wavenumber's numbers do not fit the partial influence file", "wrong index or size",
                "Report this as a bug.");
  const std::uint64_t number = k;
  std::string record;
  append(record, std::span(&number, 1));
  append(record, std::span<const double>(numbers));
  impl_->journal.append(record);
  impl_->keep(k, std::move(numbers));
}

void PartialInfluenceFile::take_into(InfluenceFunction& function, std::vector<double>& errors) {
  const std::size_t count = impl_->wavenumber.size();
  if (impl_->in_order < count)
    throw InputError("The influence functions are not complete",
                     "wavenumber " + std::to_string(impl_->in_order) + " of " + std::to_string(count) +
                         " is missing in '" + impl_->journal.file().string() + "'",
                     "Run fem_influence again: it goes on where it stopped.");
  function.wavenumber = impl_->wavenumber;
  function.kernel = std::move(impl_->kernel);
  function.remote = std::move(impl_->remote);
  function.remote_self = std::move(impl_->remote_self);
  errors = std::move(impl_->errors);
}

void PartialInfluenceFile::remove() {
  impl_->journal.remove();
}

} // namespace bem_contact
