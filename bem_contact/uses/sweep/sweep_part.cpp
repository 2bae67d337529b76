#include "bem_contact/uses/sweep/sweep_part.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/record/file_kinds.hpp"
#include "bem_contact/record/hdf5.hpp"
#include "bem_contact/sequence/result_file.hpp"
#include "bem_contact/uses/sweep/sweep_table.hpp"

#include <fmt/format.h>
#include <new>

namespace bem_contact {

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
  return cut_of(asked.sweep, asked.model, *asked.files);
}

void solve_each(const AskedSweep& asked, CaseRange cases, const std::function<void(SweepCase, H5Table)>& kept,
                const std::atomic<bool>* stop) {
  H5Table group;
  SweepOptions options{.model = asked.model,
                       .strict = asked.strict,
                       .displacements = asked.sweep.keeps_fields(),
                       .stop = stop};
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
                     const std::function<void()>& kept, const std::atomic<bool>* stop) {
  H5Writer writer(file);
  std::vector<SweepCase> solved;
  const auto keep = [&](SweepCase one, const H5Table& group) {
    if (one.status == record::Outcome::died)
      throw std::bad_alloc();
    H5Table members;
    members.checksums = true;
    add_group(members, group_of_case(one.index) + "/", group);
    writer.add(members);
    solved.push_back(std::move(one));
    kept();
  };
  solve_each(asked, cases, keep, stop);
  H5Table top = table_of(asked.sweep, asked.columns(), solved);
  add_group(top, "", head_of(asked, cases));
  add_origins(top, asked.origins);
  top.checksums = true;
  writer.add(top);
  writer.finish();
  return cases;
}

namespace {

/// What cannot be read is damaged.
template <class Read> auto or_damaged(Read read) {
  try {
    return read();
  } catch (const InputError& error) {
    throw PartFault(error.what(), "damaged", true);
  }
}

/// Throws what read_part() does.
CaseRange cases_in(const AskedSweep& asked, const H5Reader& reader) {
  const auto refuse = [&](const char* problem, const std::string& why, const char* what_to_do, bool damaged) {
    const Error error(fmt::format("The file '{}' {}", reader.file().string(), problem), why, what_to_do);
    throw PartFault(error.what(), fmt::format("{}: {}", problem, why), damaged);
  };
  const H5Table head = or_damaged([&] { return reader.attributes(); });
  if (text_attribute(head, "format") != sweep_part_format)
    refuse("is no part of a sweep", "it was not made by bem_contact sweep --cases", "Leave it out.", false);
  if (text_attribute(head, "digest") != asked.digest)
    refuse("belongs to another sweep", what_changed(reader, asked.origins),
           "Finish that sweep with what it began with, give another output, or solve its cases again.",
           false);
  const double first = number_attribute(head, "first_case"), last = number_attribute(head, "last_case");
  if (!(first >= 0 && first < last && last <= static_cast<double>(asked.sweep.size())))
    refuse("is damaged", "the sweep does not have its cases", "Solve them again.", true);
  return {static_cast<std::size_t>(first), static_cast<std::size_t>(last)};
}

} // namespace

bool is_part_of_sweep(const std::filesystem::path& file) {
  return record::format_of(file) == sweep_part_format;
}

CaseRange cases_in_part(const AskedSweep& asked, const std::filesystem::path& file) {
  return cases_in(asked, H5Reader(file));
}

SweepPart read_part(const AskedSweep& asked, const std::filesystem::path& file) {
  if (!is_regular(file))
    H5Reader{file}; // says that it is not there
  const H5Reader reader = or_damaged([&] { return H5Reader(file); });
  const CaseRange cases = cases_in(asked, reader);
  return {file, cases, or_damaged([&] { return require_table(reader, asked.columns(), cases.size()); })};
}

void require_whole(const std::filesystem::path& file) {
  or_damaged([&] { return read_h5(file); });
}

} // namespace bem_contact
