#include "bem_contact/profile/profile_reading.hpp"

namespace bem_contact {

void add_profile_reading(Schema& s, const std::string& table, ProfileReading& reading,
                         const std::vector<std::string>& kinds) {
  SchemaTable t(s, table, kinds);
  t.add("smoothing", reading.smoothing, "Of a profile file: shortest wavelength kept; 0: no smoothing",
        {.unit = "mm", .at_least = 0, .at_most = 50});
  t.add("nominal", reading.nominal,
        "Of a profile file: the standard profile from which it was made (S1002, 60E1); only the depth worn "
        "off it is smoothed, by smoothing or, if that is 0, as the points tell");
  t.add("unit", reading.unit, "Of a profile file: its unit; found: by the width, mm or m");
  t.add("profile_z", reading.profile_z,
        "Of a profile file: where z points; as stated: as the format says, else found by the shape");
  t.add("mirror", reading.mirror,
        "Of a profile file: its y points the other way (a Vampire file: its left profile)");
}

void add_flange_back(Schema& s, const std::string& table, ProfileReading& reading,
                     const std::vector<std::string>& kinds) {
  SchemaTable t(s, table, kinds);
  t.add("flange_back", reading.flange_back,
        "Of a wheel's profile file: y of the back of the flange in the file; not given: y = 0 is at the "
        "tape circle, or it is found by the shape",
        {.unit = "mm"});
}

void add_tape_circle(Schema& s, const std::string& table, double& tape_circle,
                     const std::vector<std::string>& kinds) {
  SchemaTable t(s, table, kinds);
  t.add("tape_circle", tape_circle, "Distance of the wheel's tape circle from the back of its flange",
        {.unit = "mm", .above = 0});
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
