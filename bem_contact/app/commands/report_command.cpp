#include "bem_contact/app/command.hpp"
#include "bem_contact/app/output/output_names.hpp"
#include "bem_contact/app/output/repeat.hpp"
#include "bem_contact/base/argument_error.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/influence/file_seal.hpp"
#include "bem_contact/influence/influence_file.hpp"
#include "bem_contact/report/report_page.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <string>

namespace bem_contact::app {

namespace {

constexpr const char* report_help =
    R"(Takes what solve, compare, sweep, creep-curves, fit, conicity, wheelset, table, fatigue, shakedown and wear wrote with -o, the wear.h5 of a wear study,
the study.h5 of study, influence files, and meshes of mesh_body. Example:
    bem_contact solve data/scenes/conformal_small.toml -o corner.h5
    bem_contact report corner.h5 -o corner.html
Open corner.html in a browser. You should see the scene in words, whether the certificate holds, the numbers with their
errors, and figures of the bodies and the patch. The page needs no network and no other file.)";

struct ReportArguments {
  std::string file, output;
};

/// Refuses what has no page: any file but HDF5, a mesh, and an influence file whose seal holds.
void require_shown(const std::filesystem::path& file) {
  if (begins_with_seal(file))
    check_seal(file, influence_format_major);
  else if (is_regular(file) && !is_hdf5(file) && file.extension() != report::mesh_ending)
    throw InputError(
        fmt::format("'{}' cannot be shown as a page", file.string()),
        "it is no HDF5 file; report takes what solve, compare, sweep, creep-curves, fit, conicity, wheelset, "
        "table, fatigue, shakedown, wear and study wrote, influence files and meshes",
        "Give one of these. Mesh a body file first (mesh_body BODY.toml -o BODY.msh); open a CSV file in a "
        "spreadsheet, or draw it with bem_contact plot.");
}

} // namespace

Command add_report(CLI::App& program) {
  const auto arguments = std::make_shared<ReportArguments>();
  CLI::App* line = program.add_subcommand("report", "One HTML page of a result file: words, tables, figures");
  line->add_option("file", arguments->file,
                   "What another command wrote, an influence file (HDF5), or a mesh (.msh)")
      ->required();
  add_output_option(*line, "-o,--output", arguments->output, "The page (HTML)")->required();
  line->footer(report_help);
  return {line, [arguments] {
            require_shown(arguments->file);
            require_page_name({.option = "--output", .file = arguments->output});
            report::write_report(arguments->file, arguments->output);
            return success;
          }};
}

} // namespace bem_contact::app
