#include "bem_contact/influence/h5_table.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/influence/h5_entries.hpp"
#include "bem_contact/influence/h5_handle.hpp"
#include "bem_contact/influence/h5_image.hpp"

#include <functional>
#include <ostream>

namespace bem_contact {

namespace {

H5Table read_paths(const std::filesystem::path& file, const std::function<bool(const std::string&)>& wanted) {
  const QuietHdf5 silence;
  if (!is_regular(file))
    throw InputError("The file '" + file.string() + "' cannot be read",
                     file_exists(file) ? "it is a folder or a device" : "there is no such file",
                     file_exists(file) ? "Name a file, such as wear.h5 in the folder of bem_contact wear."
                                       : "Check the path.");
  const H5Handle root(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  std::vector<std::string> paths;
  const auto add = [](hid_t, const char* name, const H5O_info_t*, void* data) -> herr_t {
    static_cast<std::vector<std::string>*>(data)->emplace_back(name);
    return 0;
  };
  bool whole = root >= 0 && H5Ovisit2(root, H5_INDEX_NAME, H5_ITER_INC, add, &paths, H5O_INFO_BASIC) >= 0;
  H5Table table;
  for (const std::string& path : paths)
    whole = whole && read_entry(root, path, wanted(path), table);
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

void write_h5(const std::filesystem::path& file, const H5Table& table) {
  const QuietHdf5 silence;
  const H5Image image(0, [&](hid_t root) { write_entries(root, table, file); });
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

} // namespace bem_contact
