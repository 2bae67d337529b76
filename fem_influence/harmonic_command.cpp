#include "fem_influence/commands.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/interrupt_note.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/base/printable.hpp"
#include "bem_contact/influence/file_seal.hpp"
#include "bem_contact/profile/bodies/body_file.hpp"
#include "bem_contact/profile/standard_profiles.hpp"
#include "fem_influence/harmonic/harmonic_run.hpp"
#include "fem_influence/progress_bar.hpp"
#include "fem_influence/shared/parallel.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <optional>

namespace bem_contact::fem {

namespace {

void print(const RunReport& report, const std::string& output) {
  print_error(
      "{}: {} stations, {} wavenumbers and {} of the companion ({} from an earlier run), {} cells, {} "
      "unknowns\n"
      "  {:.1f} s on {} process(es), at most {:.2f} GiB each; all processes together: assembly {:.1f} s, "
      "analysis {:.1f} s, factors and kernel {:.1f} s\n"
      "  Maxwell-Betti {:.1e}, reaction {:.1e}, smallest eigenvalue {:.1e} of the largest self number\n",
      output, report.stations, report.wavenumbers, report.companion_wavenumbers, report.resumed, report.cells,
      report.unknowns, report.seconds, process_count(), report.peak_memory, report.timing.assembly,
      report.timing.analysis, report.timing.factorization, report.betti_error, report.reaction_error,
      report.smallest_eigenvalue);
  if (report.companion_wavenumbers > 0)
    print_error("  estimated error {:.1e} of the number itself (mesh {:.1e}, wavenumbers {:.1e})\n",
                report.error.total, report.error.mesh, report.error.samples);
  else
    print_error("  the error was not estimated (degree 1 has no companion)\n");
}

} // namespace

void harmonic_command(const std::string& body_file, const std::string& mesh, const std::string& output) {
  std::optional<BodyFile> body;
  std::optional<ProfileCurve> curve;
  together([&] {
    body = read_body_file(body_file);
    require_outputs({body_file, profile_file_of(*body), mesh},
                    {{"--output", output, OutputForm::whole_file}});
    require_replaceable_influence(output);
    curve = body_profile(*body);
  });
  ProgressBar bar(fmt::format("{} stations, wavenumbers", body->strip.stations()));
  std::optional<InterruptNote> note;
  if (process_rank() == 0)
    note.emplace(
        "wavenumbers",
        fmt::format("Give the same command again to go on: '{0}.part' and '{0}.companion.part'{1} hold them.",
                    output, body->stress.depths > 0 ? fmt::format(" and '{}.stresses.part'", output) : ""));
  const RunReport report = run_harmonic(*body, *curve, mesh, output, [&](std::size_t done, std::size_t all) {
    bar.show(done, all);
    note->done(done, all);
  });
  if (process_rank() == 0)
    print(report, output);
}

} // namespace bem_contact::fem
