#include "bem_contact/uses/sweep/sweep_join.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/record/file_kinds.hpp"
#include "bem_contact/record/hdf5.hpp"
#include "bem_contact/uses/sweep/sweep_inputs.hpp"
#include "bem_contact/uses/sweep/sweep_table.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <functional>
#include <span>

namespace bem_contact {

namespace {

using LineReader = std::function<std::vector<double>(const std::string& name, std::size_t count)>;

/// A sweep's file while it grows.
class Joined {
public:
  Joined(const AskedSweep& asked, const std::filesystem::path& output) : asked_(asked), writer_(output) {}

  /// Comes before the table's rows. `patches`: of all cases.
  void begin_table(std::size_t patches) {
    const H5Table form = table_of(asked_.sweep, asked_.columns(), missing_cases({0, 1}));
    for (const auto& [name, data] : form.datasets) {
      names_.push_back(name);
      writer_.add_line(name, name.starts_with(patch_group) ? patches : asked_.sweep.size(), data);
    }
  }

  void add(const SweepPart& part) {
    const H5Reader file(part.file);
    add_lines(part, [&](const std::string& name, std::size_t count) {
      file.require(name, count);
      return file.line(name, 0, count);
    });
    const std::set<std::string> groups = file.members("cases");
    for (std::size_t i = part.cases.first; !groups.empty() && i < part.cases.last; ++i)
      if (const std::string group = group_of_case(i); groups.contains(group.substr(group.find('/') + 1)))
        add_members(group, file.group(group));
  }

  /// Cases that were solved here, all of them.
  void add(std::span<const SweepCase> cases) {
    std::size_t patches = 0;
    for (const SweepCase& one : cases)
      patches += one.patches.size();
    begin_table(patches);
    add_rows({{}, asked_.sweep.all(), patches}, cases);
  }

  /// Cases that have none.
  void add(CaseRange cases, const DiedCases& died) {
    for (std::size_t first = cases.first; first < cases.last; first += rows_at_once) {
      const CaseRange some{first, std::min(cases.last, first + rows_at_once)};
      std::vector<SweepCase> empty = missing_cases(some);
      for (auto one = died.lower_bound(some.first); one != died.end() && one->first < some.last; ++one) {
        empty[one->first - some.first].status = record::Outcome::died;
        H5Table reason;
        reason.attributes["reason"] = one->second;
        add_members(group_of_case(one->first), reason);
      }
      add_rows({{}, some}, empty);
    }
  }

  void add_members(const std::string& group, const H5Table& members) {
    H5Table table;
    add_group(table, group + "/", members);
    writer_.add(table);
  }

  void finish(const std::filesystem::path& output) {
    H5Table top = record::to_h5(headed(sweep_format, given_sweep(asked_.sweep, asked_.model), output));
    top.attributes["digest"] = asked_.digest;
    add_origins(top, asked_.origins);
    add_counts(top, counts_);
    writer_.add(top);
    writer_.finish();
  }

private:
  void add_rows(const SweepPart& part, std::span<const SweepCase> cases) {
    const H5Table table = table_of(asked_.sweep, asked_.columns(), cases);
    add_lines(part, [&](const std::string& name, std::size_t) { return table.datasets.at(name).values; });
  }

  void add_lines(const SweepPart& part, const LineReader& read) {
    for (const std::string& name : names_) {
      const bool of_patches = name.starts_with(patch_group);
      const std::vector<double> values = read(name, of_patches ? part.patches : part.cases.size());
      if (name == "status")
        count(values, part);
      if (name == std::string(patch_group) + "case")
        require_within(part.cases, values, name, part.file);
      writer_.put(name, values);
    }
  }

  void count(const std::vector<double>& status, const SweepPart& part) {
    require_within({0, counts_.size()}, status, "status", part.file);
    for (const double one : status)
      ++counts_[static_cast<std::size_t>(one)];
  }

  const AskedSweep& asked_;
  H5Writer writer_;
  std::vector<std::string> names_;
  std::array<std::size_t, record::outcomes_of_cases> counts_{};
};

} // namespace

std::vector<std::filesystem::path> files_of_parts(const std::vector<std::filesystem::path>& names) {
  namespace fs = std::filesystem;
  std::vector<fs::path> files;
  for (const fs::path& name : names) {
    std::error_code failed;
    if (!fs::is_directory(name, failed)) {
      files.push_back(name);
      continue;
    }
    for (fs::directory_iterator at(name, failed), end; !failed && at != end; at.increment(failed))
      if (at->path().extension() == ".h5" && is_regular(at->path()))
        files.push_back(at->path());
    if (failed)
      throw InputError(fmt::format("The folder '{}' of parts cannot be read", name.string()),
                       failed.message(), "Look at its rights, or name the parts.");
  }
  std::ranges::sort(files);
  return files;
}

FoundParts find_parts(const AskedSweep& asked, const std::vector<std::filesystem::path>& names,
                      PartCheck check) {
  FoundParts found;
  for (const std::filesystem::path& file : files_of_parts(names))
    try {
      SweepPart part = read_part(asked, file);
      if (check == PartCheck::all)
        require_whole(file);
      found.parts.push_back(std::move(part));
    } catch (const PartFault& fault) {
      if (fault.damaged)
        found.damaged.push_back(file);
      if (found.others.empty())
        found.first_fault = fault.what();
      found.others[fault.why].push_back(fmt::format("'{}'", file.string()));
    }
  std::vector<SweepPart>& parts = found.parts;
  std::ranges::sort(parts, {}, [](const SweepPart& part) { return part.cases.first; });
  for (std::size_t k = 1; k < parts.size(); ++k)
    if (parts[k].cases.first < parts[k - 1].cases.last)
      throw InputError(fmt::format("Two parts of the sweep have case {}", parts[k].cases.first),
                       fmt::format("'{}' and '{}'", parts[k - 1].file.string(), parts[k].file.string()),
                       "Leave out one of them.");
  return found;
}

void require_parts(const FoundParts& found) {
  std::size_t count = 0;
  std::vector<std::string> reasons;
  for (const auto& [why, names] : found.others) {
    count += names.size();
    reasons.push_back(fmt::format("{}: {}", why, fmt::join(names, ", ")));
  }
  if (count == 1)
    throw InputError(found.first_fault);
  if (count > 1)
    throw InputError(fmt::format("{} parts of the sweep cannot be joined", count),
                     fmt::format("{}", fmt::join(reasons, "; ")),
                     "Remove them, and solve their cases again: --join then says which are missing.");
}

std::vector<SweepPart> read_parts(const AskedSweep& asked, const std::vector<std::filesystem::path>& names) {
  FoundParts found = find_parts(asked, names, PartCheck::head);
  if (!found.others.empty()) // all that are damaged are named at once
    require_parts(find_parts(asked, names, PartCheck::all));
  return std::move(found.parts);
}

std::vector<CaseRange> missing_ranges(const std::vector<SweepPart>& parts, std::size_t cases) {
  std::vector<CaseRange> out;
  std::size_t next = 0;
  const auto add_until = [&](std::size_t end) {
    if (next < end)
      out.push_back({next, end});
  };
  for (const SweepPart& part : parts) {
    add_until(part.cases.first);
    next = part.cases.last;
  }
  add_until(cases);
  return out;
}

void join(const AskedSweep& asked, const std::vector<SweepPart>& parts, const DiedCases& died,
          const std::filesystem::path& output) {
  std::size_t patches = 0;
  for (const SweepPart& part : parts)
    patches += part.patches;
  Joined joined(asked, output);
  joined.begin_table(patches);
  std::size_t next = 0;
  for (const SweepPart& part : parts) { // rows of patches are in the order of their cases
    joined.add({next, part.cases.first}, died);
    joined.add(part);
    next = part.cases.last;
  }
  joined.add({next, asked.sweep.size()}, died);
  joined.finish(output);
}

void solve_whole(const AskedSweep& asked, const std::filesystem::path& output,
                 const std::function<void()>& kept) {
  Joined joined(asked, output);
  std::vector<SweepCase> solved;
  solve_each(asked, asked.sweep.all(), [&](SweepCase one, H5Table members) {
    if (!members.datasets.empty() || !members.attributes.empty() || !members.texts.empty())
      joined.add_members(group_of_case(one.index), members);
    solved.push_back(std::move(one));
    kept();
  });
  joined.add(solved);
  joined.finish(output);
}

} // namespace bem_contact
