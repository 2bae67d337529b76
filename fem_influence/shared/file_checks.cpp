#include "fem_influence/shared/file_checks.hpp"

#include "bem_contact/base/error.hpp"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>

namespace bem_contact::fem {

void require_writable(const std::filesystem::path& output) {
  const auto folder = output.has_parent_path() ? output.parent_path() : std::filesystem::path(".");
  if (!std::filesystem::is_directory(folder) || ::access(folder.c_str(), W_OK) != 0)
    throw InputError("The file '" + output.string() + "' cannot be written",
                     "'" + folder.string() + "' is not a folder that can be written to",
                     "make the folder, or choose another file");
  if (std::filesystem::is_directory(output))
    throw InputError("The file '" + output.string() + "' cannot be written", "a folder has that name",
                     "choose another file");
}

void require_mesh_of(const BodyFile& body, const ProfileCurve& curve, const std::filesystem::path& mesh) {
  std::ifstream in(mesh, std::ios::binary | std::ios::ate);
  const auto size = static_cast<std::streamoff>(in.tellg());
  constexpr std::streamoff tail = 200; // bytes; mesh_body's mark is the last thing in the file
  in.seekg(std::max<std::streamoff>(0, size - tail));
  const std::string text{std::istreambuf_iterator<char>(in), {}}, mark = "$Comments\nbody file ";
  const auto at = text.find(mark);
  if (at != std::string::npos && text.substr(at + mark.size(), 16) != mesh_digest(body, curve.digest()))
    throw InputError("The mesh '" + mesh.string() + "' was made from another body file",
                     "its digest of [body], [strip] and [mesh] is another one",
                     "make it anew: mesh_body BODY.toml -o " + mesh.string());
}

} // namespace bem_contact::fem
