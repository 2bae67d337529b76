#pragma once

#include "bem_contact/app/command.hpp"

namespace bem_contact::app {

/// `bem_contact sweep SCENE -o SWEEP.h5`: a scene for lists or ranges of any of its keys.
Command add_sweep(CLI::App& program);

} // namespace bem_contact::app
