#include "bem_contact/app/wear/wear_influence.hpp"

#include "bem_contact/app/wear/wear_state.hpp"
#include "bem_contact/base/child_process.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/base/schema_text.hpp"
#include "bem_contact/influence/influence_file.hpp"
#include "bem_contact/influence/requirements.hpp"
#include "bem_contact/profile/messages.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "bem_contact/profile/standard_profiles.hpp"

#include <fmt/format.h>
#include <ostream>

namespace bem_contact::app {

namespace {

/// The body of these functions with another profile. Elements along x are the shortest that they serve.
std::string body_file_text(const InfluenceStrip& f, const char* body, const std::string& standard,
                           const std::string& profile_file) {
  const auto [from, to] = f.ends();
  std::string out = fmt::format("# A worn body, written by bem_contact wear. The body file of the unworn one "
                                "may say more: copy its keys.\n"
                                "[body]\nkind = \"{}\"\nprofile = {}\nprofile_z = \"down\"\n",
                                body, toml_text(profile_file));
  if (is_standard_profile(standard)) // where its body stands is known: in its own coordinates
    out += fmt::format("graft_onto = {}\ngraft_at = [0, 0]\ngraft_angle = 0\n", toml_text(standard));
  out += fmt::format("\n[material]\nshear_modulus = {} # MPa\npoisson = {}\n", f.material.shear_modulus,
                     f.material.poisson);
  out += fmt::format("\n[strip]\nfrom = {:.9g} # mm\nto = {:.9g}\nstation_width = {:.9g}\n", from, to,
                     f.station_width);
  if (!f.is_table())
    out += fmt::format("\n[harmonic]\nshortest_dx = {:.6g} # mm\n", shortest_dx(f));
  return out;
}

/// Runs `program` on a body file; what it prints goes to standard error. Throws InputError where it fails.
void compute(const std::string& program, const std::filesystem::path& body_file,
             const std::filesystem::path& file) {
  std::string why;
  if (!run_and_wait({program, body_file.string(), file.string()}, why) || !file_exists(file))
    throw InputError(
        fmt::format("'{} {} {}' has made no influence functions", program, body_file.string(), file.string()),
        why.empty() ? "it failed, or wrote no such file" : why,
        "Call it alone to see why. Then give the same command again: it goes on from here.");
}

} // namespace

WearInfluence::WearInfluence(const SceneFile& scene, const wear::WornPair& unworn,
                             std::filesystem::path folder, std::string program)
    : folder_(std::move(folder)), program_(std::move(program)), used_(wear::needs_influence(scene)),
      rail_{"rail", ProfileKind::rail, scene.rail, 0}, wheel_{"wheel", ProfileKind::wheel, scene.wheel, 0} {
  if (used_)
    kept_ = wear::unworn_influence(scene, unworn);
}

void WearInfluence::take_newest(Side& side, wear::KeptInfluence& kept, int step) {
  for (int k = step; k > side.step; --k) {
    const std::filesystem::path file = folder_ / step_file(side.name, k, "h5");
    if (!file_exists(file))
      continue;
    const std::filesystem::path profile = folder_ / step_file(side.name, k, "txt");
    const CollectedMessages unsaid; // of a profile that wear has written
    const ProfileCurve curve = named_profile(std::filesystem::absolute(profile).string(), side.kind, {},
                                             {.profile_z = ProfileZ::down});
    require_profile(InfluenceFile(file).strip(), curve.name(), curve.digest());
    kept = {file, read_points(profile)};
    side.step = k;
    return;
  }
}

void WearInfluence::renew(const Side& side, const wear::KeptInfluence& kept, int step, double turn,
                          double kept_turn) const {
  const std::filesystem::path file = folder_ / step_file(side.name, step, "h5"),
                              body_file = folder_ / step_file(side.name, step, "toml");
  if (!file_exists(body_file)) // the user may have completed it
    write_whole(body_file, [&](std::ostream& out) {
      out << body_file_text(InfluenceFile(kept.file).strip(), side.name, side.scene.profile,
                            step_file(side.name, step, "txt"));
    });
  if (!program_.empty())
    return compute(program_, body_file, file);
  wear::refuse_outgrown(
      side.name, turn, kept_turn, fmt::format("step {}, where they were computed", side.step),
      fmt::format("Compute new ones, tools/influence {} {}, and give the same command again: it goes on "
                  "from here. With --influence tools/influence it does so itself.",
                  body_file.string(), file.string()));
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
    if (turn() > kept_turn) {
      renew(side, kept, step, turn(), kept_turn);
      take_newest(side, kept, step);
    }
  };
  follow(rail_, kept_.rail, now.rail);
  follow(wheel_, kept_.wheel, now.wheel);
  resumed_ = true;
  return kept_;
}

} // namespace bem_contact::app
