#include "bem_contact/h5/table.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/base/system/files.hpp"
#include "bem_contact/h5/dataset.hpp"
#include "bem_contact/h5/entries.hpp"
#include "bem_contact/h5/handle.hpp"
#include "bem_contact/h5/hdf5_functions.hpp"
#include "bem_contact/h5/image.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <functional>
#include <ostream>
#include <system_error>
#include <utility>

namespace bem_contact {

namespace {

/// bytes. Disk space that an object may take besides its values, and all tables of a file: more than headers
/// and indices do take.
constexpr std::size_t object_bytes = 4096, table_bytes = 1 << 18;

/// Levels of groups. Ours have five; HDF5 takes the third power of their number to visit them. Chosen.
constexpr std::ptrdiff_t most_levels = 30;

[[noreturn]] void refuse_reading(const std::filesystem::path& file) {
  throw InputError("The file '" + file.string() + "' cannot be read", "it is not HDF5, or truncated",
                   "Name a result or an influence file, or make it again.");
}

H5Handle opened(const std::filesystem::path& file) {
  if (!is_regular(file))
    throw InputError("The file '" + file.string() + "' cannot be read",
                     file_exists(file) ? "it is a folder or a device" : "there is no such file",
                     file_exists(file) ? "Name a file, such as wear.h5 in the folder of bem_contact wear."
                                       : "Check the path.");
  H5Handle root = open_h5(file, H5Access::read);
  if (root < 0)
    refuse_reading(file);
  return root;
}

/// That a dataset or a text takes here.
std::size_t bytes_at(const H5Table& table, const std::string& path) {
  const auto numbers = table.datasets.find(path);
  const auto text = table.texts.find(path);
  return (numbers == table.datasets.end() ? 0 : sizeof(double) * numbers->second.values.size()) +
         (text == table.texts.end() ? 0 : text->second.text.size());
}

/// What lies below `root`. False where HDF5 fails.
bool read_below(hid_t root, const std::function<bool(const std::string&)>& wanted, H5Table& table) {
  std::map<std::string, H5O_type_t> found;
  const auto add = [](hid_t, const char* name, const auto* info, void* data) -> herr_t {
    static_cast<std::map<std::string, H5O_type_t>*>(data)->emplace(name, info->type);
    return std::ranges::count(std::string_view(name), '/') < most_levels ? 0 : -1;
  };
  // In the order of the file: to sort, HDF5 1.10.8 makes a list, and frees it unwritten where a link is
  // damaged.
  bool whole = H5Ovisit2(root, H5_INDEX_NAME, H5_ITER_NATIVE, add, &found, H5O_INFO_BASIC) >= 0;
  table.checksums = true;
  std::size_t bytes = 0; // many small files of what is deflated in this one
  for (const auto& [path, kind] : found)
    if (!whole)
      break;
    else if (kind == H5O_TYPE_GROUP)
      whole = read_attributes(root, path, table);
    else if (kind == H5O_TYPE_DATASET &&
             wanted(path)) // to open what is not wanted took as long as to visit it
      whole = read_dataset(root, path, table) && (bytes += bytes_at(table, path)) <= most_inflated(root);
  return whole;
}

[[noreturn]] void refuse_as_damaged(const std::filesystem::path& file, const std::string& why) {
  throw InputError("The file '" + file.string() + "' is damaged", why,
                   "Copy it again from where it was whole, or make it again.");
}

/// `count`: nothing for one or more.
void require_size(const std::filesystem::path& file, const std::string& name, std::size_t size,
                  std::optional<std::size_t> count) {
  if (size != count.value_or(std::max<std::size_t>(size, 1)))
    refuse_as_damaged(file, "its dataset '" + name + "' has " + std::to_string(size) + " numbers, not " +
                                (count ? std::to_string(*count) : "one or more"));
}

} // namespace

void add_group(H5Table& table, const std::string& group, const H5Table& members) {
  for (const auto& [name, data] : members.datasets)
    table.datasets[group + name] = data;
  for (const auto& [name, value] : members.attributes)
    table.attributes[group + name] = value;
  for (const auto& [name, text] : members.texts)
    table.texts[group + name] = text;
}

std::string text_attribute(const H5Table& table, const std::string& name) {
  const auto at = table.attributes.find(name);
  const auto* text = at == table.attributes.end() ? nullptr : std::get_if<std::string>(&at->second);
  return text ? *text : std::string();
}

const H5Dataset& dataset_of(const H5Table& table, const std::string& name, const std::filesystem::path& file,
                            std::optional<std::size_t> count) {
  const auto found = table.datasets.find(name);
  if (found == table.datasets.end())
    refuse_as_damaged(file, "it has no dataset '" + name + "'");
  require_size(file, name, found->second.values.size(), count);
  return found->second;
}

void write_h5(const std::filesystem::path& file, const H5Table& table) {
  const QuietHdf5 silence;
  const H5Image image({.checksums = table.checksums}, [&](hid_t root) { write_entries(root, table, file); });
  write_whole(file, [&](std::ostream& out) { out << image; });
}

std::string h5_bytes(const H5Table& table) {
  const QuietHdf5 silence;
  const H5Image image({.checksums = table.checksums},
                      [&](hid_t root) { write_entries(root, table, "the answer"); });
  return {image.bytes().begin(), image.bytes().end()};
}

H5Table read_h5_where(const std::filesystem::path& file,
                      const std::function<bool(const std::string&)>& wanted) {
  const QuietHdf5 silence;
  const H5Handle root = opened(file);
  H5Table table;
  if (!read_below(root, wanted, table))
    refuse_reading(file);
  return table;
}

H5Table read_h5(const std::filesystem::path& file) {
  return read_h5_where(file, [](const std::string&) { return true; });
}

H5Table read_h5_top(const std::filesystem::path& file, const std::string& but) {
  return read_h5_where(file, [&](const std::string& path) {
    return path.find('/') == std::string::npos || (!but.empty() && path.starts_with(but + "/"));
  });
}

struct H5Writer::Impl {
  /// A dataset that grows. A chunk is written once it is full, because it is deflated as a whole.
  struct Line {
    std::size_t size = 0, written = 0;
    std::vector<double> next = {}; ///< not written yet
  };

  WholeFile whole;
  int descriptor = -1;
  hid_t root = -1;
  std::map<std::string, Line> lines;

  explicit Impl(const std::filesystem::path& file)
      : whole(output_target(file, OutputForm::whole_file).file) {}
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() {
    const QuietHdf5 silence;
    if (root >= 0)
      H5Fclose(root);
    if (descriptor >= 0)
      system::close_file(descriptor);
  }

  void check(bool success, const std::string& what) const { check_writing(success, whole.file(), what); }

  /// Asks the file system for the space that `values` doubles in `objects` datasets and attributes may take:
  /// after a failed write to a full disk HDF5 can neither close its file nor end the process in order.
  void reserve(std::size_t values, std::size_t objects) const {
    hsize_t used = 0;
    if (root >= 0)
      H5Fget_filesize(root, &used);
    const std::size_t bytes = table_bytes + object_bytes * objects + sizeof(double) * values;
    const bool reserved = system::reserve(descriptor, used, bytes);
    check(reserved, std::generic_category().message(errno));
  }

  /// As in an image: a chunk in the older layout takes kilobytes besides, and its place has no checksum.
  void ask_for_checksums() const { H5Fset_libver_bounds(root, H5F_LIBVER_V110, H5F_LIBVER_V110); }

  void write_chunk(const std::string& name, Line& line) const {
    reserve(line.next.size(), 1);
    check(write_rows(root, name, line.written, line.next), "dataset " + name);
    line.written += std::exchange(line.next, {}).size();
  }

  /// Gives back what was reserved and is not needed: most of a small file.
  void cut_off_reserve() {
    std::array<char, superblock_bytes> superblock{};
    check(system::read_begin(descriptor, superblock) &&
              system::set_size(descriptor, end_of_file(superblock.data())),
          "its end cannot be cut off");
    system::close_file(std::exchange(descriptor, -1)); // some systems rename no file that is open
  }
};

H5Writer::H5Writer(const std::filesystem::path& file) : impl_(std::make_unique<Impl>(file)) {
  const QuietHdf5 silence;
  const std::filesystem::path& temporary = impl_->whole.temporary();
  const H5Image empty({}, [](hid_t) {});
  write_whole(temporary, [&](std::ostream& out) { out << empty; });
  impl_->descriptor = system::open_file(temporary, system::OpenFor::changing);
  impl_->root = open_h5(temporary, H5Access::change).release();
  impl_->check(impl_->descriptor >= 0 && impl_->root >= 0, "it cannot be created");
}

H5Writer::~H5Writer() = default;

void H5Writer::add(const H5Table& table) {
  const QuietHdf5 silence;
  std::size_t values = 0;
  for (const auto& [name, data] : table.datasets)
    values += data.values.size();
  for (const auto& [name, value] : table.attributes)
    if (const auto* text = std::get_if<std::string>(&value))
      values += text->size() / sizeof(double) + 1;
  for (const auto& [name, data] : table.texts)
    values += data.text.size() / sizeof(double) + 1;
  if (table.checksums)
    impl_->ask_for_checksums();
  impl_->reserve(values, 3 * (table.datasets.size() + table.texts.size()) + table.attributes.size());
  write_entries(impl_->root, table, impl_->whole.file());
}

void H5Writer::add_line(const std::string& name, std::size_t size, const H5Dataset& form) {
  const QuietHdf5 silence;
  impl_->ask_for_checksums();
  std::size_t text = 0;
  for (const std::string& choice : form.choices)
    text += choice.size() + 1;
  impl_->reserve(text / sizeof(double), 3 + size / rows_of_a_chunk);
  impl_->check(write_empty_line(impl_->root, name, size) && write_words(impl_->root, name, form),
               "dataset " + name);
  impl_->lines[name] = {.size = size};
}

void H5Writer::put(const std::string& name, std::span<const double> values) {
  const QuietHdf5 silence;
  Impl::Line& line = impl_->lines.at(name);
  impl_->check(values.size() <= line.size - line.written - line.next.size(),
               "the dataset " + name + " has not so many numbers");
  while (!values.empty()) {
    const auto some = values.first(std::min(values.size(), rows_of_a_chunk - line.next.size()));
    line.next.insert(line.next.end(), some.begin(), some.end());
    if (line.next.size() == rows_of_a_chunk || line.written + line.next.size() == line.size)
      impl_->write_chunk(name, line);
    values = values.subspan(some.size());
  }
}

void H5Writer::finish() {
  const QuietHdf5 silence;
  for (const auto& [name, line] : impl_->lines)
    impl_->check(line.written == line.size, "numbers of the dataset " + name + " are missing");
  impl_->check(H5Fflush(impl_->root, H5F_SCOPE_GLOBAL) >= 0, "its contents cannot be flushed");
  H5Fclose(std::exchange(impl_->root, -1));
  impl_->cut_off_reserve();
  impl_->whole.commit();
}

H5Reader::H5Reader(std::filesystem::path file)
    : file_(std::move(file)), root_([this] {
        const QuietHdf5 silence;
        return opened(file_);
      }()) {}

void H5Reader::refuse() const {
  refuse_reading(file_);
}

bool H5Reader::has(const std::string& path) const {
  for (std::size_t slash = path.find('/');; slash = path.find('/', slash + 1)) {
    H5L_info_t link; // another kind of link may lead to another file, and that may be a pipe
    if (H5Lget_info(root_, path.substr(0, slash).c_str(), &link, H5P_DEFAULT) < 0 ||
        link.type != H5L_TYPE_HARD)
      return false;
    if (slash == std::string::npos)
      return true;
  }
}

H5Table H5Reader::group(const std::string& path) const {
  const QuietHdf5 silence;
  H5Table table;
  if (!has(path))
    return table;
  const H5Handle group(H5Gopen2(root_, path.c_str(), H5P_DEFAULT), H5Gclose);
  if (group < 0 || !read_below(
                       group, [](const std::string&) { return true; }, table))
    refuse();
  return table;
}

H5Table H5Reader::attributes() const {
  const QuietHdf5 silence;
  H5Table table;
  if (!read_attributes(root_, ".", table))
    refuse();
  return table;
}

std::set<std::string> H5Reader::members(const std::string& path) const {
  const QuietHdf5 silence;
  std::set<std::string> names;
  const auto add = [](hid_t, const char* name, const H5L_info_t*, void* data) -> herr_t {
    static_cast<std::set<std::string>*>(data)->emplace(name);
    return 0;
  };
  if (has(path) && H5Literate_by_name(root_, path.c_str(), H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, add,
                                      &names, H5P_DEFAULT) < 0)
    refuse();
  return names;
}

std::string H5Reader::text(const std::string& path, const std::string& name) const {
  const QuietHdf5 silence;
  H5Table table;
  if (has(path) && !read_attributes(root_, path, table))
    refuse();
  return text_attribute(table, path + "/" + name);
}

double H5Reader::number(const std::string& name) const {
  const QuietHdf5 silence;
  H5Table table;
  if (has(name) && !read_dataset(root_, name, table))
    refuse();
  const auto found = table.datasets.find(name);
  return found != table.datasets.end() && found->second.values.size() == 1 ? found->second.values.front()
                                                                           : std::nan("");
}

std::size_t H5Reader::size(const std::string& name) const {
  const QuietHdf5 silence;
  return has(name) ? numbers_in(root_, name).value_or(0) : 0;
}

void H5Reader::require(const std::string& name, std::size_t count) const {
  const QuietHdf5 silence;
  if (!has(name))
    refuse_as_damaged(file_, "it has no dataset '" + name + "'");
  require_size(file_, name, size(name), count);
}

std::vector<double> H5Reader::line(const std::string& name, std::size_t first, std::size_t count) const {
  const QuietHdf5 silence;
  std::vector<double> values(count);
  if (!read_rows(root_, name, first, values))
    refuse_as_damaged(file_, "its dataset '" + name + "' cannot be read");
  return values;
}

} // namespace bem_contact
