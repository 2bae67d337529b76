// In place of all other sources of the room, where there is no HDF5. Influence files are read in a flat form,
// which browser/flat_influence.py writes: behind the seal for each entry its name, its kind and what it
// holds. All else is refused.
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/h5/image.hpp"
#include "bem_contact/h5/strict.hpp"
#include "bem_contact/h5/table.hpp"

#include <algorithm>
#include <cstring>
#include <functional>
#include <numeric>

namespace bem_contact {

namespace {

[[noreturn]] void refuse() {
  throw InputError("HDF5 files are neither read nor written here",
                   "this solver was built without HDF5, so there are no result files",
                   "Save the scene, and call bem_contact solve SCENE.toml -o RESULT.h5.");
}

std::recursive_mutex& nobodys() {
  static std::recursive_mutex mutex;
  return mutex;
}

} // namespace

QuietHdf5::QuietHdf5() : turn_(nobodys()) {}
QuietHdf5::~QuietHdf5() = default;

H5Image::H5Image(const H5ImageForm&, const std::function<void(H5Id root)>&) {
  refuse();
}
std::ostream& operator<<(std::ostream&, const H5Image&) {
  refuse();
}

void write_h5(const std::filesystem::path&, const H5Table&) {
  refuse();
}
std::string h5_bytes(const H5Table&) {
  refuse();
}
H5Table read_h5(const std::filesystem::path&) {
  refuse();
}
H5Table read_h5_top(const std::filesystem::path&, const std::string&) {
  refuse();
}
H5Table read_h5_where(const std::filesystem::path&, const std::function<bool(const std::string&)>&) {
  refuse();
}

namespace strict_h5 {

namespace {

struct FlatTable {
  Shape shape;
  std::vector<double> values;
};
using FlatEntry = std::variant<double, std::uint64_t, std::string, FlatTable>;
using FlatFile = std::map<std::string, FlatEntry>;

[[noreturn]] void refuse_entry(const std::string& name) {
  throw InputError("The influence file's entry '" + name + "' is missing, or of another type or shape",
                   "data/INFLUENCE_FORMAT.md says what it must be", "Compute the influence file again.");
}

/// Takes one value after the other from a text.
class Bytes {
public:
  explicit Bytes(std::string_view rest) : rest_(rest) {}
  bool empty() const { return rest_.empty(); }
  std::string_view take(std::uint64_t count) {
    if (count > rest_.size())
      refuse_entry("beyond the end");
    const std::string_view out = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return out;
  }
  template <class Number> Number number() {
    Number out{};
    std::memcpy(&out, take(sizeof out).data(), sizeof out);
    return out;
  }
  std::string text() { return std::string(take(number<std::uint64_t>())); }

private:
  std::string_view rest_;
};

FlatTable table_in(Bytes& bytes) {
  FlatTable out{Shape(std::min<std::uint64_t>(bytes.number<std::uint64_t>(), 8)), {}};
  for (Extent& extent : out.shape)
    extent = bytes.number<std::uint64_t>();
  const Extent count = std::accumulate(out.shape.begin(), out.shape.end(), Extent{1}, std::multiplies<>());
  const std::string_view numbers = bytes.take(count * sizeof(double));
  out.values.resize(numbers.size() / sizeof(double));
  std::memcpy(out.values.data(), numbers.data(), numbers.size());
  return out;
}

FlatFile entries_in(std::string_view text) {
  constexpr std::size_t seal = 512; // bytes, as influence/file_seal.hpp
  FlatFile out;
  for (Bytes bytes(text.substr(std::min(seal, text.size()))); !bytes.empty();) {
    const std::string name = bytes.text();
    const char kind = bytes.take(1).front();
    if (kind == 'a')
      out[name] = table_in(bytes);
    else if (kind == 't')
      out[name] = bytes.text();
    else if (kind == 'i')
      out[name] = bytes.number<std::uint64_t>();
    else
      out[name] = bytes.number<double>();
  }
  return out;
}

/// What is open, by the number that stands for HDF5's.
std::map<H5Id, FlatFile>& open_files() {
  static std::map<H5Id, FlatFile> files;
  return files;
}

int close_file(H5Id id) {
  open_files().erase(id);
  return 0;
}

template <class Value> const Value& entry(H5Id at, const char* name) {
  const FlatFile& file = open_files().at(at);
  const auto found = file.find(name);
  const Value* value = found == file.end() ? nullptr : std::get_if<Value>(&found->second);
  if (!value)
    refuse_entry(name);
  return *value;
}

/// `shape`: the extents wanted, 0 where any will do.
const FlatTable& table_of(H5Id at, const char* name, const Shape& shape) {
  const FlatTable& table = entry<FlatTable>(at, name);
  if (!std::ranges::equal(table.shape, shape,
                          [](Extent found, Extent wanted) { return wanted == 0 || found == wanted; }))
    refuse_entry(name);
  return table;
}

} // namespace

Handle::Handle(H5Handle&& made, std::string_view) : H5Handle(std::move(made)) {}

Handle open_file(const std::filesystem::path& file) {
  const H5Id id = open_files().empty() ? 0 : open_files().rbegin()->first + 1;
  open_files()[id] = entries_in(read_text_file(file.string(), "influence file"));
  return {id, close_file, ""};
}
bool has(H5Id at, const char* name) {
  return open_files().at(at).contains(name);
}

void write(H5Id, const char*, double) {
  refuse();
}
void write(H5Id, const char*, int) {
  refuse();
}
void write(H5Id, const char*, std::uint64_t) {
  refuse();
}
void write(H5Id, const char*, const std::string&) {
  refuse();
}
void write(H5Id, const Table&) {
  refuse();
}
void write(H5Id, const FloatTable&) {
  refuse();
}

void read(H5Id at, const char* name, double& value) {
  value = entry<double>(at, name);
}
void read(H5Id at, const char* name, int& value) {
  value = static_cast<int>(entry<std::uint64_t>(at, name));
}
void read(H5Id at, const char* name, std::uint64_t& value) {
  value = entry<std::uint64_t>(at, name);
}
void read(H5Id at, const char* name, std::string& value) {
  value = entry<std::string>(at, name);
}

std::vector<double> read_table(H5Id at, const char* name, Shape shape) {
  return table_of(at, name, shape).values;
}

std::vector<float> read_floats(H5Id at, const char* name, Shape shape) {
  const std::vector<double>& values = table_of(at, name, shape).values;
  return {values.begin(), values.end()};
}

std::vector<double> read_columns(H5Id at, const char* name, Shape shape, std::span<const Columns> runs) {
  const FlatTable& table = table_of(at, name, shape);
  const Extent rows = table.shape[0], width = table.shape[1];
  std::vector<double> values;
  for (const Columns& run : runs)
    for (Extent column = run.first; column < run.first + run.count; ++column)
      for (Extent row = 0; row < rows; ++row)
        values.push_back(table.values[row * width + column]);
  return values;
}

} // namespace strict_h5

} // namespace bem_contact
