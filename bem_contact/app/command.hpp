#pragma once

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
}
namespace bem_contact {
class Warnings;
}

namespace bem_contact::app {

/// What the program returns to the shell. `unforeseen`: neither the input nor the problem is to blame
/// (a disk gets full, a process cannot be started, an error of the program itself).
enum ExitCode { success = 0, unforeseen = 1, wrong_input = 2, no_convergence = 3 };

/// A subcommand: its options and its help are in `line`, `run` does it once the options are parsed.
/// Errors are thrown; run_program() turns them into messages and exit codes.
struct Command {
  CLI::App* line = nullptr;
  std::function<ExitCode()> run;
};

// Options that several commands have.
void add_model(CLI::App& line, std::string& model);   ///< --model
void add_strict(CLI::App& line, bool& strict);        ///< --strict
void add_jobs(CLI::App& line, int& jobs);             ///< --jobs
void add_output(CLI::App& line, std::string& output); ///< --output, of a result file
void add_json(CLI::App& line, bool& json);            ///< --json

/// Refuses empty values, nan and inf where an option of this command takes a number, and a number below 0
/// where it counts: the library reads both without a word. Comes after all options.
void refuse_odd_numbers(CLI::App& line);

/// Prints each on the error output.
void warn(const std::vector<std::string>& warnings);
void warn(const Warnings& warnings);

// The commands of the program. Each function adds the options and the help of one.
Command add_new(CLI::App& program);          ///< a scene to begin with
Command add_from_contact(CLI::App& program); ///< scenes of an input file of CONTACT
Command add_solve(CLI::App& program);        ///< one scene with one model
Command add_compare(CLI::App& program);      ///< half-space and finite elements at the same forces
Command add_check(CLI::App& program);        ///< what would be solved
Command add_schema(CLI::App& program);       ///< the keys of a scene
Command add_info(CLI::App& program);         ///< what is in a file
Command add_influence(CLI::App& program);    ///< `influence expand`: influence numbers of a grid
Command add_profile(CLI::App& program);      ///< a profile in words
Command add_sweep(CLI::App& program);        ///< a scene for lists or ranges of any of its keys
Command add_replay(CLI::App& program);       ///< each step of a vehicle program's run
Command add_conicity(CLI::App& program);     ///< how a rigid wheelset steers itself
Command add_creep_curves(CLI::App& program); ///< forces over creepages
Command add_fit(CLI::App& program);          ///< keys of a scene, by measured forces
Command add_table(CLI::App& program);        ///< tables of forces, and values of such a table
Command add_fmu(CLI::App& program);          ///< such a table as an element for other programs
Command add_wear(CLI::App& program);         ///< profiles wear under a load collective
Command add_fatigue(CLI::App& program);      ///< shakedown, damage and stresses of each case of a sweep
Command add_stresses(CLI::App& program);     ///< which stresses are inside wheel and rail?
Command add_shakedown(CLI::App& program);    ///< does the steel below a contact yield for ever?
Command add_wheelset(CLI::App& program);     ///< both wheels under the forces on their axle
Command add_study(CLI::App& program);        ///< all answers to one scene
Command add_report(CLI::App& program);       ///< a result file as one HTML page
Command add_explore(CLI::App& program);      ///< a page in the browser that solves as one moves it
Command add_plot(CLI::App& program);         ///< a picture of a file; Python draws it

/// Lists the commands in the order of the program's help.
inline constexpr Command (*all_commands[])(CLI::App& program) = {
    add_new,       add_from_contact, add_solve,   add_compare, add_check,    add_schema,       add_info,
    add_influence, add_profile,      add_sweep,   add_replay,  add_conicity, add_creep_curves, add_fit,
    add_table,     add_fmu,          add_wear,    add_fatigue, add_stresses, add_shakedown,    add_wheelset,
    add_study,     add_report,       add_explore, add_plot};

} // namespace bem_contact::app
