#include "bem_contact/app/command.hpp"
#include "bem_contact/app/output/repeat.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/printable.hpp"
#include "bem_contact/influence/file_seal.hpp"
#include "bem_contact/influence/influence_file.hpp"
#include "bem_contact/influence/requirements.hpp"
#include "bem_contact/record/error_text.hpp"
#include "bem_contact/record/file_kinds.hpp"
#include "bem_contact/record/found.hpp"
#include "bem_contact/record/hdf5.hpp"
#include "bem_contact/record/text.hpp"
#include "bem_contact/sequence/quantities.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <memory>

namespace bem_contact::app {

namespace {

/// The group of each result that the file holds whole: "" or "at_equal_forces/fem/".
void find_results(const record::Record& record, const std::string& path, std::vector<std::string>& groups) {
  if (record::number_at(record, "quantities/Fx"))
    groups.push_back(path);
  for (const record::Entry& entry : record.entries())
    if (const auto* inner = std::get_if<record::Record>(&entry.content))
      find_results(*inner, path + entry.name + "/", groups);
}

/// "  fem: Fx 5352 +- 130 N, ...": the main numbers of each.
std::string main_results(const record::Record& file) {
  std::vector<std::string> groups;
  find_results(file, "", groups);
  std::string out;
  for (const std::string& group : groups) {
    out += fmt::format("  {}:", group.empty() ? "result" : group.substr(0, group.size() - 1));
    for (const char* name : {"Fx", "Fy", "Fz", "Mz", "approach", "pmax", "area"}) {
      const auto of = [&](const std::string& path) {
        return record::number_at(file, group + "quantities/" + path).value_or(std::nan(""));
      };
      const double error = of(record::error_name(name));
      out += fmt::format(" {} {}{} {},", name,
                         record::fixed_within(of(name), error, name == std::string_view("approach") ? 5 : 2),
                         record::plus_minus(error), quantity(name).unit.rolling);
    }
    out += record::flag_at(file, group + "certified").value_or(false) ? " certified\n" : " NOT certified\n";
  }
  return out.empty() ? "" : "Main results\n" + out;
}

/// The fields of a sweep's cases are not read, but the reasons of some are.
record::Record without_cases(const record::Record& sweep) {
  record::Record out;
  for (const record::Entry& entry : sweep.entries())
    if (entry.name != "cases" || !std::holds_alternative<record::Record>(entry.content))
      out.add(entry.name, entry.content);
  return out;
}

std::string describe_record(const record::Record& file, const std::string& title) {
  return title + "\n" + record::found_text(file) + main_results(file) + record::to_text(file);
}

std::string describe_influence(const InfluenceFunction& f, std::uintmax_t bytes) {
  const auto [from, to] = f.ends();
  std::string out = "Influence functions of one body\n";
  out += fmt::format("  body: {}; profile: {} (checksum {:016x})\n", f.body, f.profile, f.profile_digest);
  out += fmt::format("  material: shear modulus {:g} MPa, Poisson's ratio {:g}\n", f.material.shear_modulus,
                     f.material.poisson);
  out += f.invariance == Invariance::prismatic
             ? std::string("  the body is the same all along x\n")
             : fmt::format("  the body is the same all around its axle {}, reference radius {:g} mm\n",
                           f.reference_radius > 0 ? "above the contact" : "below the contact",
                           std::abs(f.reference_radius));
  out += fmt::format("  held: {}\n  method: {}\n", f.held, f.method);
  out += fmt::format(
      "  strip: {} stations {:g} mm wide, s = {:.3f} .. {:.3f} mm, inclination {:.2f} .. {:.2f} degrees\n",
      f.station_count(), f.station_width, from, to, degrees(f.stations.front().delta),
      degrees(f.stations.back().delta));
  if (f.is_table())
    out += fmt::format(
        "  table of {} influence numbers along x, elements of {:g} mm and whole multiples of it\n",
        f.table_offsets(), f.table_dx);
  else
    out += fmt::format(
        "  {} wavenumbers, 0 .. {:g} 1/mm; half period {:g} mm: elements along x from {:.3g} mm{}, a "
        "patch up to {:.4g} mm long\n",
        f.wavenumber_count(), f.wavenumber.back(), f.half_period, shortest_dx(f),
        f.invariance == Invariance::revolution ? " (at the reference radius)" : "", f.half_period);
  out += fmt::format("  estimated error {}; Maxwell-Betti {:.1e}, reaction against load {:.1e}\n",
                     f.estimated_error < 0
                         ? std::string("not given")
                         : fmt::format("{:.2e} of the loaded element's own displacement", f.estimated_error),
                     f.betti_error, f.reaction_error);
  out += fmt::format("  size: {:.2f} MB on disk, at most {:.0f} MB in memory\n",
                     1e-6 * static_cast<double>(bytes),
                     8e-6 * static_cast<double>(f.kernel.size() + f.remote.size() + f.table.size()));
  return out;
}

/// An influence file, a result file, a sweep or plain influence numbers in words. Throws InputError for any
/// other file.
std::string describe_file(const std::filesystem::path& file) {
  // Only files whose seal holds go to HDF5.
  if (begins_with_seal(file)) {
    const InfluenceFunction function = read_influence_file(file);
    std::error_code unknown;
    return describe_influence(function, std::filesystem::file_size(file, unknown));
  }
  const record::Record top = record::read_hdf5_top(file, "patches"); // a sweep's fields may be large
  if (const FileKind* kind = kind_of(record::text_at(top, "format").value_or("")))
    return describe_record(kind == kind_of(sweep_format) || kind == kind_of(sweep_part_format)
                               ? without_cases(top)
                               : record::read_hdf5(file),
                           kind->title);
  throw InputError(fmt::format("'{}' is not a file of this project", file.string()),
                   "it is HDF5 and neither influence functions, nor plain numbers, nor a result, nor a sweep",
                   "Name a file that fem_influence or bem_contact wrote.");
}

} // namespace

Command add_info(CLI::App& program) {
  CLI::App* line = program.add_subcommand("info", "Describe an influence file, a result file or a sweep");
  const auto file = std::make_shared<std::string>();
  const auto scene = std::make_shared<bool>(false), with_defaults = std::make_shared<bool>(false);
  line->add_option("file", *file, "HDF5 file")->required();
  line->add_flag("--scene", *scene, "Print the scene of a result, comparison, sweep, ..., as it was given");
  line->add_flag("--scene-with-defaults", *with_defaults, "Print this scene with the value of every key");
  line->footer(R"(Example:
    bem_contact info data/influence/small_rail.h5
You should see which body the file is for (rail 60E1), its material, where it is held, the strip of its
profile that the file covers (s = -44 .. -20 mm), the shortest element along x that it has numbers for (0.5 mm), and
the estimated error of an influence number, relative to that of a loaded element on itself. For a result or a sweep
you see every dataset with its shape and unit.)");
  return {line, [file, scene, with_defaults] {
            print_out("{}",
                      *scene || *with_defaults ? stored_scene(*file, *with_defaults) : describe_file(*file));
            return success;
          }};
}

} // namespace bem_contact::app
