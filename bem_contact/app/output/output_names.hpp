#pragma once

#include "bem_contact/base/output_file.hpp"
#include "bem_contact/sequence/scene_record.hpp"
#include "bem_contact/uses/sweep/sweep_inputs.hpp"

#include <string_view>

namespace bem_contact::app {

/// Refuses a page whose name has the ending of another kind of file: programs that trust it would misread
/// it. Other endings are the user's own.
void require_page_name(const Output& output);

/// require_outputs(), and refuses HDF5 files of others that would be replaced, and such names of HDF5 files,
/// tables (--csv), surfaces for ParaView (--vtk) and pages (--plot).
void require_named_outputs(const std::vector<std::filesystem::path>& inputs,
                           const std::vector<Output>& outputs);

/// Throws InputError for an output that is there and no file of this format (record/file_kinds.hpp), such as
/// a whole sweep where a part is to be written. `holds`: what it may hold. An empty file may be anything.
void require_replaceable(const std::filesystem::path& output, std::string_view format,
                         std::string_view holds);

/// read_given_scene() for a command with these outputs, none of which may be a file that it reads. If there
/// is a result file among them, the inputs are recorded.
GivenScene read_given_scene_for(const std::vector<Output>& outputs, const std::string& file,
                                const std::string& model);

} // namespace bem_contact::app
