#include "fem_influence/solid/patch_functionals.hpp"

#include "bem_contact/base/error.hpp"
#include "fem_influence/shared/settings.hpp"

#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace bem_contact::fem {

namespace {

std::string place(const SurfacePatch& p) {
  return "s = " + std::to_string(p.s_from) + " .. " + std::to_string(p.s_to) +
         ", x = " + std::to_string(p.x_from) + " .. " + std::to_string(p.x_to) + " mm";
}

} // namespace

SparseColumns patch_functionals(const SolidBody& body, const ContactSurface& surface,
                                std::span<const SurfacePatch> patches) {
  std::vector<std::map<int, Vector3>> of_node(3 * patches.size()); // [column][node]
  std::vector<double> covered(patches.size(), 0.0), value;
  body.for_each_contact_face([&](const SolidFaceView& face) {
    value.resize(face.nodes.size());
    for (std::size_t p = 0; p < patches.size(); ++p)
      for_each_common_point(face.corner, patches[p], [&](const FacePoint& at) {
        covered[p] += at.weight;
        const auto frame = surface.frame(at.place);
        face.shapes(at.xi, at.eta, value);
        for (std::size_t a = 0; a < value.size(); ++a) {
          if (std::abs(value[a]) < settings::vanishing_shape)
            continue;
          for (const auto [node, weight] : body.masters(face.nodes[a]))
            for (std::size_t j = 0; j < 3; ++j)
              for (std::size_t c = 0; c < 3; ++c)
                of_node[3 * p + j][node][c] += at.weight * weight * value[a] * frame[j][c];
        }
      });
  });
  for (std::size_t p = 0; p < patches.size(); ++p)
    if (std::abs(covered[p] - patches[p].area()) > settings::uncovered * patches[p].area())
      throw InputError("The mesh's group 'contact' does not cover the strip",
                       "of the element at " + place(patches[p]) + " it has " + std::to_string(covered[p]) +
                           " of " + std::to_string(patches[p].area()) + " mm^2",
                       "Widen the group, or change [strip] or solid.offsets.");
  SparseColumns columns;
  for (const auto& column : of_node) {
    for (const auto& [node, vector] : column)
      for (std::size_t c = 0; c < 3; ++c)
        if (vector[c] != 0)
          columns.add(3 * node + static_cast<int>(c), vector[c]);
    columns.end_column();
  }
  return columns;
}

} // namespace bem_contact::fem
