#include "bem_contact/h5/handle.hpp"

#include "bem_contact/h5/hdf5_functions.hpp"

#include <type_traits>

namespace bem_contact {

static_assert(std::is_same_v<H5Id, hid_t> && std::is_same_v<int, herr_t>);

namespace {

/// Recursive, because writing a file makes an image of it first.
std::recursive_mutex& one_at_a_time() {
  static std::recursive_mutex mutex;
  return mutex;
}

} // namespace

H5Handle open_h5(const std::filesystem::path& file, H5Access access) {
  const H5Handle list(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  const bool change = access == H5Access::change;
  H5Pset_file_locking(list, false, true);
  if (change) // headers with checksums, as those of an image
    H5Pset_libver_bounds(list, H5F_LIBVER_V18, H5F_LIBVER_V18);
  return {H5Fopen(file.string().c_str(), change ? H5F_ACC_RDWR : H5F_ACC_RDONLY, list), H5Fclose};
}

QuietHdf5::QuietHdf5() : turn_(one_at_a_time()) {
  H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

QuietHdf5::~QuietHdf5() {
  H5Eset_auto2(H5E_DEFAULT, function_, data_);
}

} // namespace bem_contact
