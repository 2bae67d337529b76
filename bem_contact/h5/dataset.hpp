#pragma once

#include "bem_contact/h5/handle.hpp"

#include <cstddef>
#include <optional>
#include <string>

/// Private to this room: the only way to open a dataset.
namespace bem_contact {

/// Numbers first, first + 1 ... last - 1 of a line.
struct Rows {
  std::size_t first = 0, last = 0;
};

/// The dataset at `path` below `at`; negative where there is none or HDF5 cannot open it.
///
/// A checksum says that a file is as somebody wrote it, not that he meant well, and results have none. So we
/// look before HDF5 reads a number. Throws InputError for a dataset that
/// - lies in another file: a link on its path is not hard, its storage is external or virtual;
/// - is declared larger than what was stored of it. HDF5 would fill up the rest, whatever memory it takes;
/// - has a chunk that is not stored, or not as long as chunk and checksum are. HDF5 (1.10 and 1.14) subtracts
///   the length of the checksum unchecked and reads beyond the end of a short chunk.
/// `rows`: those of a line that are read; only their chunks are looked at.
H5Handle open_dataset(H5Id at, const std::string& path, std::optional<Rows> rows = {});

/// Bytes. More than so much is not read of one file, or 1 MB might fill the memory: what is deflated takes up
/// to a thousand times as much here.
std::size_t most_inflated(H5Id object);

/// Whether HDF5 finds out that a bit of the numbers has changed: they lie in the header, which has a checksum
/// in files of ours, or each chunk has one.
bool has_checksum(H5Id dataset);

} // namespace bem_contact
