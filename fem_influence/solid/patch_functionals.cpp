#include "fem_influence/solid/patch_functionals.hpp"

#include "bem_contact/base/error.hpp"
#include "fem_influence/shared/settings.hpp"

#include <cmath>
#include <fmt/format.h>
#include <string>
#include <vector>

namespace bem_contact::fem {

namespace {

std::string place(const SurfacePatch& p) {
  return fmt::format("s = {:g} .. {:g}, x = {:g} .. {:g} mm", p.s_from, p.s_to, p.x_from, p.x_to);
}

} // namespace

SparseColumns patch_functionals(const SolidBody& body, const ContactSurface& surface,
                                std::span<const SurfacePatch> patches) {
  ColumnSums columns(3 * patches.size());
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
                columns.add(3 * p + j, 3 * node + int(c), at.weight * weight * value[a] * frame[j][c]);
        }
      });
  });
  for (std::size_t p = 0; p < patches.size(); ++p)
    if (std::abs(covered[p] - patches[p].area()) > settings::uncovered * patches[p].area())
      throw InputError("The mesh's group 'contact' does not cover the strip",
                       fmt::format("of the element at {} it has {:g} of {:g} mm^2", place(patches[p]),
                                   covered[p], patches[p].area()),
                       "Widen the group, or change [strip] or solid.offsets.");
  return columns.sparse();
}

} // namespace bem_contact::fem
