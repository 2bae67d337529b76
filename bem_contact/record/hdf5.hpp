#pragma once

#include "bem_contact/h5/table.hpp"
#include "bem_contact/record/record.hpp"

#include <filesystem>
#include <string>

/// Records as HDF5 files. A group is a group; short texts and yes or no are its attributes; a number is a
/// dataset of one number, its error another; a table is a group of columns, with the attributes "row" and
/// "table". Every dataset has "unit" and "description", and a checksum.
namespace bem_contact::record {

/// What a file of this record holds.
H5Table to_h5(const Record& record);
/// The record of what a file holds, in the order of names.
Record from_h5(const H5Table& table);

/// Writes the whole file at once. Throws what write_whole() does (base/output_file.hpp).
void write_hdf5(const std::filesystem::path& file, const Record& record);
/// The bytes of such a file.
std::string hdf5_bytes(const Record& record);
/// What a file says of its kind (record/file_kinds.hpp); "" for any that is not HDF5 of ours.
std::string format_of(const std::filesystem::path& file);
/// Throws InputError for a missing file, one that is not whole HDF5, or one that another version laid out
/// otherwise (record/file_kinds.hpp).
Record read_hdf5(const std::filesystem::path& file);
/// The same of what lies at the top of a file, and in one group.
Record read_hdf5_top(const std::filesystem::path& file, const std::string& group = "");
/// What the words of a sweep need (found.hpp): a long one has many more columns.
Record read_hdf5_for_found(const std::filesystem::path& file);

} // namespace bem_contact::record
