#include "bem_contact/explore/profile_remarks.hpp"

#include "bem_contact/profile/messages.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "bem_contact/profile/standard_profiles.hpp"
#include "bem_contact/profile/worn/like_standard.hpp"
#include "bem_contact/scene/warnings.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <future>
#include <iterator>

namespace bem_contact::explore {

namespace {

/// Whether the profile is one of measured points.
bool is_measured(const std::string& name) {
  return !name.empty() && !is_standard_profile(name) && !name.ends_with(".toml");
}

std::string key_of_reading(const std::string& file, const ProfileReading& r, double inclination) {
  return fmt::format("{} {} {} {} {} {} {} {} {} {}", file, r.smoothing, r.nominal, int(r.unit),
                     int(r.profile_z), r.mirror, r.flange_back.value_or(0), r.tape_circle, r.keep_origin,
                     inclination);
}

} // namespace

const ProfileRemarks::Remarks& ProfileRemarks::of_file(const SceneFile& scene, ProfileKind kind) {
  const bool rail = kind == ProfileKind::rail;
  const std::string& name = rail ? scene.rail.profile : scene.wheel.profile;
  const ProfileReading& reading = rail ? scene.rail.reading : scene.wheel.reading;
  const double inclination = rail ? scene.position.rail_inclination : 0;
  const auto [file, part] = profile_file_name(name, scene.folder);
  const std::string body(name_of(kind));
  const auto [at, is_new] =
      known_.try_emplace(key_of_reading(fmt::format("{} {}", file.string(), part), reading, inclination));
  if (!is_new)
    return at->second;
  CollectedMessages said;
  const MeasuredProfile read = measured_profile(file, kind, reading, part);
  for (const std::string& text : said.warnings()) {
    Remark remark{text};
    if (text == read.advice.noise_text && !read.advice.nominal.empty())
      remark = {text, body + ".nominal", fmt::format("\"{}\"", read.advice.nominal)};
    else if (text == read.advice.noise_text)
      remark = {text, body + ".smoothing", fmt::format("{:.2g}", read.advice.smoothing)};
    else if (text == read.advice.mirror_text)
      remark = {text, body + ".mirror", read.advice.mirror.value_or(true) ? "true" : "false"};
    at->second.push_back(std::move(remark));
  }
  if (!rail || inclination == 0)
    return at->second;
  std::promise<double> turn;
  turn.set_value(rail_turn(read.curve, read.scatter_left()));
  const RailInclination known = turn.get_future().share();
  if (std::string text = inclined_twice(known, inclination); !text.empty())
    at->second.push_back(known.get() < 0
                             ? Remark{std::move(text), "position.rail_inclination", "0"}
                             : Remark{std::move(text), "rail.mirror", reading.mirror ? "false" : "true"});
  return at->second;
}

ProfileRemarks::Remarks ProfileRemarks::remarks_of(const SceneFile& scene) {
  Remarks out;
  for (const auto& [name, kind] :
       {std::pair(scene.rail.profile, ProfileKind::rail), std::pair(scene.wheel.profile, ProfileKind::wheel)})
    if (is_measured(name))
      std::ranges::copy(of_file(scene, kind), std::back_inserter(out));
  return out;
}

} // namespace bem_contact::explore
