#pragma once

#include "bem_contact/app/command.hpp"

namespace bem_contact::app {

/// `bem_contact report`: a result file as one HTML page.
Command add_report(CLI::App& program);

} // namespace bem_contact::app
