#pragma once

#include "bem_contact/app/from_contact/contact_cases.hpp"
#include "bem_contact/contact_input/blocks.hpp"
#include "bem_contact/profile/read_profile.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace bem_contact::app::from_contact {

/// The innermost point of a rail between its top and the gauge height, in its file's frame after the
/// inclination, mm.
struct GaugePoint {
  double y = 0, top = 0; ///< top: z of the highest point
  bool on_face = true;   ///< the profile reaches down to the gauge height; else its end is taken
};

/// How a profile of CONTACT is read, as keys of [rail] or [wheel].
class ProfileKeys {
public:
  /// `folder`: where its name begins; `body`: "rail" or "wheel".
  ProfileKeys(const contact_input::Block& given, const std::filesystem::path& folder, std::string body);

  void add(ContactCase& out) const;
  /// Of a rail that is inclined by `cant` about its origin: where CONTACT measures the gauge, `height` below
  /// the top. Nothing, and a reason in `out`, where the file cannot be read.
  std::optional<GaugePoint> gauge_point(double cant, double height, ContactCase& out) const;
  /// Whether a scene keeps the origin of the file, too, where a rail is placed by its gauge.
  bool keeps_origin() const;
  /// Whether it is a file of sections along the track or round the wheel.
  bool is_of_sections() const;

private:
  bool is_simpack() const;
  bool mirror() const;
  void add_smoothing(ContactCase& out) const;
  std::optional<MeasuredProfile> read(ContactCase& out) const;

  const contact_input::Block& given_;
  std::filesystem::path file_;
  std::string body_;
};

} // namespace bem_contact::app::from_contact
