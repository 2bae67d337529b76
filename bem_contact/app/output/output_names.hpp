#pragma once

#include "bem_contact/base/output_file.hpp"

namespace bem_contact::app {

/// Refuses a page whose name has the ending of another kind of file: programs that trust it would misread
/// it. Other endings are the user's own.
void require_page_name(const Output& output);

/// require_outputs(), and refuses such names of HDF5 files, tables (--csv), surfaces for ParaView (--vtk) and
/// pages (--plot).
void require_named_outputs(const std::vector<std::filesystem::path>& inputs,
                           const std::vector<Output>& outputs);

} // namespace bem_contact::app
