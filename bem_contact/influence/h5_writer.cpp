#include "bem_contact/influence/h5_writer.hpp"

#include "bem_contact/base/output_file.hpp"
#include "bem_contact/influence/h5_entries.hpp"
#include "bem_contact/influence/h5_handle.hpp"
#include "bem_contact/influence/h5_image.hpp"
#include "bem_contact/influence/settings.hpp"

#include <fcntl.h>
#include <ostream>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace bem_contact {

struct H5Writer::Impl {
  std::filesystem::path file, temporary;
  int descriptor = -1;
  hid_t root = -1;

  /// Asks the file system for the space that `values` doubles in `objects` datasets and attributes may take:
  /// after a failed write to a full disk HDF5 can neither close its file nor end the process in order.
  void reserve(std::size_t values, std::size_t objects) const {
    hsize_t used = 0;
    if (root >= 0)
      H5Fget_filesize(root, &used);
    const std::size_t bytes = table_bytes + object_bytes * objects + sizeof(double) * values;
    const int error = posix_fallocate(descriptor, static_cast<off_t>(used), static_cast<off_t>(bytes));
    check_writing(error == 0, file, std::generic_category().message(error));
  }
};

H5Writer::H5Writer(const std::filesystem::path& file) : impl_(std::make_unique<Impl>()) {
  const QuietHdf5 silence;
  impl_->file = output_target(file, OutputForm::whole_file).file;
  impl_->temporary = impl_->file;
  impl_->temporary += ".tmp";
  const H5Image empty(0, [](hid_t) {});
  write_whole(impl_->temporary, [&](std::ostream& out) { out << empty; });
  impl_->descriptor = open(impl_->temporary.c_str(), O_WRONLY | O_CLOEXEC);
  impl_->root = H5Fopen(impl_->temporary.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  check_writing(impl_->descriptor >= 0 && impl_->root >= 0, impl_->file, "it cannot be created");
}

H5Writer::~H5Writer() {
  const QuietHdf5 silence;
  if (impl_->root >= 0) {
    H5Fclose(impl_->root);
    std::error_code ignored;
    std::filesystem::remove(impl_->temporary, ignored);
  }
  if (impl_->descriptor >= 0)
    close(impl_->descriptor);
}

void H5Writer::add(const H5Table& table) {
  const QuietHdf5 silence;
  std::size_t values = 0;
  for (const auto& [name, data] : table.datasets)
    values += data.values.size();
  for (const auto& [name, value] : table.attributes)
    if (const auto* text = std::get_if<std::string>(&value))
      values += text->size() / sizeof(double) + 1;
  for (const auto& [name, data] : table.texts)
    values += data.text.size() / sizeof(double) + 1;
  impl_->reserve(values, 3 * (table.datasets.size() + table.texts.size()) + table.attributes.size());
  write_entries(impl_->root, table, impl_->file);
}

void H5Writer::finish() {
  const QuietHdf5 silence;
  check_writing(H5Fflush(impl_->root, H5F_SCOPE_GLOBAL) >= 0, impl_->file, "its contents cannot be flushed");
  H5Fclose(std::exchange(impl_->root, -1));
  std::error_code failed;
  std::filesystem::rename(impl_->temporary, impl_->file, failed);
  check_writing(!failed, impl_->file, failed.message());
}

} // namespace bem_contact
