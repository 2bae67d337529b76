#include "fem_influence/shared/body_description.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/sha256.hpp"
#include "bem_contact/profile/standard_profiles.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>

namespace bem_contact::fem {

std::vector<Station> make_stations(const BodyFile::Strip& strip, const ProfileCurve& curve) {
  require_strip_on_profile(strip, curve);
  std::vector<Station> stations;
  for (int i = 0; i < strip.stations(); ++i) {
    const CurvePoint point = curve.at(strip.from + (i + 0.5) * strip.station_width);
    stations.push_back({point.s, point.position, point.delta});
  }
  return stations;
}

InfluenceFunction describe(const BodyFile& body, const ProfileCurve& curve) {
  InfluenceFunction f;
  f.body = body_name(body);
  f.profile = curve.name();
  f.profile_digest = curve.digest();
  f.material = body.material;
  f.reference_radius = reference_radius_of(body);
  f.invariance = f.reference_radius != 0 ? Invariance::revolution : Invariance::prismatic;
  f.half_period = half_period_of(body);
  f.station_width = body.strip.station_width;
  f.stations = make_stations(body.strip, curve);
  return f;
}

namespace {

/// Its meshes have no geometry: no point, where a mesh that gmsh made of a geometry has some. And they have
/// the format that gmsh writes today.
bool is_of_mesh_body(std::istream& mesh) {
  mesh.clear();
  mesh.seekg(0);
  std::string word, version;
  int geometric_points = -1;
  if (!(mesh >> word >> version) || version != "4.1")
    return false;
  while (mesh >> word && word != "$Nodes")
    if (word == "$Entities")
      mesh >> geometric_points;
  return geometric_points == 0;
}

/// SHA-256 of the first bytes of a mesh, which its end states.
std::string sha256_of_first(std::istream& mesh, std::streamoff bytes) {
  std::string text(static_cast<std::size_t>(bytes), '\0');
  mesh.clear();
  mesh.seekg(0);
  mesh.read(text.data(), bytes);
  return mesh ? sha256(text) : std::string();
}

} // namespace

void require_mesh_of(const BodyFile& body, const ProfileCurve& curve, const std::filesystem::path& mesh) {
  if (file_exists(mesh) && !is_regular(mesh))
    throw InputError("The mesh file '" + mesh.string() + "' cannot be read",
                     "it is no regular file, and it is read more than once", "Name a file.");
  std::ifstream in(mesh, std::ios::binary | std::ios::ate);
  const auto size = static_cast<std::streamoff>(in.tellg());
  constexpr std::streamoff tail = 200; // bytes; mesh_body's mark is the last thing in the file
  in.seekg(std::max<std::streamoff>(0, size - tail));
  const std::string text{std::istreambuf_iterator<char>(in), {}}, mark = "$Comments\nbody file ";
  const auto at = text.find(mark);
  if (at == std::string::npos && is_of_mesh_body(in))
    throw InputError("The mesh '" + mesh.string() + "' is not whole",
                     "it does not end with the body file that mesh_body made it from: it was cut off",
                     "Make it anew: mesh_body BODY.toml -o " + mesh.string());
  const std::string digest_mark = " sha256 ";
  if (at != std::string::npos && text.compare(at + mark.size() + 16, digest_mark.size(), digest_mark) == 0 &&
      text.substr(at + mark.size() + 16 + digest_mark.size(), sha256_size) !=
          sha256_of_first(in, std::max<std::streamoff>(0, size - tail) + static_cast<std::streamoff>(at)))
    throw InputError("The mesh '" + mesh.string() + "' was changed since mesh_body made it",
                     "its SHA-256 is another one: a node or an edge may be elsewhere",
                     "Make it anew: mesh_body BODY.toml -o " + mesh.string());
  if (at != std::string::npos && text.substr(at + mark.size(), 16) != mesh_digest(body, curve.digest()))
    throw InputError("The mesh '" + mesh.string() + "' was made from another body file",
                     "its digest of [body], [strip] and [mesh] is another one",
                     "Make it anew: mesh_body BODY.toml -o " + mesh.string());
}

} // namespace bem_contact::fem
