#include "bem_contact/h5/image.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/h5/hdf5_functions.hpp"

#include <cstdint>
#include <cstring>
#include <ostream>

namespace bem_contact {
namespace {

/// bytes. A file in memory grows in such steps: few of them for a file of some 100 MB.
constexpr std::size_t image_increment = 1 << 20;

void check(bool good, const char* what) {
  if (!good)
    throw InputError(std::string("HDF5 failed at ") + what, "the memory may be full",
                     "Close other programs, or write a smaller file.");
}

// The memory of HDF5's core driver goes through these, so that it can be taken when the file is
// closed: H5Fget_file_image of 1.10 gives a superblock whose checksum does not hold.
void* allocate(size_t size, H5FD_file_image_op_t, void*) {
  return std::malloc(size);
}
void* copy(void* to, const void* from, size_t size, H5FD_file_image_op_t, void*) {
  return std::memcpy(to, from, size);
}
void* reallocate(void* memory, size_t size, H5FD_file_image_op_t, void*) {
  return std::realloc(memory, size);
}
herr_t take(void* memory, H5FD_file_image_op_t operation, void* taken) {
  if (operation == H5FD_FILE_IMAGE_OP_FILE_CLOSE)
    static_cast<H5Image::Memory*>(taken)->reset(static_cast<char*>(memory));
  else
    std::free(memory);
  return 0;
}
void* share(void* data) {
  return data;
}
herr_t keep(void*) {
  return 0;
}

} // namespace

std::size_t end_of_file(const char* superblock) { // of version 2 or 3
  std::uint64_t end = 0;
  std::memcpy(&end, superblock + superblock_bytes - sizeof end, sizeof end);
  return static_cast<std::size_t>(end);
}

H5Image::H5Image(const H5ImageForm& form, const std::function<void(H5Id root)>& fill) {
  const H5F_libver_t layout = form.checksums ? H5F_LIBVER_V110 : H5F_LIBVER_V18;
  H5FD_file_image_callbacks_t callbacks{allocate, copy, reallocate, take, share, keep, &memory_};
  const H5Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose), access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  check(creation >= 0 && access >= 0 && H5Pset_userblock(creation, form.user_block) >= 0 &&
            H5Pset_obj_track_times(creation, false) >= 0 &&
            H5Pset_libver_bounds(access, layout, layout) >= 0 &&
            H5Pset_fapl_core(access, image_increment, false) >= 0 &&
            H5Pset_file_image_callbacks(access, &callbacks) >= 0,
        "its property lists");
  {
    const H5Handle root(H5Fcreate("in memory", H5F_ACC_TRUNC, creation, access), H5Fclose);
    check(root >= 0, "making a file in memory");
    fill(root);
    check(H5Fflush(root, H5F_SCOPE_GLOBAL) >= 0, "flushing a file in memory");
  }
  check(memory_ != nullptr, "closing a file in memory");
  size_ = end_of_file(memory_.get() + form.user_block); // the buffer grows in steps, and is longer
}

std::ostream& operator<<(std::ostream& out, const H5Image& image) {
  return out.write(image.bytes().data(), static_cast<std::streamsize>(image.bytes().size()));
}

} // namespace bem_contact
