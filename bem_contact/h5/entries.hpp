#pragma once

#include "bem_contact/h5/table.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

/// Private to this room: the entries of an open file of result tables.
namespace bem_contact {

/// Throws Error if not `success`: `file` cannot be written.
void check_writing(bool success, const std::filesystem::path& file, const std::string& what);

/// Writes all datasets, texts and attributes; groups come into being with them. `file` is for messages.
void write_entries(H5Id root, const H5Table& table, const std::filesystem::path& file);

/// Makes a dataset of so many numbers in one dimension, in deflated chunks (rows_of_a_chunk), and writes some
/// of them. False where HDF5 fails.
bool write_empty_line(H5Id root, const std::string& name, std::size_t size);
bool write_rows(H5Id root, const std::string& name, std::size_t first, std::span<const double> values);
/// The attributes of a dataset that say what it is.
bool write_words(H5Id root, const std::string& name, const H5Dataset& data);

/// How many numbers a dataset of one dimension has; nothing where it has another form.
std::optional<std::size_t> numbers_in(H5Id root, const std::string& name);
/// Reads some of them. False where HDF5 fails; throws what open_dataset() does.
bool read_rows(H5Id root, const std::string& name, std::size_t first, std::span<double> values);

/// Adds the dataset at `path`, of numbers or one text, to `table`. False where HDF5 fails; throws what
/// open_dataset() does.
bool read_dataset(H5Id root, const std::string& path, H5Table& table);
/// Adds the attributes of the group at `path`. False where HDF5 fails.
bool read_attributes(H5Id root, const std::string& path, H5Table& table);

} // namespace bem_contact
