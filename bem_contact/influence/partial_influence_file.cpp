#include "bem_contact/base/error.hpp"
#include "bem_contact/influence/file_seal.hpp"
#include "bem_contact/influence/influence_file.hpp"
#include "bem_contact/influence/lower_triangle.hpp"

#include <cstring>
#include <fstream>
#include <map>

namespace bem_contact {
namespace {

constexpr std::string_view magic = "conformal-contact partial influence 2\n";
constexpr std::size_t digest_size = 64;

template <class T> void append(std::string& bytes, const T* data, std::size_t count) {
  bytes.append(reinterpret_cast<const char*>(data), count * sizeof(T));
}

std::string digest_of(std::string_view bytes) {
  return sha256(std::as_bytes(std::span(bytes)));
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
  std::map<std::size_t, std::vector<double>> part;
  std::ofstream out;

  std::size_t numbers() const { return rows * (rows + 1) / 2 + 6 * rows + 36; }
  [[noreturn]] void fail(const char* why) const {
    throw InputError("the file of finished wavenumbers '" + path.string() + "' cannot be written", why,
                     "check that its folder exists and has room");
  }
};

PartialInfluenceFile::PartialInfluenceFile(std::filesystem::path file, std::string fingerprint,
                                           std::size_t stations, std::span<const double> wavenumber)
    : impl_(std::make_unique<Impl>()) {
  impl_->path = std::move(file);
  impl_->path += ".part";
  impl_->rows = 3 * stations;
  impl_->wavenumber.assign(wavenumber.begin(), wavenumber.end());

  std::string header(magic);
  const std::uint64_t sizes[] = {fingerprint.size(), stations, wavenumber.size()};
  append(header, sizes, 3);
  header += fingerprint;
  append(header, wavenumber.data(), wavenumber.size());

  std::string found;
  if (std::ifstream in(impl_->path, std::ios::binary); in)
    found.assign(std::istreambuf_iterator<char>(in), {});
  std::size_t good = 0; // bytes of the file that are whole
  if (found.starts_with(header)) {
    good = header.size();
    while (found.size() - good >= 2 * sizeof(std::uint64_t)) {
      std::uint64_t head[2];
      std::memcpy(head, found.data() + good, sizeof head);
      if (head[0] >= wavenumber.size() || head[1] > 1000)
        break;
      const std::size_t count = impl_->numbers() + head[1], body = sizeof head + count * sizeof(double);
      if (found.size() - good < body + digest_size)
        break;
      const std::string_view record = std::string_view(found).substr(good, body);
      if (digest_of(record) != std::string_view(found).substr(good + body, digest_size))
        break;
      std::vector<double> values(count);
      std::memcpy(values.data(), record.data() + sizeof head, count * sizeof(double));
      impl_->part[head[0]] = std::move(values);
      good += body + digest_size;
    }
  }
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
  return impl_->part.contains(k);
}

void PartialInfluenceFile::write(std::size_t k, std::span<const double> kernel,
                                 std::span<const double> remote, std::span<const double> remote_self,
                                 std::span<const double> errors) {
  const std::size_t n = impl_->rows;
  if (k >= impl_->wavenumber.size() || kernel.size() != n * n || remote.size() != 6 * n ||
      remote_self.size() != 36 || errors.size() > 1000)
    throw Error("a wavenumber's numbers do not fit the partial influence file", "wrong index or size",
                "report this as a bug");
  std::vector<double> values;
  values.reserve(impl_->numbers() + errors.size());
  append_lower(values, kernel, n);
  for (const auto piece : {remote, remote_self, errors})
    values.insert(values.end(), piece.begin(), piece.end());
  std::string record;
  const std::uint64_t head[] = {k, errors.size()};
  append(record, head, 2);
  append(record, values.data(), values.size());
  record += digest_of(record);
  impl_->out.write(record.data(), static_cast<std::streamsize>(record.size())).flush();
  if (!impl_->out)
    impl_->fail("the disk may be full");
  impl_->part[k] = std::move(values);
}

void PartialInfluenceFile::read_into(InfluenceFunction& function, std::vector<double>& errors) const {
  const std::size_t n = impl_->rows;
  function.wavenumber = impl_->wavenumber;
  function.kernel.clear();
  function.kernel.reserve(impl_->wavenumber.size() * n * n);
  function.remote.clear();
  function.remote_self.clear();
  errors.clear();
  for (std::size_t k = 0; k < impl_->wavenumber.size(); ++k) {
    const auto found = impl_->part.find(k);
    if (found == impl_->part.end())
      throw InputError("the influence functions are not complete",
                       "wavenumber " + std::to_string(k) + " of " + std::to_string(impl_->wavenumber.size()) +
                           " is missing in '" + impl_->path.string() + "'",
                       "run fem_influence again: it goes on where it stopped");
    auto from = found->second.begin();
    const auto take = [&](std::vector<double>& to, std::size_t count) {
      to.insert(to.end(), from, from + static_cast<std::ptrdiff_t>(count));
      from += static_cast<std::ptrdiff_t>(count);
    };
    const std::size_t lower = n * (n + 1) / 2, matrix = function.kernel.size();
    function.kernel.resize(matrix + n * n);
    fill_symmetric(std::span(function.kernel).subspan(matrix), std::span(found->second).first(lower), n);
    from += static_cast<std::ptrdiff_t>(lower);
    take(function.remote, 6 * n);
    take(function.remote_self, 36);
    errors.insert(errors.end(), from, found->second.end());
  }
}

void PartialInfluenceFile::remove() {
  impl_->out.close();
  std::error_code ignored;
  std::filesystem::remove(impl_->path, ignored);
}

} // namespace bem_contact
