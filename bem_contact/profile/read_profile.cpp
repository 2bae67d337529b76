#include "bem_contact/profile/read_profile.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/profile/miniprof_format.hpp"
#include "bem_contact/profile/plain_columns.hpp"
#include "bem_contact/profile/profile_repair.hpp"
#include "bem_contact/profile/simpack_format.hpp"
#include "bem_contact/profile/standard_profiles.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace bem_contact {

namespace {

/// The contact curve of a body file; a rail is walked towards +y, a wheel towards -y.
ProfileCurve profile_of_body(const std::filesystem::path& file, ProfileKind kind) {
  const BodyFile body = read_body_file(file);
  if (body.body.profile.ends_with(".toml"))
    throw InputError(
        fmt::format("{} names the body file {} as its profile", file.string(), body.body.profile),
        "the profile of a body is a standard or a file of points", "Name that.");
  ProfileCurve curve = body_profile(body);
  const double delta = curve.at((curve.s_begin() + curve.s_end()) / 2).delta;
  if ((std::cos(delta) > 0) != (kind == ProfileKind::rail))
    throw InputError(fmt::format("the body in {} is {} body", file.string(),
                                 kind == ProfileKind::rail ? "an upper" : "a lower"),
                     fmt::format("a {} is asked for", name_of(kind)),
                     "Walk its contact surface the other way round, the material on the other side.");
  if (kind == ProfileKind::rail && body.body.kind == BodyKind::outline && body.body.reference_radius > 0)
    throw InputError(
        fmt::format("the body in {} is no rail: it is curved along x, about an axle {:g} mm above",
                    file.string(), body.body.reference_radius),
        "the distance of the surfaces is that to a straight rail",
        "Use kind = \"patch\": gap.a has the curvatures along x, and influence files of rings serve there.");
  return curve;
}

} // namespace

ProfileCurve parse_profile(std::string_view text, std::string_view source_name, ProfileKind kind) {
  const std::string source(source_name);
  if (text.starts_with("\xef\xbb\xbf")) // a byte order mark
    text.remove_prefix(3);
  if (std::ranges::count(text, '\n') > most_points)
    throw InputError(fmt::format("the profile {} has more than {} points", source, most_points),
                     "a measured profile has some thousands", "Take fewer of its points.");
  std::vector<Point2> points = is_simpack(text)    ? simpack_points(text, source, kind)
                               : is_miniprof(text) ? miniprof_points(text, source)
                                                   : plain_points(text, source);
  points = repaired(std::move(points), source, kind);
  return ProfileCurve::through_points(std::filesystem::path(source).filename().string(), points);
}

ProfileCurve read_profile(const std::filesystem::path& file, ProfileKind kind) {
  return parse_profile(read_text_file(file.string(), "profile file"), file.string(), kind);
}

ProfileCurve named_profile(std::string_view name, ProfileKind kind, const std::filesystem::path& folder) {
  if (is_standard_profile(name)) {
    const ProfileKind its_kind = name == "S1002" ? ProfileKind::wheel : ProfileKind::rail;
    if (its_kind != kind)
      throw InputError(fmt::format("{} is the profile of a {}", name, name_of(its_kind)),
                       fmt::format("a {} is asked for", name_of(kind)),
                       kind == ProfileKind::rail ? "Use for instance 60E1." : "Use for instance S1002.");
    return standard_profile(name);
  }
  const std::filesystem::path file = folder / std::filesystem::path(name); // an absolute path stays itself
  if (!file_exists(file)) {
    const bool uic = name.starts_with("UIC") && (name.ends_with("60") || name.ends_with("54"));
    const auto like =
        uic ? std::vector{fmt::format("{}E1 (its name in EN 13674-1)", name.substr(name.size() - 2))}
            : nearest_names(name, standard_profile_names());
    throw InputError(fmt::format("unknown profile '{}'", name),
                     fmt::format("it is none of the standards {} and there is no file {}",
                                 fmt::join(standard_profile_names(), ", "), file.string()),
                     like.empty() ? "Check the name or the path."
                                  : fmt::format("Did you mean {}?", fmt::join(like, " or ")));
  }
  return file.extension() == ".toml" ? profile_of_body(file, kind) : read_profile(file, kind);
}

} // namespace bem_contact
