#include "bem_contact/h5/dataset.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/h5/hdf5_functions.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fmt/format.h>
#include <functional>
#include <numeric>
#include <span>
#include <vector>
#include <zlib.h>

namespace bem_contact {
namespace {

constexpr double most_deflated = 1032; ///< of one byte: deflate stores 258 bytes in 2 bits
/// Bytes, and bytes of a byte of the file. A column of a sweep of five million cases that all have the same
/// number is 40 MB of 40 kB; whole files are deflated to a quarter. Chosen.
constexpr std::size_t always_inflated = 256 << 20, inflated_by_byte = 20;
constexpr unsigned long checksum_bytes = 4; ///< Fletcher's, behind each chunk

std::string file_of(hid_t object) {
  const ssize_t length = H5Fget_name(object, nullptr, 0);
  std::string name(length > 0 ? static_cast<std::size_t>(length) : 0, '\0');
  H5Fget_name(object, name.data(), name.size() + 1);
  return name;
}

[[noreturn]] void refuse(hid_t object, const std::string& path, const std::string& why) {
  throw InputError(fmt::format("The file '{}' is damaged", file_of(object)),
                   fmt::format("its dataset '{}' {}", path, why),
                   "Copy it again from where it was whole, or make it again.");
}

/// Before it is opened, because another file may be a pipe, which waits.
bool lies_here(hid_t at, const std::string& path) {
  for (std::size_t slash = path.find('/');; slash = path.find('/', slash + 1)) {
    H5L_info_t link;
    if (H5Lget_info(at, path.substr(0, slash).c_str(), &link, H5P_DEFAULT) < 0)
      return true; // there is none: opening says it
    if (link.type != H5L_TYPE_HARD)
      return false;
    if (slash == std::string::npos)
      return true;
  }
}

/// What is done with a chunk when it is written, by the place in the order; -1: it is not.
struct Filters {
  int checksum = -1, deflate = -1;
  std::string fault; ///< why we do not know what reading them does

  unsigned mask_of_checksum() const { return checksum < 0 ? 0 : 1U << checksum; }
  bool deflated(unsigned left_out) const { return deflate >= 0 && (left_out >> deflate & 1U) == 0; }
};

Filters filters_of(hid_t list) {
  Filters found;
  const int count = H5Pget_nfilters(list);
  for (int i = 0; i < count; ++i) {
    unsigned flags = 0, config = 0;
    std::size_t values = 0;
    const H5Z_filter_t filter =
        H5Pget_filter2(list, static_cast<unsigned>(i), &flags, &values, nullptr, 0, nullptr, &config);
    if (filter == H5Z_FILTER_FLETCHER32 && i + 1 == count)
      found.checksum = i;
    else if (filter == H5Z_FILTER_DEFLATE && found.deflate < 0)
      found.deflate = i;
    else if (filter != H5Z_FILTER_SHUFFLE)
      found.fault = filter == H5Z_FILTER_FLETCHER32 ? "has its checksum below a compression"
                                                    : "is compressed in a way that cannot be checked";
  }
  return found;
}

/// Of what was deflated; 0 where it was not, and more than `whole` where it does not end there.
std::size_t inflated_size(std::span<Bytef> deflated, std::size_t whole) {
  z_stream stream{};
  stream.next_in = deflated.data();
  stream.avail_in = static_cast<uInt>(deflated.size());
  if (inflateInit(&stream) != Z_OK)
    return 0;
  std::array<Bytef, 1 << 15> piece{};
  int state = Z_OK;
  while (state == Z_OK && stream.total_out <= whole) {
    stream.next_out = piece.data();
    stream.avail_out = piece.size();
    state = inflate(&stream, Z_NO_FLUSH);
  }
  const std::size_t size = state == Z_STREAM_END || state == Z_OK ? stream.total_out : 0;
  inflateEnd(&stream);
  return size;
}

/// Of the file; as a number that does not overflow.
double declared_bytes(hid_t set, const std::vector<hsize_t>& shape) {
  const H5Handle type(H5Dget_type(set), H5Tclose), space(H5Dget_space(set), H5Sclose);
  if (H5Sget_simple_extent_type(space) == H5S_NULL)
    return 0;
  return std::accumulate(shape.begin(), shape.end(), static_cast<double>(H5Tget_size(type)),
                         std::multiplies<>());
}

std::vector<hsize_t> shape_of(hid_t set) {
  const H5Handle space(H5Dget_space(set), H5Sclose);
  std::vector<hsize_t> shape(static_cast<std::size_t>(std::max(H5Sget_simple_extent_ndims(space), 0)));
  if (!shape.empty())
    H5Sget_simple_extent_dims(space, shape.data(), nullptr);
  return shape;
}

struct Chunks {
  std::vector<hsize_t> shape; ///< of each
  double whole;               ///< bytes of each
  hsize_t stored;             ///< bytes of all
};

/// Whether the chunk that begins there is stored with all that reading it needs.
bool is_whole_chunk(hid_t set, const hsize_t* at, const Chunks& chunks, const Filters& filters) {
  unsigned left_out = 0;
  haddr_t address = HADDR_UNDEF;
  hsize_t bytes = 0;
  if (H5Dget_chunk_info_by_coord(set, at, &left_out, &address, &bytes) < 0 || address == HADDR_UNDEF ||
      bytes > chunks.stored || (left_out & filters.mask_of_checksum()) != 0)
    return false;
  const hsize_t behind = filters.checksum < 0 ? 0 : checksum_bytes;
  if (bytes < behind)
    return false;
  if (!filters.deflated(left_out))
    return static_cast<double>(bytes - behind) == chunks.whole;
  std::vector<Bytef> chunk(bytes);
  std::uint32_t again = 0;
  return H5Dread_chunk(set, H5P_DEFAULT, at, &again, chunk.data()) >= 0 &&
         static_cast<double>(inflated_size(std::span(chunk).first(bytes - behind),
                                           static_cast<std::size_t>(chunks.whole))) == chunks.whole;
}

/// Whether each is, or of a line each that has some of the rows. It ends at the first that is not, so looks
/// at no more than were stored.
bool are_whole_chunks(hid_t set, hid_t list, std::vector<hsize_t> shape, const Filters& filters,
                      std::optional<Rows> rows) {
  Chunks chunks{std::vector<hsize_t>(shape.size()), 0, H5Dget_storage_size(set)};
  const int rank = static_cast<int>(shape.size());
  if (H5Pget_chunk(list, rank, chunks.shape.data()) != rank)
    return false;
  chunks.whole = declared_bytes(set, chunks.shape);
  if (chunks.whole > most_deflated * static_cast<double>(chunks.stored))
    return false;
  std::vector<hsize_t> at(shape.size(), 0);
  if (rows && rank == 1) {
    at[0] = rows->first / chunks.shape[0] * chunks.shape[0];
    shape[0] = std::min<hsize_t>(shape[0], rows->last);
    if (at[0] >= shape[0])
      return true;
  }
  for (std::size_t axis = 0; axis < shape.size();) {
    if (axis == 0 && !is_whole_chunk(set, at.data(), chunks, filters))
      return false;
    at[axis] += chunks.shape[axis];
    if (at[axis] < shape[axis])
      axis = 0;
    else
      at[axis++] = 0;
  }
  return true;
}

std::size_t file_size(hid_t object) {
  hsize_t bytes = 0;
  const H5Handle whole_file(H5Iget_file_id(object), H5Fclose);
  H5Fget_filesize(whole_file, &bytes);
  return static_cast<std::size_t>(bytes);
}

/// Of a file of so many bytes.
std::size_t most_inflated_of(std::size_t file) {
  return std::max(always_inflated, inflated_by_byte * file);
}

/// Why HDF5 may not read it; "": it may.
std::string fault_of(hid_t set, std::optional<Rows> rows) {
  const H5Handle list(H5Dget_create_plist(set), H5Pclose);
  const H5D_layout_t layout = H5Pget_layout(list);
  if (layout == H5D_VIRTUAL || (layout == H5D_CONTIGUOUS && H5Pget_external_count(list) != 0))
    return "lies in another file";
  const std::vector<hsize_t> shape = shape_of(set);
  const Filters filters = layout == H5D_CHUNKED ? filters_of(list) : Filters{};
  const double declared = declared_bytes(set, shape);
  const auto stored = static_cast<double>(H5Dget_storage_size(set));
  if (!filters.fault.empty())
    return filters.fault;
  const std::size_t file = file_size(set);
  if (declared > (filters.deflate >= 0 ? most_deflated : 1) * stored || stored > static_cast<double>(file))
    return fmt::format("has {:.0f} bytes, of which {:.0f} are stored in {}", declared, stored, file);
  if (filters.deflate >= 0 && declared > static_cast<double>(most_inflated_of(file)))
    return fmt::format("would take {:.0f} bytes of memory, and the file has {}", declared, file);
  if (layout == H5D_CHUNKED && declared > 0 && !are_whole_chunks(set, list, shape, filters, rows))
    return "has a chunk that is missing or not as long as it must be";
  return "";
}

} // namespace

std::size_t most_inflated(hid_t object) {
  return most_inflated_of(file_size(object));
}

H5Handle open_dataset(hid_t at, const std::string& path, std::optional<Rows> rows) {
  if (!lies_here(at, path))
    refuse(at, path, "is a link to another place");
  H5Handle set(H5Dopen2(at, path.c_str(), H5P_DEFAULT), H5Dclose);
  if (set >= 0)
    if (const std::string fault = fault_of(set, rows); !fault.empty())
      refuse(set, path, fault);
  return set;
}

bool has_checksum(hid_t dataset) {
  const H5Handle list(H5Dget_create_plist(dataset), H5Pclose);
  const H5D_layout_t layout = H5Pget_layout(list);
  return layout == H5D_COMPACT || (layout == H5D_CHUNKED && filters_of(list).checksum >= 0);
}

} // namespace bem_contact
