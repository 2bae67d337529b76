#include "bem_contact/app/wear_influence.hpp"

#include "bem_contact/app/wear_state.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/influence/influence_file.hpp"
#include "bem_contact/influence/requirements.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "bem_contact/profile/standard_profiles.hpp"

#include <fmt/format.h>
#include <ostream>
#include <sstream>

namespace bem_contact::app {

namespace {

std::vector<Point2> points_in(const std::filesystem::path& file) {
  std::istringstream in(read_text_file(file.string(), "profile"));
  std::vector<Point2> points;
  for (Point2 p; in >> p.y >> p.z;)
    points.push_back(p);
  return points;
}

/// The body of these functions with another profile. Elements along x are the shortest that they serve.
std::string body_file_text(const InfluenceFunction& f, const char* body, const std::string& standard,
                           const std::string& profile_file) {
  const double half = f.station_width / 2;
  std::string out = fmt::format("# A worn body, written by bem_contact wear. The body file of the unworn one "
                                "may say more: copy its keys.\n"
                                "[body]\nkind = \"{}\"\nprofile = \"{}\"\nprofile_z = \"down\"\n",
                                body, profile_file);
  if (is_standard_profile(standard)) // where its body stands is known: in its own coordinates
    out += fmt::format("graft_onto = \"{}\"\ngraft_at = [0, 0]\ngraft_angle = 0\n", standard);
  out += fmt::format("\n[material]\nshear_modulus = {} # MPa\npoisson = {}\n", f.material.shear_modulus,
                     f.material.poisson);
  out += fmt::format("\n[strip]\nfrom = {:.9g} # mm\nto = {:.9g}\nstation_width = {:.9g}\n",
                     f.stations.front().s - half, f.stations.back().s + half, f.station_width);
  if (!f.is_table())
    out += fmt::format("\n[harmonic]\nshortest_dx = {:.6g} # mm\n", shortest_dx(f));
  return out;
}

void ask_for(const std::filesystem::path& file, int since, double turn, double kept_turn, const char* body,
             const std::string& text) {
  std::filesystem::path body_file = file;
  body_file.replace_extension("toml");
  if (!file_exists(body_file)) // the user may have completed it
    write_whole(body_file, [&](std::ostream& out) { out << text; });
  wear::refuse_outgrown(
      body, turn, kept_turn, fmt::format("step {}, where they were computed", since),
      fmt::format("Compute new ones, tools/influence {} {}, and give the same command again: "
                  "it goes on from here.",
                  body_file.string(), file.string()));
}

} // namespace

WearInfluence::WearInfluence(const SceneFile& scene, const wear::WornPair& unworn,
                             std::filesystem::path folder)
    : scene_folder_(scene.folder), folder_(std::move(folder)), used_(wear::needs_influence(scene)),
      rail_{"rail", ProfileKind::rail, scene.rail, 0}, wheel_{"wheel", ProfileKind::wheel, scene.wheel, 0} {
  if (!used_)
    return;
  begin(rail_, kept_.rail, unworn.rail);
  begin(wheel_, kept_.wheel, unworn.wheel);
}

void WearInfluence::begin(Side& side, wear::KeptInfluence& kept, const wear::WornBody& unworn) {
  if (side.scene.influence.empty())
    return; // the solution says what is missing
  kept = {scene_folder_ / side.scene.influence, unworn.points};
  const ProfileCurve curve = named_profile(side.scene.profile, side.kind, scene_folder_, side.scene.reading);
  require_profile(read_influence_file(kept.file), curve.name(), curve.digest());
}

void WearInfluence::take_newest(Side& side, wear::KeptInfluence& kept, int step) {
  for (int k = step; k > side.step; --k) {
    const std::filesystem::path file = folder_ / step_file(side.name, k, "h5");
    if (!file_exists(file))
      continue;
    const std::filesystem::path profile = folder_ / step_file(side.name, k, "txt");
    const ProfileCurve curve = named_profile(std::filesystem::absolute(profile).string(), side.kind, {},
                                             {.profile_z = ProfileZ::down});
    require_profile(read_influence_file(file), curve.name(), curve.digest());
    kept = {file, points_in(profile)};
    side.step = k;
    return;
  }
}

const wear::KeptPair& WearInfluence::at(int step, const wear::WornPair& now, double kept_turn) {
  if (!used_)
    return kept_;
  const auto follow = [&](Side& side, wear::KeptInfluence& kept, const wear::WornBody& body) {
    const auto turn = [&] { return wear::turn_between(kept.shape, body.points); };
    if (kept.file.empty())
      return;
    if (!resumed_ || turn() > kept_turn)
      take_newest(side, kept, step);
    if (turn() > kept_turn)
      ask_for(folder_ / step_file(side.name, step, "h5"), side.step, turn(), kept_turn, side.name,
              body_file_text(read_influence_file(kept.file), side.name, side.scene.profile,
                             step_file(side.name, step, "txt")));
  };
  follow(rail_, kept_.rail, now.rail);
  follow(wheel_, kept_.wheel, now.wheel);
  resumed_ = true;
  return kept_;
}

} // namespace bem_contact::app
