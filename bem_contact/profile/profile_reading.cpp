#include "bem_contact/profile/profile_reading.hpp"

namespace bem_contact {

void add_profile_reading(Schema& s, const std::string& table, ProfileReading& reading,
                         const std::vector<std::string>& kinds) {
  s.add(table + ".smoothing", reading.smoothing,
        {.doc = "Of a profile file: shortest wavelength kept; 0: no smoothing",
         .unit = "mm",
         .at_least = 0,
         .at_most = 50,
         .kinds = kinds});
  s.add(table + ".nominal", reading.nominal,
        {.doc =
             "Of a profile file: the standard profile from which it was made (S1002, 60E1); only the depth "
             "worn off it is smoothed, by smoothing or, if that is 0, as the points tell",
         .kinds = kinds});
  s.add(table + ".unit", reading.unit,
        {.doc = "Of a profile file: its unit; found: by the width, mm or m", .kinds = kinds});
  s.add(table + ".profile_z", reading.profile_z,
        {.doc = "Of a profile file: where z points; as stated: as the format says, else found by the shape",
         .kinds = kinds});
  s.add(table + ".mirror", reading.mirror,
        {.doc = "Of a profile file: its y points the other way (a Vampire file: its left profile)",
         .kinds = kinds});
}

void add_flange_back(Schema& s, const std::string& table, ProfileReading& reading,
                     const std::vector<std::string>& kinds) {
  s.add(table + ".flange_back", reading.flange_back,
        {.doc =
             "Of a wheel's profile file: y of the back of the flange in the file; not given: y = 0 is at the "
             "tape circle, or it is found by the shape",
         .unit = "mm",
         .kinds = kinds});
}

std::vector<std::string> given_reading(const Schema& schema, const std::string& table) {
  std::vector<std::string> given;
  for (const char* key : {"smoothing", "nominal", "unit", "profile_z", "mirror"})
    if (const std::string path = table + "." + key; schema.changed(path))
      given.push_back(path);
  if (const std::string path = table + ".flange_back"; schema.has(path))
    given.push_back(path); // it has no default
  return given;
}

} // namespace bem_contact
