#pragma once

#include "bem_contact/base/output_file.hpp"

namespace bem_contact::app {

/// require_outputs(), and refuses HDF5 files and surfaces for ParaView (--vtk) whose names have the ending of
/// another kind of file: programs that trust it would misread them. Other endings are the user's own.
void require_named_outputs(const std::vector<std::filesystem::path>& inputs,
                           const std::vector<Output>& outputs);

} // namespace bem_contact::app
