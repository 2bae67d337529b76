#include "bem_contact/app/fmu/zip_file.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/output_file.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <minizip/zip.h>
#include <zlib.h>

namespace bem_contact::app {

namespace {

/// The first day of the format, so that two runs write the same bytes.
zip_fileinfo first_day() {
  zip_fileinfo out{};
  out.tmz_date.tm_year = 1980;
  out.tmz_date.tm_mday = 1;
  return out;
}

bool add(zipFile zip, const ZipEntry& entry) {
  const zip_fileinfo about = first_day();
  if (zipOpenNewFileInZip(zip, entry.name.c_str(), &about, nullptr, 0, nullptr, 0, nullptr, Z_DEFLATED,
                          Z_DEFAULT_COMPRESSION) != ZIP_OK)
    return false;
  constexpr std::size_t piece = 1 << 20; // lengths are unsigned int there
  for (std::size_t at = 0; at < entry.bytes.size(); at += piece)
    if (zipWriteInFileInZip(zip, entry.bytes.data() + at,
                            static_cast<unsigned>(std::min(piece, entry.bytes.size() - at))) != ZIP_OK)
      return false;
  return zipCloseFileInZip(zip) == ZIP_OK;
}

} // namespace

void write_zip(const std::filesystem::path& file, const std::vector<ZipEntry>& entries) {
  const WholeFile whole(output_target(file, OutputForm::whole_file).file);
  zipFile zip = zipOpen64(whole.temporary().c_str(), APPEND_STATUS_CREATE);
  bool good = zip != nullptr;
  for (const ZipEntry& entry : entries)
    good = good && add(zip, entry);
  if (zip && zipClose(zip, nullptr) != ZIP_OK)
    good = false;
  if (!good)
    throw Error(fmt::format("'{}' cannot be written", file.string()), "the archive could not be finished",
                "See whether the disk is full.");
  whole.commit();
}

} // namespace bem_contact::app
