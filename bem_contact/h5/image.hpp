#pragma once

#include "bem_contact/h5/handle.hpp"

#include <cstddef>
#include <cstdlib>
#include <functional>
#include <iosfwd>
#include <memory>
#include <span>

namespace bem_contact {

/// bytes. What a superblock of layout 1.8 and later takes, as far as end_of_file() reads it.
inline constexpr std::size_t superblock_bytes = 36;
/// Where the file ends that begins with this superblock.
std::size_t end_of_file(const char* superblock);

struct H5ImageForm {
  std::size_t user_block = 0; ///< bytes, zeros, before the file
  /// Whether the layout is that of HDF5 1.10: there the place of a dataset's only chunk lies in its header,
  /// and has a checksum with it.
  bool checksums = false;
};

/// The bytes of an HDF5 file that `fill` makes. It is made in memory: after a failed write to a full disk the
/// library cannot even close its file. Throws InputError where `fill` does or HDF5 fails. Layout of HDF5 1.8,
/// the oldest whose headers carry checksums: the library is not safe on damaged ones without.
class H5Image {
public:
  H5Image(const H5ImageForm& form, const std::function<void(H5Id root)>& fill);

  std::span<char> bytes() const { return {memory_.get(), size_}; }

  struct Free {
    void operator()(char* memory) const { std::free(memory); }
  };
  using Memory = std::unique_ptr<char, Free>;

private:
  Memory memory_; // HDF5's own
  std::size_t size_ = 0;
};

std::ostream& operator<<(std::ostream& out, const H5Image& image);

} // namespace bem_contact
