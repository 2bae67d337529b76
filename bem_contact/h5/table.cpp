#include "bem_contact/h5/table.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/h5/entries.hpp"
#include "bem_contact/h5/handle.hpp"
#include "bem_contact/h5/image.hpp"

#include <algorithm>
#include <fcntl.h>
#include <functional>
#include <hdf5.h>
#include <ostream>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace bem_contact {

namespace {

/// bytes. Disk space that an object may take besides its values, and all tables of a file: more than headers
/// and indices do take.
constexpr std::size_t object_bytes = 4096, table_bytes = 1 << 18;

H5Table read_paths(const std::filesystem::path& file, const std::function<bool(const std::string&)>& wanted) {
  const QuietHdf5 silence;
  if (!is_regular(file))
    throw InputError("The file '" + file.string() + "' cannot be read",
                     file_exists(file) ? "it is a folder or a device" : "there is no such file",
                     file_exists(file) ? "Name a file, such as wear.h5 in the folder of bem_contact wear."
                                       : "Check the path.");
  const H5Handle root(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  std::map<std::string, H5O_type_t> found;
  const auto add = [](hid_t, const char* name, const auto* info, void* data) -> herr_t {
    static_cast<std::map<std::string, H5O_type_t>*>(data)->emplace(name, info->type);
    return 0;
  };
  // In the order of the file: to sort, HDF5 1.10.8 makes a list, and frees it unwritten where a link is
  // damaged.
  bool whole = root >= 0 && H5Ovisit2(root, H5_INDEX_NAME, H5_ITER_NATIVE, add, &found, H5O_INFO_BASIC) >= 0;
  H5Table table;
  table.checksums = true;
  for (const auto& [path, kind] : found)
    if (kind == H5O_TYPE_GROUP)
      whole = whole && read_attributes(root, path, table);
    else if (kind == H5O_TYPE_DATASET &&
             wanted(path)) // to open what is not wanted took as long as to visit it
      whole = whole && read_dataset(root, path, table);
  if (!whole)
    throw InputError("The file '" + file.string() + "' cannot be read", "it is not HDF5, or truncated",
                     "Name a result or an influence file, or make it again.");
  return table;
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
  const auto refuse = [&](const std::string& why) {
    throw InputError("The file '" + file.string() + "' is damaged", why,
                     "Copy it again from where it was whole, or make it again.");
  };
  if (found == table.datasets.end())
    refuse("it has no dataset '" + name + "'");
  const std::size_t size = found->second.values.size();
  if (size != count.value_or(std::max<std::size_t>(size, 1)))
    refuse("its dataset '" + name + "' has " + std::to_string(size) + " numbers, not " +
           (count ? std::to_string(*count) : "one or more"));
  return found->second;
}

void write_h5(const std::filesystem::path& file, const H5Table& table) {
  const QuietHdf5 silence;
  const H5Image image({.checksums = table.checksums}, [&](hid_t root) { write_entries(root, table, file); });
  write_whole(file, [&](std::ostream& out) { out << image; });
}

H5Table read_h5(const std::filesystem::path& file) {
  return read_paths(file, [](const std::string&) { return true; });
}

H5Table read_h5_top(const std::filesystem::path& file, const std::string& but) {
  return read_paths(file, [&](const std::string& path) {
    return path.find('/') == std::string::npos || (!but.empty() && path.starts_with(but + "/"));
  });
}

struct H5Writer::Impl {
  WholeFile whole;
  int descriptor = -1;
  hid_t root = -1;

  explicit Impl(const std::filesystem::path& file)
      : whole(output_target(file, OutputForm::whole_file).file) {}
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() {
    const QuietHdf5 silence;
    if (root >= 0)
      H5Fclose(root);
    if (descriptor >= 0)
      close(descriptor);
  }

  void check(bool success, const std::string& what) const { check_writing(success, whole.file(), what); }

  /// Asks the file system for the space that `values` doubles in `objects` datasets and attributes may take:
  /// after a failed write to a full disk HDF5 can neither close its file nor end the process in order.
  void reserve(std::size_t values, std::size_t objects) const {
    hsize_t used = 0;
    if (root >= 0)
      H5Fget_filesize(root, &used);
    const std::size_t bytes = table_bytes + object_bytes * objects + sizeof(double) * values;
    const int error = posix_fallocate(descriptor, static_cast<off_t>(used), static_cast<off_t>(bytes));
    check(error == 0, std::generic_category().message(error));
  }
};

H5Writer::H5Writer(const std::filesystem::path& file) : impl_(std::make_unique<Impl>(file)) {
  const QuietHdf5 silence;
  const std::filesystem::path& temporary = impl_->whole.temporary();
  const H5Image empty({}, [](hid_t) {});
  write_whole(temporary, [&](std::ostream& out) { out << empty; });
  impl_->descriptor = open(temporary.c_str(), O_WRONLY | O_CLOEXEC);
  const H5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_libver_bounds(access, H5F_LIBVER_V18,
                       H5F_LIBVER_V18); // headers with checksums, as those of an image
  impl_->root = H5Fopen(temporary.c_str(), H5F_ACC_RDWR, access);
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
  impl_->reserve(values, 3 * (table.datasets.size() + table.texts.size()) + table.attributes.size());
  write_entries(impl_->root, table, impl_->whole.file());
}

void H5Writer::finish() {
  const QuietHdf5 silence;
  impl_->check(H5Fflush(impl_->root, H5F_SCOPE_GLOBAL) >= 0, "its contents cannot be flushed");
  H5Fclose(std::exchange(impl_->root, -1));
  impl_->whole.commit();
}

} // namespace bem_contact
