#pragma once

#include <hdf5.h>

#ifdef CONFORMAL_HDF5_LIBRARY // else HDF5 is linked, and its declarations serve

#include "bem_contact/base/loaded_library.hpp"

/// Private to this room: what it uses of HDF5, in place of the declarations of hdf5.h. With HDF5 come 27
/// libraries, which read files over networks; they are opened with the first file.
namespace bem_contact {

inline constexpr LoadedLibrary hdf5_library(CONFORMAL_HDF5_LIBRARY);

#define BEM_CONTACT_HDF5(name) BEM_CONTACT_LOADED_FUNCTION(hdf5_library, name)
BEM_CONTACT_HDF5(H5Aclose)
BEM_CONTACT_HDF5(H5Acreate2)
BEM_CONTACT_HDF5(H5Aexists)
BEM_CONTACT_HDF5(H5Aget_space)
BEM_CONTACT_HDF5(H5Aget_type)
BEM_CONTACT_HDF5(H5Aiterate2)
BEM_CONTACT_HDF5(H5Aopen)
BEM_CONTACT_HDF5(H5Aread)
BEM_CONTACT_HDF5(H5Awrite)
BEM_CONTACT_HDF5(H5Dclose)
BEM_CONTACT_HDF5(H5Dcreate2)
BEM_CONTACT_HDF5(H5Dget_chunk_info_by_coord)
BEM_CONTACT_HDF5(H5Dget_create_plist)
BEM_CONTACT_HDF5(H5Dget_space)
BEM_CONTACT_HDF5(H5Dget_storage_size)
BEM_CONTACT_HDF5(H5Dget_type)
BEM_CONTACT_HDF5(H5Dopen2)
BEM_CONTACT_HDF5(H5Dread)
BEM_CONTACT_HDF5(H5Dread_chunk)
BEM_CONTACT_HDF5(H5Dwrite)
BEM_CONTACT_HDF5(H5Eget_auto2)
BEM_CONTACT_HDF5(H5Eset_auto2)
BEM_CONTACT_HDF5(H5Fclose)
BEM_CONTACT_HDF5(H5Fcreate)
BEM_CONTACT_HDF5(H5Fflush)
BEM_CONTACT_HDF5(H5Fget_filesize)
BEM_CONTACT_HDF5(H5Fget_name)
BEM_CONTACT_HDF5(H5Fopen)
BEM_CONTACT_HDF5(H5Fset_libver_bounds)
BEM_CONTACT_HDF5(H5Gclose)
BEM_CONTACT_HDF5(H5Gcreate2)
BEM_CONTACT_HDF5(H5Gopen2)
BEM_CONTACT_HDF5(H5Iget_file_id)
BEM_CONTACT_HDF5(H5Lexists)
BEM_CONTACT_HDF5(H5Lget_info)
BEM_CONTACT_HDF5(H5Literate_by_name)
BEM_CONTACT_HDF5(H5Oclose)
BEM_CONTACT_HDF5(H5Oopen)
BEM_CONTACT_HDF5(H5Ovisit2)
BEM_CONTACT_HDF5(H5Pclose)
BEM_CONTACT_HDF5(H5Pcreate)
BEM_CONTACT_HDF5(H5Pget_chunk)
BEM_CONTACT_HDF5(H5Pget_external_count)
BEM_CONTACT_HDF5(H5Pget_filter2)
BEM_CONTACT_HDF5(H5Pget_layout)
BEM_CONTACT_HDF5(H5Pget_nfilters)
BEM_CONTACT_HDF5(H5Pset_alloc_time)
BEM_CONTACT_HDF5(H5Pset_chunk)
BEM_CONTACT_HDF5(H5Pset_deflate)
BEM_CONTACT_HDF5(H5Pset_fapl_core)
BEM_CONTACT_HDF5(H5Pset_file_image_callbacks)
BEM_CONTACT_HDF5(H5Pset_file_locking)
BEM_CONTACT_HDF5(H5Pset_fill_time)
BEM_CONTACT_HDF5(H5Pset_fletcher32)
BEM_CONTACT_HDF5(H5Pset_layout)
BEM_CONTACT_HDF5(H5Pset_libver_bounds)
BEM_CONTACT_HDF5(H5Pset_obj_track_times)
BEM_CONTACT_HDF5(H5Pset_shuffle)
BEM_CONTACT_HDF5(H5Pset_userblock)
BEM_CONTACT_HDF5(H5Sclose)
BEM_CONTACT_HDF5(H5Screate)
BEM_CONTACT_HDF5(H5Screate_simple)
BEM_CONTACT_HDF5(H5Sget_simple_extent_dims)
BEM_CONTACT_HDF5(H5Sget_simple_extent_ndims)
BEM_CONTACT_HDF5(H5Sget_simple_extent_npoints)
BEM_CONTACT_HDF5(H5Sget_simple_extent_type)
BEM_CONTACT_HDF5(H5Sselect_hyperslab)
BEM_CONTACT_HDF5(H5Sselect_valid)
BEM_CONTACT_HDF5(H5Tclose)
BEM_CONTACT_HDF5(H5Tcopy)
BEM_CONTACT_HDF5(H5Tget_class)
BEM_CONTACT_HDF5(H5Tget_size)
BEM_CONTACT_HDF5(H5Tis_variable_str)
BEM_CONTACT_HDF5(H5Tset_cset)
BEM_CONTACT_HDF5(H5Tset_size)
BEM_CONTACT_HDF5(H5free_memory)
// Macros as H5F_ACC_RDONLY and H5T_NATIVE_DOUBLE call these two; the second then takes one of the variables
// below.
BEM_CONTACT_HDF5(H5check_version)
BEM_CONTACT_HDF5(H5open)
#undef BEM_CONTACT_HDF5

#define BEM_CONTACT_HDF5(name) BEM_CONTACT_LOADED_VARIABLE(hdf5_library, name)
BEM_CONTACT_HDF5(H5P_CLS_DATASET_CREATE_ID_g)
BEM_CONTACT_HDF5(H5P_CLS_FILE_ACCESS_ID_g)
BEM_CONTACT_HDF5(H5P_CLS_FILE_CREATE_ID_g)
BEM_CONTACT_HDF5(H5P_CLS_GROUP_CREATE_ID_g)
BEM_CONTACT_HDF5(H5T_C_S1_g)
BEM_CONTACT_HDF5(H5T_IEEE_F64LE_g)
BEM_CONTACT_HDF5(H5T_NATIVE_DOUBLE_g)
BEM_CONTACT_HDF5(H5T_NATIVE_INT_g)
BEM_CONTACT_HDF5(H5T_NATIVE_UCHAR_g)
BEM_CONTACT_HDF5(H5T_NATIVE_UINT64_g)
BEM_CONTACT_HDF5(H5T_STD_I32LE_g)
BEM_CONTACT_HDF5(H5T_STD_I64LE_g)
BEM_CONTACT_HDF5(H5T_STD_U64LE_g)
BEM_CONTACT_HDF5(H5T_STD_U8LE_g)
#undef BEM_CONTACT_HDF5

} // namespace bem_contact

#endif
