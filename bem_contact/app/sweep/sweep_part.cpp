#include "bem_contact/app/sweep/sweep_part.hpp"

#include "bem_contact/app/output/output_names.hpp"
#include "bem_contact/app/sweep/sweep_table.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/record/file_kinds.hpp"
#include "bem_contact/record/hdf5.hpp"
#include "bem_contact/sequence/result_file.hpp"

#include <fmt/format.h>
#include <new>

namespace bem_contact::app {

namespace {

/// nan where there is none.
double number_attribute(const H5Table& table, const std::string& name) {
  const auto found = table.attributes.find(name);
  const auto* number = found == table.attributes.end() ? nullptr : std::get_if<double>(&found->second);
  return number ? *number : std::nan("");
}

/// What the file says of its cases.
H5Table head_of(const AskedSweep& asked, CaseRange cases) {
  H5Table head = record::to_h5(headed(sweep_part_format));
  head.attributes["digest"] = asked.digest;
  head.attributes["first_case"] = static_cast<double>(cases.first);
  head.attributes["last_case"] = static_cast<double>(cases.last);
  return head;
}

} // namespace

SweepCut cut_of(const AskedSweep& asked) {
  return bem_contact::cut_of(asked.sweep, asked.model, *asked.files);
}

void solve_each(const AskedSweep& asked, CaseRange cases,
                const std::function<void(SweepCase, H5Table)>& kept) {
  H5Table group;
  SweepOptions options{
      .model = asked.model, .strict = asked.strict, .displacements = asked.sweep.keeps_fields()};
  if (asked.sweep.keeps_fields())
    options.seen = [&](const std::string& wheel, const SceneResult& result) {
      add_group(group, wheel, record::to_h5(case_record(result)));
    };
  solve_cases(asked.sweep, cases, options, asked.files, [&](SweepCase one) {
    if (!one.reason.empty())
      group.attributes["reason"] = std::exchange(one.reason, {});
    kept(std::move(one), std::exchange(group, {}));
    return true;
  });
}

CaseRange solve_part(const AskedSweep& asked, CaseRange cases, const std::filesystem::path& file,
                     const std::function<void()>& kept) {
  H5Writer writer(file);
  std::vector<SweepCase> solved;
  solve_each(asked, cases, [&](SweepCase one, H5Table group) {
    if (one.status == CaseStatus::died)
      throw std::bad_alloc();
    H5Table members;
    members.checksums = true;
    add_group(members, group_of_case(one.index) + "/", group);
    writer.add(members);
    solved.push_back(std::move(one));
    kept();
  });
  H5Table top = table_of(asked.sweep, asked.columns(), solved);
  add_group(top, "", head_of(asked, cases));
  top.checksums = true;
  writer.add(top);
  writer.finish();
  return cases;
}

namespace {

/// Throws InputError where the file is no part of this sweep.
CaseRange cases_in(const AskedSweep& asked, const std::filesystem::path& file, const H5Reader& reader) {
  const H5Table head = reader.attributes();
  const auto refuse = [&](const char* problem, const char* why, const char* what_to_do) {
    throw InputError(fmt::format("The file '{}' {}", file.string(), problem), why, what_to_do);
  };
  const std::string format = text_attribute(head, "format");
  if (format != sweep_part_format)
    refuse("is no part of a sweep", "it was not made by bem_contact sweep --cases", "Leave it out.");
  if (text_attribute(head, "digest") != asked.digest)
    refuse("belongs to another sweep", digest_changed,
           "Finish that sweep with what it began with, give another output, or solve its cases again.");
  const double first = number_attribute(head, "first_case"), last = number_attribute(head, "last_case");
  if (!(first >= 0 && first < last && last <= static_cast<double>(asked.sweep.size())))
    refuse("is damaged", "the sweep does not have its cases", "Solve them again.");
  return {static_cast<std::size_t>(first), static_cast<std::size_t>(last)};
}

} // namespace

CaseRange cases_in_part(const AskedSweep& asked, const std::filesystem::path& file) {
  return cases_in(asked, file, H5Reader(file));
}

SweepPart read_part(const AskedSweep& asked, const std::filesystem::path& file) {
  const H5Reader reader(file);
  const CaseRange cases = cases_in(asked, file, reader);
  return {file, cases, require_table(reader, asked.columns(), cases.size())};
}

} // namespace bem_contact::app
