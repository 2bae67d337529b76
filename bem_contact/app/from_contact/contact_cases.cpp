#include "bem_contact/app/from_contact/contact_cases.hpp"

#include "bem_contact/app/from_contact/histories.hpp"
#include "bem_contact/app/from_contact/patch_keys.hpp"
#include "bem_contact/app/from_contact/solved_cases.hpp"
#include "bem_contact/app/from_contact/wheel_rail_keys.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/contact_input/cases.hpp"

#include <charconv>
#include <fmt/format.h>
#include <tuple>
#include <utility>

// What stands where in the file, signs and frames: as CONTACT reads and documents them (E.A.H. Vollebregt,
// CONTACT, open source, github.com/eve70a/CONTACT).
namespace bem_contact::app::from_contact {

namespace {

using contact_input::CaseState;

ContactCase translate(const CaseState& state, const std::filesystem::path& folder) {
  ContactCase out;
  out.first = out.last = state.number;
  out.module = state.module;
  out.line = state.line;
  state.module == 1 ? add_wheel_rail_keys(state, folder, out) : add_patch_keys(state, out);
  return out;
}

/// The scenes so far, and the last one of each result element.
class Scenes {
public:
  void add(const CaseState& state, ContactCase one) {
    std::size_t& last = last_.try_emplace({state.module, state.element, state.patch}, nothing).first->second;
    solved_.set_forces(one);
    if (one.goes_on_from > 0 && last != nothing) {
      ContactCase& before = scenes_[last];
      one.goes_on_from = before.last;
      if (before.refused.empty() && one.refused.empty() && join(before, one))
        return;
      solved_.set_start(before, one);
    }
    last = scenes_.size();
    scenes_.push_back(std::move(one));
  }
  std::vector<ContactCase> take() && { return std::move(scenes_); }

private:
  static constexpr auto nothing = static_cast<std::size_t>(-1);
  std::vector<ContactCase> scenes_;
  std::map<std::tuple<int, int, int>, std::size_t> last_;
  SolvedCases solved_;
};

} // namespace

void ContactCase::set(const std::string& key, double value) {
  set(key, fmt::format("{:.14g}", value == 0 ? 0.0 : value)); // no -0
}

double ContactCase::number(const std::string& key) const {
  const auto found = keys.find(key);
  double out = 0;
  if (found != keys.end())
    std::from_chars(found->second.data(), found->second.data() + found->second.size(), out);
  return out;
}

ContactCases read_contact_cases(const std::filesystem::path& file) {
  const auto read =
      contact_input::read_cases(read_text_file(file.string(), "input file of CONTACT"), file.string());
  const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
  Scenes scenes;
  for (const CaseState& state : read.cases)
    scenes.add(state, translate(state, folder));
  return {std::move(scenes).take(), read.broken};
}

} // namespace bem_contact::app::from_contact
