#include "bem_contact/influence/h5_table.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/influence/h5_handle.hpp"
#include "bem_contact/influence/h5_image.hpp"

#include <fcntl.h>
#include <numeric>
#include <ostream>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace bem_contact {

namespace {

void check(bool good, const std::filesystem::path& file, const std::string& what) {
  if (!good)
    throw InputError(
        "The file '" + file.string() + "' cannot be written", what,
        "Check that its folder exists, that you may write there, and that the disk is not full.");
}

void write_text(hid_t object, const std::string& name, const std::string& text,
                const std::filesystem::path& file) {
  const H5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type, text.size() + 1);
  H5Tset_cset(type, H5T_CSET_UTF8);
  const H5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const H5Handle attribute(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  check(attribute >= 0 && H5Awrite(attribute, type, text.c_str()) >= 0, file, "attribute " + name);
}

void write_number(hid_t object, const std::string& name, double value, const std::filesystem::path& file) {
  const H5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const H5Handle attribute(H5Acreate2(object, name.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT),
                           H5Aclose);
  check(attribute >= 0 && H5Awrite(attribute, H5T_NATIVE_DOUBLE, &value) >= 0, file, "attribute " + name);
}

void write_all(hid_t root, const H5Table& table, const std::filesystem::path& file) {
  const H5Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  H5Pset_create_intermediate_group(links, 1);
  for (const auto& [name, data] : table.datasets) {
    std::vector<hsize_t> shape(data.shape.begin(), data.shape.end());
    const auto size =
        std::accumulate(data.shape.begin(), data.shape.end(), std::size_t{1}, std::multiplies<>());
    check(size == data.values.size(), file, "the shape of " + name + " does not fit its values");
    const H5Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose);
    const H5Handle set(H5Dcreate2(root, name.c_str(), H5T_IEEE_F64LE, space, links, H5P_DEFAULT, H5P_DEFAULT),
                       H5Dclose);
    check(set >= 0, file, "dataset " + name);
    check(data.values.empty() ||
              H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, data.values.data()) >= 0,
          file, "dataset " + name);
    write_text(set, "unit", data.unit, file);
    write_text(set, "description", data.description, file);
  }
  for (const auto& [path, value] : table.attributes) {
    const auto slash = path.rfind('/');
    const std::string group = slash == std::string::npos ? "/" : path.substr(0, slash);
    const std::string name = slash == std::string::npos ? path : path.substr(slash + 1);
    if (group != "/" && H5Lexists(root, group.c_str(), H5P_DEFAULT) <= 0)
      H5Handle(H5Gcreate2(root, group.c_str(), links, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
    const H5Handle object(H5Oopen(root, group.c_str(), H5P_DEFAULT), H5Oclose);
    check(object >= 0, file, "group " + group);
    if (const auto* text = std::get_if<std::string>(&value))
      write_text(object, name, *text, file);
    else
      write_number(object, name, std::get<double>(value), file);
  }
}

/// Text (fixed or variable length) or number; nothing for any other attribute.
void read_attribute(hid_t object, const std::string& name, const std::string& key, H5Table& table) {
  const H5Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose);
  const H5Handle type(H5Aget_type(attribute), H5Tclose), space(H5Aget_space(attribute), H5Sclose);
  if (attribute < 0 || H5Sget_simple_extent_npoints(space) != 1)
    return;
  const H5T_class_t kind = H5Tget_class(type);
  if (kind == H5T_STRING && H5Tis_variable_str(type) > 0) {
    char* text = nullptr;
    if (H5Aread(attribute, type, &text) >= 0 && text) {
      table.attributes[key] = std::string(text);
      H5free_memory(text);
    }
  } else if (kind == H5T_STRING) {
    std::string text(H5Tget_size(type), '\0');
    if (H5Aread(attribute, type, text.data()) >= 0)
      table.attributes[key] = std::string(text.c_str());
  } else if (kind == H5T_FLOAT || kind == H5T_INTEGER) {
    double value = 0;
    if (H5Aread(attribute, H5T_NATIVE_DOUBLE, &value) >= 0)
      table.attributes[key] = value;
  }
}

std::vector<std::string> attribute_names(hid_t object) {
  std::vector<std::string> names;
  const auto add = [](hid_t, const char* name, const H5A_info_t*, void* data) -> herr_t {
    static_cast<std::vector<std::string>*>(data)->emplace_back(name);
    return 0;
  };
  H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, nullptr, add, &names);
  return names;
}

std::string text_of(hid_t object, const std::string& name) {
  H5Table one;
  if (H5Aexists(object, name.c_str()) > 0)
    read_attribute(object, name, name, one);
  const auto at = one.attributes.find(name);
  const auto* text = at == one.attributes.end() ? nullptr : std::get_if<std::string>(&at->second);
  return text ? *text : std::string();
}

bool read_dataset(hid_t set, H5Dataset& data) {
  const H5Handle space(H5Dget_space(set), H5Sclose), type(H5Dget_type(set), H5Tclose);
  const H5T_class_t kind = H5Tget_class(type);
  if (kind != H5T_FLOAT && kind != H5T_INTEGER)
    return true;
  const int rank = H5Sget_simple_extent_ndims(space);
  std::vector<hsize_t> shape(rank > 0 ? rank : 0);
  if (rank > 0)
    H5Sget_simple_extent_dims(space, shape.data(), nullptr);
  data.shape.assign(shape.begin(), shape.end());
  data.values.resize(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  data.unit = text_of(set, "unit");
  data.description = text_of(set, "description");
  return data.values.empty() ||
         H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, data.values.data()) >= 0;
}

/// `deep`: datasets in groups too.
bool read_object(hid_t root, const std::string& path, bool deep, H5Table& table) {
  const H5Handle object(H5Oopen(root, path.c_str(), H5P_DEFAULT), H5Oclose);
  if (object < 0)
    return false;
  const H5I_type_t kind = H5Iget_type(object);
  if (kind == H5I_DATASET && (deep || path.find('/') == std::string::npos)) {
    H5Dataset data;
    if (!read_dataset(object, data))
      return false;
    table.datasets[path] = std::move(data);
  } else if (kind == H5I_GROUP) {
    for (const std::string& name : attribute_names(object))
      read_attribute(object, name, path == "." ? name : path + "/" + name, table);
  }
  return true;
}

H5Table read_paths(const std::filesystem::path& file, bool deep) {
  const QuietHdf5 silence;
  if (!std::filesystem::is_regular_file(file))
    throw InputError("The file '" + file.string() + "' cannot be read",
                     std::filesystem::exists(file) ? "it is no file" : "there is no such file",
                     "Check the path.");
  const H5Handle root(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  std::vector<std::string> paths;
  const auto add = [](hid_t, const char* name, const H5O_info_t*, void* data) -> herr_t {
    static_cast<std::vector<std::string>*>(data)->emplace_back(name);
    return 0;
  };
  bool whole = root >= 0 && H5Ovisit2(root, H5_INDEX_NAME, H5_ITER_INC, add, &paths, H5O_INFO_BASIC) >= 0;
  H5Table table;
  for (const std::string& path : paths)
    whole = whole && read_object(root, path, deep, table);
  if (!whole)
    throw InputError("The file '" + file.string() + "' cannot be read", "it is not HDF5, or truncated",
                     "Name a result or an influence file, or make it again.");
  return table;
}

} // namespace

struct H5Writer::Impl {
  std::filesystem::path file, temporary;
  int descriptor = -1;
  hid_t root = -1;

  /// Asks the file system for the space that `values` doubles in `objects` datasets and attributes may take:
  /// after a failed write to a full disk HDF5 can neither close its file nor end the process in order.
  void reserve(std::size_t values, std::size_t objects) const {
    constexpr std::size_t object_bytes = 4096, table_bytes = 1 << 18; // more than headers and indices take
    hsize_t used = 0;
    if (root >= 0)
      H5Fget_filesize(root, &used);
    const std::size_t bytes = table_bytes + object_bytes * objects + sizeof(double) * values;
    const int error = posix_fallocate(descriptor, static_cast<off_t>(used), static_cast<off_t>(bytes));
    check(error == 0, file, std::generic_category().message(error));
  }
};

H5Writer::H5Writer(std::filesystem::path file) : impl_(std::make_unique<Impl>()) {
  const QuietHdf5 silence;
  impl_->temporary = file;
  impl_->temporary += ".tmp";
  impl_->file = std::move(file);
  const H5Image empty(0, [](hid_t) {});
  write_whole(impl_->temporary, [&](std::ostream& out) { out << empty; });
  impl_->descriptor = open(impl_->temporary.c_str(), O_WRONLY | O_CLOEXEC);
  impl_->root = H5Fopen(impl_->temporary.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  check(impl_->descriptor >= 0 && impl_->root >= 0, impl_->file, "it cannot be created");
}

H5Writer::~H5Writer() {
  const QuietHdf5 silence;
  if (impl_->root >= 0) {
    H5Fclose(impl_->root);
    std::error_code ignored;
    std::filesystem::remove(impl_->temporary, ignored);
  }
  if (impl_->descriptor >= 0)
    close(impl_->descriptor);
}

void H5Writer::add(const H5Table& table) {
  const QuietHdf5 silence;
  std::size_t values = 0;
  for (const auto& [name, data] : table.datasets)
    values += data.values.size();
  for (const auto& [name, value] : table.attributes)
    if (const auto* text = std::get_if<std::string>(&value))
      values += text->size() / sizeof(double) + 1;
  impl_->reserve(values, 3 * table.datasets.size() + table.attributes.size());
  write_all(impl_->root, table, impl_->file);
}

void H5Writer::finish() {
  const QuietHdf5 silence;
  check(H5Fflush(impl_->root, H5F_SCOPE_GLOBAL) >= 0, impl_->file, "its contents cannot be flushed");
  H5Fclose(std::exchange(impl_->root, -1));
  std::error_code failed;
  std::filesystem::rename(impl_->temporary, impl_->file, failed);
  check(!failed, impl_->file, failed.message());
}

void write_h5(const std::filesystem::path& file, const H5Table& table) {
  const QuietHdf5 silence;
  const H5Image image(0, [&](hid_t root) { write_all(root, table, file); });
  write_whole(file, [&](std::ostream& out) { out << image; });
}

H5Table read_h5(const std::filesystem::path& file) {
  return read_paths(file, true);
}

H5Table read_h5_top(const std::filesystem::path& file) {
  return read_paths(file, false);
}

} // namespace bem_contact
