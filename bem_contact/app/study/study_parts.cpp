#include "bem_contact/app/study/study_parts.hpp"

#include "bem_contact/app/command.hpp"
#include "bem_contact/app/study/part_run.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/base/output_folder.hpp"
#include "bem_contact/record/hdf5.hpp"
#include "bem_contact/scene/command_tables.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <ostream>

namespace bem_contact::app {

namespace {

bool takes_one_wheel(const StudyCase& study) {
  return std::ranges::any_of(all_parts(), [&](const Part& p) { return p.of_one_wheel && study.has(p.name); });
}

/// Asked for by the table of its name.
template <std::size_t size> struct Table {
  consteval Table(const char (&from)[size]) { std::ranges::copy(from, text); }
  char text[size];
};
template <Table table> constexpr auto has_table = [](const StudyCase& s) { return s.has(table.text); };

constexpr Part parts_of_studies[] = {
    {.name = "influence",
     .kind = PartKind::influence,
     .title = "Influence functions",
     .command = "",
     .asked = has_table<"influence">,
     .solves = false},
    {.name = "solve",
     .title = "The contact",
     .command = "solve",
     .asked = [](const StudyCase& s) { return !s.has("wheelset") && !s.has("sweep"); }},
    {.name = "wheelset",
     .kind = PartKind::wheelset,
     .title = "Both wheels",
     .command = "wheelset",
     .asked = [](const StudyCase& s) { return s.has("wheelset") && (!s.has("sweep") || takes_one_wheel(s)); },
     .of_one_wheelset = true},
    {.name = "sweep",
     .kind = PartKind::sweep,
     .title = "All cases",
     .command = "sweep",
     .asked = has_table<"sweep">,
     .has_jobs = true,
     .goes_on = true},
    {.name = "compare",
     .title = "Models of elasticity",
     .command = "compare",
     .asked = has_table<"compare">,
     .of_one_wheel = true,
     .has_models = true},
    {.name = "conicity",
     .title = "Conicity",
     .command = "conicity",
     .asked = has_table<"conicity">,
     .solves = false},
    {.name = "creep_curves",
     .title = "Creep curves",
     .command = "creep-curves",
     .asked = has_table<"creep_curves">,
     .of_one_wheel = true,
     .has_jobs = true},
    {.name = "fit",
     .title = "Keys by measured forces and pressures",
     .command = "fit",
     .asked = has_table<"fit">,
     .of_one_wheel = true},
    {.name = "table",
     .title = "Table of forces",
     .command = "table",
     .asked = has_table<"table">,
     .of_one_wheel = true,
     .has_jobs = true,
     .goes_on = true},
    {.name = "fatigue",
     .title = "Rolling contact fatigue",
     .command = "fatigue",
     .asked = has_table<"fatigue">,
     .of_one_wheel = true},
    {.name = "shakedown",
     .title = "Shakedown of the steel below",
     .command = "shakedown",
     .asked = has_table<"shakedown">,
     .of_one_wheel = true},
    {.name = "wear",
     .kind = PartKind::wear,
     .title = "Wear",
     .command = "wear",
     .asked = has_table<"wear">,
     .of_one_wheelset = true,
     .has_jobs = true},
};

void write_unswept(const StudyCase& study, const StudyFolder& where) {
  const std::string_view dropped[] = {"sweep", "passage"};
  const std::string text = changed_text(study.text, {}, dropped);
  write_whole(where.parts() / unswept, [&](std::ostream& out) { out << text; });
}

/// The scene of one wheel, for the parts that take one. It stays as it is where nothing has changed.
void write_wheel(const StudyCase& study, const StudyFolder& where, const PartResult& wheelset) {
  const std::string name = "wheel.toml";
  OutputFolder made(where.parts(), {.maker = study_maker, .list = "wheel", .inputs = where.inputs});
  if (wheelset.file.empty()) {
    made.remove(name);
    return;
  }
  const std::string_view dropped[] = {"sweep", "passage"}; // its cases are wheelsets
  const std::string text = changed_text(
      {wheel_text(study.text, record::read_hdf5(wheelset.file)), study.text.source, study.text.folder}, {},
      dropped);
  made.write(name, [&](std::ostream& out) { out << text; });
}

/// What is left of parts that the scene does not ask for any more.
void remove_parts_of_before(const StudyCase& study, const StudyFolder& where) {
  for (const Part& part : all_parts())
    if (!part.asked(study) &&
        OutputFolder::has_list(where.parts(), {.maker = study_maker, .list = part.name}))
      remove_part(part, study, where);
}

} // namespace

void make_study_folder(const StudyFolder& where) {
  const OutputFolder parts(where.parts(), {.maker = study_maker});
  std::error_code unknown;
  const std::filesystem::path whole = std::filesystem::weakly_canonical(parts.path(), unknown);
  for (const std::filesystem::path& input : where.inputs) {
    if (std::filesystem::weakly_canonical(input, unknown).parent_path() == whole)
      throw InputError(
          fmt::format("The study would overwrite '{}'", input.string()),
          fmt::format("it lies in '{}', where the parts of the study are written", parts.path().string()),
          "Give another folder, or move the file.");
  }
}

std::span<const Part> all_parts() {
  return parts_of_studies;
}

const Part* part_named(std::string_view name) {
  const auto found =
      std::ranges::find_if(parts_of_studies, [&](const Part& part) { return part.name == name; });
  return found == std::ranges::end(parts_of_studies) ? nullptr : found;
}

record::Outcome outcome_of(const PartResult& result) {
  switch (result.code) {
  case success:
    return result.part->solves ? record::Outcome::certified : record::Outcome::done;
  case wrong_input:
    return record::Outcome::refused;
  case no_convergence:
    return record::Outcome::not_certified;
  default:
    return record::Outcome::failed;
  }
}

std::vector<PartResult> run_parts(const StudyCase& study, const StudyFolder& where,
                                  std::set<std::string>& said,
                                  const std::function<void(const PartResult&)>& tell) {
  std::vector<PartResult> out;
  if (where.wanted.empty())
    remove_parts_of_before(study, where);
  if (study.has("wheelset") && study.has("sweep"))
    write_unswept(study, where);
  for (const Part& part : all_parts()) {
    const bool wanted = where.wanted.empty() || std::ranges::count(where.wanted, part.name) > 0;
    if (!part.asked(study) || !wanted)
      continue;
    out.push_back(run_part(part, study, where, said));
    if (part.kind == PartKind::wheelset)
      write_wheel(study, where, out.back());
    tell(out.back());
  }
  return out;
}

} // namespace bem_contact::app
