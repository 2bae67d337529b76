#include "bem_contact/influence/partial_influence_file.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/influence/file_seal.hpp"
#include "bem_contact/influence/settings.hpp"

#include <cstring>
#include <fstream>
#include <map>

namespace bem_contact {
namespace {

constexpr std::string_view magic = "conformal-contact partial influence 2\n";
constexpr std::size_t digest_size = 64; // bytes

template <class T> void append(std::string& bytes, const T* data, std::size_t count) {
  bytes.append(reinterpret_cast<const char*>(data), count * sizeof(T));
}

} // namespace

/// The file: a header (magic, fingerprint, sizes, wavenumbers), then records of
/// [u64 k][u64 errors][kernel's lower triangle, remote, remote_self, errors][SHA-256 of all before it, 64
/// characters], in the machine's own byte order. A record that a kill left unfinished is cut off when the
/// file is opened again.
struct PartialInfluenceFile::Impl {
  std::filesystem::path path;
  std::size_t rows = 0; ///< 3 NS
  std::vector<double> wavenumber;
  std::size_t in_order = 0; ///< wavenumbers that these four have
  std::vector<double> kernel, remote, remote_self, errors;
  std::map<std::size_t, std::vector<double>> waiting; ///< for those before them
  std::ofstream out;

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
      take(kernel, lower_size(rows));
      take(remote, 6 * rows);
      take(remote_self, 36);
      take(errors, static_cast<std::size_t>(next->second.end() - from));
    }
  }
  /// Whether an existing file `found` that does not begin with `header` may be written over. Throws
  /// InputError if it holds anything more than a header: another body's finished wavenumbers, or what is not
  /// ours.
  void require_nothing_finished(std::string_view found, std::string_view header) const {
    if (header.starts_with(found)) // a kill left the header unfinished
      return;
    const bool ours = found.starts_with(magic);
    std::uint64_t sizes[3]; // as the constructor writes them
    if (ours && found.size() >= magic.size() + sizeof sizes) {
      std::memcpy(sizes, found.data() + magic.size(), sizeof sizes);
      if (found.size() <= magic.size() + sizeof sizes + sizes[0] + sizes[2] * sizeof(double))
        return;
    }
    throw InputError(
        "'" + path.string() + "' would be written over",
        ours ? "it holds finished wavenumbers of another body, mesh or program version"
             : "it holds no finished wavenumbers of fem_influence",
        "To keep it, give another output with -o, or the body and mesh that it belongs to. To begin "
        "anew, remove it.");
  }
  /// Keeps the records of an existing file that begins with `header`. Returns how many of its bytes are
  /// whole.
  std::size_t read_records(const std::string& header) {
    std::string found;
    if (std::ifstream in(path, std::ios::binary); in)
      found.assign(std::istreambuf_iterator<char>(in), {});
    if (!found.starts_with(header)) {
      require_nothing_finished(found, header);
      return 0;
    }
    std::size_t good = header.size();
    while (found.size() - good >= 2 * sizeof(std::uint64_t)) {
      std::uint64_t head[2];
      std::memcpy(head, found.data() + good, sizeof head);
      if (head[0] >= wavenumber.size() || head[1] > most_errors)
        break;
      const std::size_t count = numbers() + head[1], body = sizeof head + count * sizeof(double);
      if (found.size() - good < body + digest_size)
        break;
      const std::string_view record = std::string_view(found).substr(good, body);
      if (sha256(record) != std::string_view(found).substr(good + body, digest_size))
        break;
      std::vector<double> values(count);
      std::memcpy(values.data(), record.data() + sizeof head, count * sizeof(double));
      keep(head[0], std::move(values));
      good += body + digest_size;
    }
    return good;
  }
  [[noreturn]] void fail(const char* why) const {
    throw Error("the file of finished wavenumbers '" + path.string() + "' cannot be written", why,
                "Check that its folder exists and has room.");
  }
};

PartialInfluenceFile::PartialInfluenceFile(std::filesystem::path file, std::string fingerprint,
                                           std::size_t stations, std::span<const double> wavenumber)
    : impl_(std::make_unique<Impl>()) {
  file += ".part";
  impl_->path = output_target(file, OutputForm::whole_file).file;
  impl_->rows = 3 * stations;
  impl_->wavenumber.assign(wavenumber.begin(), wavenumber.end());
  impl_->kernel.reserve(wavenumber.size() * lower_size(impl_->rows)); // growing it would copy it

  std::string header(magic);
  const std::uint64_t sizes[] = {fingerprint.size(), stations, wavenumber.size()};
  append(header, sizes, 3);
  header += fingerprint;
  append(header, wavenumber.data(), wavenumber.size());

  const std::size_t good = impl_->read_records(header);
  if (good > 0) {
    std::error_code error;
    std::filesystem::resize_file(impl_->path, good, error);
    if (error)
      impl_->fail(error.message().c_str());
    impl_->out.open(impl_->path, std::ios::binary | std::ios::app);
  } else {
    impl_->out.open(impl_->path, std::ios::binary | std::ios::trunc);
    impl_->out << header << std::flush;
  }
  if (!impl_->out)
    impl_->fail("it cannot be opened for writing");
}

PartialInfluenceFile::~PartialInfluenceFile() = default;

bool PartialInfluenceFile::has(std::size_t k) const {
  return k < impl_->in_order || impl_->waiting.contains(k);
}

void PartialInfluenceFile::write(std::size_t k, std::vector<double> numbers) {
  const std::size_t needed = impl_->numbers();
  if (k >= impl_->wavenumber.size() || numbers.size() < needed || numbers.size() > needed + most_errors)
    throw Error("a wavenumber's numbers do not fit the partial influence file", "wrong index or size",
                "report this as a bug");
  const std::uint64_t head[] = {k, numbers.size() - needed};
  const std::span<const std::byte> first = std::as_bytes(std::span(head)),
                                   rest = std::as_bytes(std::span(numbers));
  for (const auto bytes : {first, rest})
    impl_->out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  impl_->out << sha256({first, rest}) << std::flush;
  if (!impl_->out)
    impl_->fail("the disk may be full");
  impl_->keep(k, std::move(numbers));
}

void PartialInfluenceFile::take_into(InfluenceFunction& function, std::vector<double>& errors) {
  const std::size_t count = impl_->wavenumber.size();
  if (impl_->in_order < count)
    throw InputError("the influence functions are not complete",
                     "wavenumber " + std::to_string(impl_->in_order) + " of " + std::to_string(count) +
                         " is missing in '" + impl_->path.string() + "'",
                     "Run fem_influence again: it goes on where it stopped.");
  function.wavenumber = impl_->wavenumber;
  function.kernel = std::move(impl_->kernel);
  function.remote = std::move(impl_->remote);
  function.remote_self = std::move(impl_->remote_self);
  errors = std::move(impl_->errors);
}

void PartialInfluenceFile::remove() {
  impl_->out.close();
  std::error_code ignored;
  std::filesystem::remove(impl_->path, ignored);
}

} // namespace bem_contact
