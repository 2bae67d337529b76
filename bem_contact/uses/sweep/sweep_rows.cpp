#include "bem_contact/uses/sweep/sweep_rows.hpp"

#include "bem_contact/uses/sweep/sweep_table.hpp"

#include <algorithm>
#include <set>

namespace bem_contact {

SweepRows rows_of(CaseRange cases, std::span<const SweepCase> solved, const SweepColumns& columns) {
  SweepRows out{.cases = cases, .numbers = numbers_of(solved, columns)};
  for (const SweepCase& one : solved) {
    out.status.push_back(one.status);
    if (!one.reason.empty())
      out.reasons[one.index] = one.reason;
  }
  return out;
}

SweepRows read_rows(const SweepPart& part, const SweepColumns& columns) {
  const H5Reader file(part.file);
  const std::size_t count = part.cases.size();
  const std::string group = patch_group;
  SweepRows out{.cases = part.cases};
  const std::vector<double> status = file.line("status", 0, count);
  require_within({0, record::outcomes_of_cases}, status, "status", part.file);
  for (const double one : status)
    out.status.push_back(static_cast<record::Outcome>(one));
  for (const SweepColumn& column : columns.cases)
    out.numbers.cases.push_back(file.line(column.name, 0, count));
  if (part.patches > 0) {
    const std::vector<double> of = file.line(group + "case", 0, part.patches),
                              rank = file.line(group + "patch", 0, part.patches);
    require_within(part.cases, of, group + "case", part.file);
    require_within({1, part.patches + 1}, rank, group + "patch", part.file);
    out.numbers.patch_case.assign(of.begin(), of.end());
    out.numbers.patch_rank.assign(rank.begin(), rank.end());
  }
  for (const SweepColumn& column : columns.patches)
    out.numbers.patches.push_back(file.line(group + column.name, 0, part.patches));
  const std::set<std::string> groups = file.members("cases");
  for (std::size_t i = part.cases.first; !groups.empty() && i < part.cases.last; ++i)
    if (const std::string reason = file.text(group_of_case(i), "reason"); !reason.empty())
      out.reasons[i] = reason;
  return out;
}

} // namespace bem_contact
