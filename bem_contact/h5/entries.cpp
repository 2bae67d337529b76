#include "bem_contact/h5/entries.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/sha256.hpp"
#include "bem_contact/h5/attributes.hpp"
#include "bem_contact/h5/dataset.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <sstream>
#include <utility>
#include <variant>
#include <vector>

namespace bem_contact {

namespace {

/// Text (fixed or variable length) or number; nothing for any other attribute. False where it cannot be read.
bool read_attribute(hid_t object, const std::string& name, const std::string& key, H5Table& table) {
  const H5Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose);
  const H5Handle type(H5Aget_type(attribute), H5Tclose), space(H5Aget_space(attribute), H5Sclose);
  if (attribute < 0 || type < 0 || space < 0)
    return false;
  if (H5Sget_simple_extent_npoints(space) != 1)
    return true;
  const H5T_class_t kind = H5Tget_class(type);
  if (kind == H5T_STRING) {
    auto text = read_text(attribute);
    if (text)
      table.attributes[key] = std::move(*text);
    return text.has_value();
  }
  if (kind != H5T_FLOAT && kind != H5T_INTEGER)
    return true;
  double value = 0;
  const bool read = H5Aread(attribute, H5T_NATIVE_DOUBLE, &value) >= 0;
  if (kind == H5T_INTEGER && H5Tget_size(type) == 1)
    table.attributes[key] = value != 0;
  else
    table.attributes[key] = value;
  return read;
}

bool find_attributes(hid_t object, std::vector<std::string>& names) {
  const auto add = [](hid_t, const char* name, const H5A_info_t*, void* data) -> herr_t {
    static_cast<std::vector<std::string>*>(data)->emplace_back(name);
    return 0;
  };
  return H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, add, &names) >= 0;
}

/// Of a text: numbers have a checksum of HDF5, a text's own place has none.
constexpr const char* text_digest = "sha256";

/// "" where there is no such text. False where it cannot be read.
bool read_text_attribute(hid_t object, const std::string& name, std::string& text) {
  H5Table one;
  const htri_t there = H5Aexists(object, name.c_str());
  const bool read = there == 0 || (there > 0 && read_attribute(object, name, name, one));
  text = text_attribute(one, name);
  return read;
}

constexpr const char *role_attribute = "role", *of_attribute = "of", *choices_attribute = "choices";

/// False where they cannot be read. Only what has a role has the others.
bool read_role(hid_t set, H5Dataset& data) {
  std::string choices;
  if (!read_text_attribute(set, role_attribute, data.role) ||
      (!data.role.empty() && !(read_text_attribute(set, of_attribute, data.of) &&
                               read_text_attribute(set, choices_attribute, choices))))
    return false;
  std::istringstream lines(choices);
  for (std::string line; std::getline(lines, line);)
    data.choices.push_back(line);
  return true;
}

/// A dataset of one text of fixed length; false where it cannot be read. Any other text is passed over.
bool read_text_dataset(hid_t set, const std::string& path, H5Table& table) {
  const H5Handle space(H5Dget_space(set), H5Sclose), type(H5Dget_type(set), H5Tclose);
  if (H5Sget_simple_extent_npoints(space) != 1 || H5Tis_variable_str(type) > 0)
    return true;
  std::string text(H5Tget_size(type), '\0');
  if (H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()) < 0)
    return false;
  text.erase(std::min(text.find('\0'), text.size()));
  std::string digest;
  if (!read_text_attribute(set, text_digest, digest) || (!digest.empty() && digest != sha256(text)))
    return false;
  H5Text& stored = table.texts[path];
  stored.text = std::move(text);
  stored.lines = H5Aexists(set, "lines") > 0;
  return read_text_attribute(set, "description", stored.description);
}

bool read_open_dataset(hid_t set, const std::string& path, H5Table& table) {
  const H5Handle space(H5Dget_space(set), H5Sclose), type(H5Dget_type(set), H5Tclose);
  const H5T_class_t kind = H5Tget_class(type);
  if (kind == H5T_STRING)
    return read_text_dataset(set, path, table);
  H5Dataset& data = table.datasets[path];
  if (kind != H5T_FLOAT && kind != H5T_INTEGER)
    return true;
  const int rank = H5Sget_simple_extent_ndims(space);
  std::vector<hsize_t> shape(rank > 0 ? rank : 0);
  if (rank > 0)
    H5Sget_simple_extent_dims(space, shape.data(), nullptr);
  data.shape.assign(shape.begin(), shape.end());
  data.whole = kind == H5T_INTEGER;
  data.values.resize(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  const bool said = read_text_attribute(set, "unit", data.unit) &&
                    read_text_attribute(set, "description", data.description) && read_role(set, data);
  table.checksums = table.checksums && (data.values.empty() || has_checksum(set));
  return said && (data.values.empty() ||
                  H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, data.values.data()) >= 0);
}

} // namespace

void check_writing(bool good, const std::filesystem::path& file, const std::string& what) {
  if (!good)
    throw Error("The file '" + file.string() + "' cannot be written", what,
                "Check that its folder exists, that you may write there, and that the disk is not full.");
}

namespace {

/// Files of the same numbers are the same bytes: no object has the time of its making.
H5Handle without_times(hid_t kind) {
  H5Handle list(H5Pcreate(kind), H5Pclose);
  H5Pset_obj_track_times(list, false);
  return list;
}

/// Makes the groups of a path that ends with a name.
bool make_groups(hid_t root, const std::string& path) {
  for (std::size_t slash = path.find('/'); slash != std::string::npos; slash = path.find('/', slash + 1)) {
    const std::string group = path.substr(0, slash);
    if (H5Lexists(root, group.c_str(), H5P_DEFAULT) > 0)
      continue;
    const H5Handle list = without_times(H5P_GROUP_CREATE);
    if (H5Handle(H5Gcreate2(root, group.c_str(), H5P_DEFAULT, list, H5P_DEFAULT), H5Gclose) < 0)
      return false;
  }
  return true;
}

/// Octave's `load` asks for ASCII, and HDF5 does not convert between both.
H5T_cset_t characters_of(const std::string& text) {
  const auto is_ascii = [](char c) { return static_cast<unsigned char>(c) < 0x80; };
  return std::ranges::all_of(text, is_ascii) ? H5T_CSET_ASCII : H5T_CSET_UTF8;
}

void write_texts(hid_t root, const H5Table& table, const std::filesystem::path& file) {
  for (const auto& [name, data] : table.texts) {
    const H5Handle type(H5Tcopy(H5T_C_S1), H5Tclose), space(H5Screate(H5S_SCALAR), H5Sclose);
    check_writing(H5Tset_size(type, data.text.size() + 1) >= 0 &&
                      H5Tset_cset(type, characters_of(data.text)) >= 0,
                  file, "text " + name);
    const H5Handle list = without_times(H5P_DATASET_CREATE);
    check_writing(make_groups(root, name), file, "the group of " + name);
    const H5Handle set(H5Dcreate2(root, name.c_str(), type, space, H5P_DEFAULT, list, H5P_DEFAULT), H5Dclose);
    check_writing(set >= 0 && H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data.text.c_str()) >= 0,
                  file, "text " + name);
    const std::string_view kept(data.text.c_str()); // a text in HDF5 ends at the character NUL
    check_writing(write_attribute(set, "description", data.description) &&
                      write_attribute(set, text_digest, sha256(kept)) &&
                      (!data.lines || write_attribute(set, "lines", true)),
                  file, "attribute description");
  }
}

/// A single number lies in the dataset's header, which has a checksum; all others are one chunk with its own.
bool ask_for_checksum(hid_t list, const std::vector<hsize_t>& shape) {
  if (shape.empty())
    return H5Pset_layout(list, H5D_COMPACT) >= 0;
  return H5Pset_chunk(list, static_cast<int>(shape.size()), shape.data()) >= 0 &&
         H5Pset_fletcher32(list) >= 0;
}

void write_numbers(hid_t root, const H5Table& table, const std::filesystem::path& file) {
  for (const auto& [name, data] : table.datasets) {
    const std::vector<hsize_t> shape(data.shape.begin(), data.shape.end());
    const auto size =
        std::accumulate(data.shape.begin(), data.shape.end(), std::size_t{1}, std::multiplies<>());
    check_writing(size == data.values.size(), file, "the shape of " + name + " does not fit its values");
    const H5Handle list = without_times(H5P_DATASET_CREATE);
    check_writing(make_groups(root, name), file, "the group of " + name);
    check_writing(!table.checksums || data.values.empty() || ask_for_checksum(list, shape), file,
                  "the checksum of " + name);
    const H5Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose);
    const H5Handle set(H5Dcreate2(root, name.c_str(), data.whole ? H5T_STD_I64LE : H5T_IEEE_F64LE, space,
                                  H5P_DEFAULT, list, H5P_DEFAULT),
                       H5Dclose);
    check_writing(set >= 0, file, "dataset " + name);
    check_writing(data.values.empty() || H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT,
                                                  data.values.data()) >= 0,
                  file, "dataset " + name);
    check_writing(write_words(root, name, data), file, "unit and description of " + name);
  }
}

void write_attributes(hid_t root, const H5Table& table, const std::filesystem::path& file) {
  for (const auto& [path, value] : table.attributes) {
    const auto slash = path.rfind('/');
    const std::string group = slash == std::string::npos ? "/" : path.substr(0, slash);
    const std::string name = slash == std::string::npos ? path : path.substr(slash + 1);
    check_writing(make_groups(root, path), file, "group " + group);
    const H5Handle object(H5Oopen(root, group.c_str(), H5P_DEFAULT), H5Oclose);
    check_writing(object >= 0, file, "group " + group);
    const auto write = [&](const auto& text_or_number) {
      return write_attribute(object, name.c_str(), text_or_number);
    };
    check_writing(std::visit(write, value), file, "attribute " + name);
  }
}

} // namespace

void write_entries(hid_t root, const H5Table& table, const std::filesystem::path& file) {
  write_texts(root, table, file);
  write_numbers(root, table, file);
  write_attributes(root, table, file);
}

/// 1. Chosen: the quickest of the nine.
constexpr unsigned deflate_level = 1;

bool write_empty_line(hid_t root, const std::string& name, std::size_t size) {
  const hsize_t extent = size, chunk = std::min(size, rows_of_a_chunk);
  const H5Handle list = without_times(H5P_DATASET_CREATE);
  if (size > 0 && (H5Pset_chunk(list, 1, &chunk) < 0 || H5Pset_shuffle(list) < 0 ||
                   H5Pset_deflate(list, deflate_level) < 0 || H5Pset_fletcher32(list) < 0))
    return false;
  const H5Handle space(H5Screate_simple(1, &extent, nullptr), H5Sclose);
  return make_groups(root, name) &&
         H5Handle(H5Dcreate2(root, name.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, list, H5P_DEFAULT),
                  H5Dclose) >= 0;
}

bool write_words(hid_t root, const std::string& name, const H5Dataset& data) {
  const H5Handle set(H5Dopen2(root, name.c_str(), H5P_DEFAULT), H5Dclose);
  std::string choices;
  for (const std::string& choice : data.choices)
    choices += choice + "\n";
  return set >= 0 && write_attribute(set, "unit", data.unit) &&
         write_attribute(set, "description", data.description) &&
         (data.role.empty() || write_attribute(set, role_attribute, data.role)) &&
         (data.of.empty() || write_attribute(set, of_attribute, data.of)) &&
         (choices.empty() || write_attribute(set, choices_attribute, choices));
}

namespace {

/// Calls `transfer` with the dataset's numbers first .. first + count - 1 as spaces of memory and file.
template <class Transfer> bool for_rows(hid_t set, std::size_t first, std::size_t count, Transfer transfer) {
  const H5Handle file(H5Dget_space(set), H5Sclose);
  const hsize_t begin = first, length = count;
  const H5Handle memory(H5Screate_simple(1, &length, nullptr), H5Sclose);
  return H5Sselect_hyperslab(file, H5S_SELECT_SET, &begin, nullptr, &length, nullptr) >= 0 &&
         H5Sselect_valid(file) > 0 && transfer(memory, file) >= 0;
}

} // namespace

bool write_rows(hid_t root, const std::string& name, std::size_t first, std::span<const double> values) {
  const H5Handle set(H5Dopen2(root, name.c_str(), H5P_DEFAULT), H5Dclose);
  return values.empty() ||
         (set >= 0 && for_rows(set, first, values.size(), [&](hid_t memory, hid_t file) {
            return H5Dwrite(set, H5T_NATIVE_DOUBLE, memory, file, H5P_DEFAULT, values.data());
          }));
}

std::optional<std::size_t> numbers_in(hid_t root, const std::string& name) {
  const H5Handle set = open_dataset(root, name, Rows{});
  const H5Handle space(set >= 0 ? H5Dget_space(set) : -1, H5Sclose);
  if (space < 0 || H5Sget_simple_extent_ndims(space) > 1)
    return std::nullopt;
  return static_cast<std::size_t>(H5Sget_simple_extent_npoints(space));
}

bool read_rows(hid_t root, const std::string& name, std::size_t first, std::span<double> values) {
  const H5Handle set = open_dataset(root, name, Rows{first, first + values.size()});
  return set >= 0 && (values.empty() || for_rows(set, first, values.size(), [&](hid_t memory, hid_t file) {
                        return H5Dread(set, H5T_NATIVE_DOUBLE, memory, file, H5P_DEFAULT, values.data());
                      }));
}

bool read_dataset(hid_t root, const std::string& path, H5Table& table) {
  const H5Handle set = open_dataset(root, path);
  return set >= 0 && read_open_dataset(set, path, table);
}

bool read_attributes(hid_t root, const std::string& path, H5Table& table) {
  const H5Handle group(H5Gopen2(root, path.c_str(), H5P_DEFAULT), H5Gclose);
  std::vector<std::string> names;
  bool read = group >= 0 && find_attributes(group, names);
  for (const std::string& name : names)
    read = read && read_attribute(group, name, path == "." ? name : path + "/" + name, table);
  return read;
}

} // namespace bem_contact
