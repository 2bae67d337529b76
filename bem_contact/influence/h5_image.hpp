#pragma once

#include <hdf5.h>

#include <cstddef>
#include <functional>
#include <string>

/// Private to this room.
namespace bem_contact {

/// The bytes of an HDF5 file that `fill` makes, with `user_block` zeros before it. It is made in memory:
/// after a failed write to a full disk the library cannot even close its file. Throws InputError where `fill`
/// does or HDF5 fails. Layout of HDF5 1.8, the oldest whose headers carry checksums: the library is not safe
/// on damaged ones without.
std::string h5_image(std::size_t user_block, const std::function<void(hid_t root)>& fill);

} // namespace bem_contact
