#include "bem_contact/profile/read_profile.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/schema.hpp"
#include "bem_contact/profile/profile_formats.hpp"
#include "bem_contact/profile/standard_profiles.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace bem_contact {

ProfileCurve parse_profile(std::string_view text, std::string_view source_name, ProfileKind kind) {
  const std::string source(source_name);
  if (text.starts_with("\xef\xbb\xbf")) // a byte order mark
    text.remove_prefix(3);
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
      throw InputError(
          fmt::format("{} is the profile of a {}", name, kind == ProfileKind::rail ? "wheel" : "rail"),
          fmt::format("a {} is asked for", kind == ProfileKind::rail ? "rail" : "wheel"),
          kind == ProfileKind::rail ? "Use for instance 60E1." : "Use for instance S1002.");
    return standard_profile(name);
  }
  const std::filesystem::path file = folder / std::filesystem::path(name); // an absolute path stays itself
  if (!std::filesystem::exists(file)) {
    const auto like = nearest_names(name, standard_profile_names());
    throw InputError(fmt::format("unknown profile '{}'", name),
                     fmt::format("it is none of the standards {} and there is no file {}",
                                 fmt::join(standard_profile_names(), ", "), file.string()),
                     like.empty() ? "Check the name or the path."
                                  : fmt::format("Did you mean {}?", fmt::join(like, " or ")));
  }
  return read_profile(file, kind);
}

} // namespace bem_contact
