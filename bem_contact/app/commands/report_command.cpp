#include "bem_contact/app/command.hpp"
#include "bem_contact/app/output/output_names.hpp"
#include "bem_contact/app/output/repeat.hpp"
#include "bem_contact/base/argument_error.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/report/report_page.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>
#include <string>

namespace bem_contact::app {

namespace {

constexpr const char* report_help =
    R"(Takes what solve, compare, sweep, creep-curves, conicity and wheelset wrote with -o, and the wear.h5 of wear. Example:
    bem_contact solve data/scenes/conformal_small.toml -o corner.h5
    bem_contact report corner.h5 -o corner.html
Open corner.html in a browser. You should see the scene in words, whether the certificate holds, the numbers with their
errors, and figures of the bodies and the patch. The page needs no network and no other file.)";

struct ReportArguments {
  std::string file, output;
};

} // namespace

Command add_report(CLI::App& program) {
  const auto arguments = std::make_shared<ReportArguments>();
  CLI::App* line = program.add_subcommand("report", "One HTML page of a result file: words, tables, figures");
  line->add_option("file", arguments->file,
                   "Result, comparison, sweep, creep curves, conicity, wheelset or wear (HDF5)")
      ->required();
  add_output_option(*line, "-o,--output", arguments->output, "The page (HTML)")->required();
  line->footer(report_help);
  return {line, [arguments] {
            if (is_regular(arguments->file) && !is_hdf5(arguments->file))
              throw InputError(
                  fmt::format("'{}' cannot be shown as a page", arguments->file),
                  "it is no HDF5 file; report takes what solve, compare, sweep, creep-curves, conicity and "
                  "wheelset wrote with -o, and the wear.h5 of wear",
                  "Give one of these; open a CSV file in a spreadsheet, or draw it with bem_contact plot.");
            require_page_name({.option = "--output", .file = arguments->output});
            report::write_report(arguments->file, arguments->output);
            return success;
          }};
}

} // namespace bem_contact::app
