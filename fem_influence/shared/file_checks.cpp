#include "fem_influence/shared/file_checks.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>

namespace bem_contact::fem {

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
  if (at != std::string::npos && text.substr(at + mark.size(), 16) != mesh_digest(body, curve.digest()))
    throw InputError("The mesh '" + mesh.string() + "' was made from another body file",
                     "its digest of [body], [strip] and [mesh] is another one",
                     "Make it anew: mesh_body BODY.toml -o " + mesh.string());
}

} // namespace bem_contact::fem
