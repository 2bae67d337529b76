#pragma once

#include "bem_contact/app/command.hpp"
#include "bem_contact/uses/sweep/sweep_part.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace bem_contact::app {

/// What a command that solves a whole sweep was asked.
struct SweepRequest {
  std::string scene, output, csv, model;
  int jobs = 0;          ///< processes; 0: one for each core
  bool strict = false;   ///< a case with a warning is refused
  std::string more = {}; ///< what else changes the results: options of the command

  /// What changes the results besides the scene.
  std::string options() const { return model + (strict ? " strict" : "") + more; }
};

/// Throws InputError where an output cannot be, or would replace an input.
void require_sweep_outputs(const SweepFile& sweep, const SweepRequest& request,
                           std::vector<std::filesystem::path> inputs);
/// The sweep with all that its results depend on.
AskedSweep asked_sweep(const SweepRequest& request, SweepFile sweep);
/// Says how many cases are too many to keep their fields. Said where it is decided: not in each part.
void say_what_is_kept(const SweepFile& sweep);
/// Writes the CSV files of the output, and prints what it says.
ExitCode say_what_was_found(const AskedSweep& asked, const SweepRequest& request, const std::string& head);
/// Solves all cases that the output or its parts do not have yet, on this machine.
ExitCode solve_whole_sweep(const SweepRequest& request, SweepFile sweep);

} // namespace bem_contact::app
