#include "bem_contact/app/command.hpp"
#include "bem_contact/app/fmu/fmu_binary.hpp"
#include "bem_contact/app/fmu/zip_file.hpp"
#include "bem_contact/app/output/output_names.hpp"
#include "bem_contact/base/argument_error.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/printable.hpp"
#include "bem_contact/uses/table/fmu.hpp"
#include "bem_contact/uses/table/table_file.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <memory>

namespace bem_contact::app {

namespace {

constexpr const char* fmu_help =
    R"(A table of `bem_contact table` as a Functional Mock-up Unit (FMI 3.0 or 2.0; co-simulation and model exchange), which
Simulink, OpenModelica and most programs for vehicles and systems take. Its inputs are the axes of the table, its outputs
the columns, with directional derivatives. Outside of the axes a call is discarded (fmi3Discard): there is never a number.
    bem_contact table data/scenes/forces_to_look_up.toml --tolerance 0.05 -o forces.h5
    bem_contact fmu forces.h5 -o contact.fmu
You should see the inputs, the outputs, and for which machines it has binaries. The C source is inside in any case.
More: data/tutorial/fmu.md.

Exit code 0: the FMU is written; 1: the compiler failed; 2: the input is wrong, or there is no C compiler.)";

struct FmuArguments {
  std::string input, output, name;
  table::FmuOptions options{.model = "", .columns = {"Fx", "Fy", "Fz", "Mz"}};
  std::string version = "3.0";
  bool sources_only = false;
};

/// The folder of a platform in `binaries`.
const std::string& folder_of(const FmuPlatform& platform, table::FmiVersion version) {
  return version == table::FmiVersion::v2 ? platform.folder2 : platform.folder3;
}

/// The files of the FMU; `made` and `missing`: for which machines there is a binary, or none and why.
std::vector<ZipEntry> entries_of(const table::Fmu& fmu, const FmuArguments& arguments,
                                 std::vector<std::string>& made, std::vector<std::string>& missing) {
  std::vector<ZipEntry> out{{"modelDescription.xml", fmu.description}};
  if (!fmu.build.empty())
    out.push_back({"sources/buildDescription.xml", fmu.build});
  out.push_back({fmt::format("sources/{}.c", fmu.model), fmu.source});
  for (const FmuPlatform& platform : fmu_platforms()) {
    const std::string& folder = folder_of(platform, arguments.options.version);
    if (arguments.sources_only || folder.empty())
      continue;
    if (!has_compiler(platform)) {
      missing.push_back(fmt::format("{} ({} is not there)", folder, platform.compiler));
      continue;
    }
    out.push_back(
        {fmt::format("binaries/{}/{}{}", folder, fmu.model, platform.ending), compiled(fmu, platform)});
    made.push_back(folder);
  }
  if (made.empty() && !arguments.sources_only)
    throw InputError(
        "The FMU has no binary", fmt::format("{}", fmt::join(missing, "; ")),
        "Install a C compiler (Debian: gcc and libc6-dev), or write one with sources alone: --sources-only.");
  return out;
}

ExitCode run(FmuArguments arguments) {
  table::FmuOptions& options = arguments.options;
  options.version = arguments.version == "2.0" ? table::FmiVersion::v2 : table::FmiVersion::v3;
  options.model =
      arguments.name.empty() ? std::filesystem::path(arguments.output).stem().string() : arguments.name;
  require_named_outputs({arguments.input}, {{"--output", arguments.output, OutputForm::whole_file, true}});
  const table::ContactTable t = table::read_table(arguments.input);
  const table::Fmu fmu = table::fmu_of(t, options);
  std::vector<std::string> made, missing, inputs;
  write_zip(arguments.output, entries_of(fmu, arguments, made, missing));
  for (const table::Axis& axis : t.axes)
    inputs.push_back(axis.name);
  print_out("'{}' is an FMU (FMI {}) for co-simulation and model exchange: {}\n  inputs    {}\n  outputs   "
            "{}, margin\n  "
            "binaries  {}\n",
            arguments.output, arguments.version, fmu.model, fmt::join(inputs, ", "),
            fmt::join(options.columns, ", "),
            made.empty() ? "none" : fmt::format("{}", fmt::join(made, ", ")));
  if (!missing.empty())
    print_out("  without   {}\n", fmt::join(missing, ", "));
  return success;
}

} // namespace

Command add_fmu(CLI::App& program) {
  const auto arguments = std::make_shared<FmuArguments>();
  FmuArguments& a = *arguments;
  CLI::App* line =
      program.add_subcommand("fmu", "A table as an element for Simulink, OpenModelica and others");
  line->add_option("table", a.input, "Table of a scene (HDF5)")->required();
  add_output_option(*line, "-o,--output", a.output, "The FMU (.fmu)")->required();
  line->add_option("--fmi", a.version, "Version of the standard")
      ->check(CLI::IsMember({"3.0", "2.0"}))
      ->capture_default_str();
  line->add_option("--columns", a.options.columns, "Which numbers of the table are outputs")
      ->delimiter(',')
      ->configurable(false)
      ->capture_default_str();
  line->add_flag("--si", a.options.si, "Inputs and outputs in m, N, Pa and s instead of mm, N, MPa and s")
      ->configurable(false);
  line->add_option("--name", a.name, "Name of the element, a name of C; else that of the file")
      ->configurable(false);
  line->add_flag("--sources-only", a.sources_only, "The C source without binaries")->configurable(false);
  line->footer(fmu_help);
  return {line, [arguments] { return run(*arguments); }};
}

} // namespace bem_contact::app
