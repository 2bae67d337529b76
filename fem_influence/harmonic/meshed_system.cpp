#include "fem_influence/harmonic/meshed_system.hpp"

#include "bem_contact/base/stopwatch.hpp"
#include "fem_influence/shared/body_description.hpp"

namespace bem_contact::fem {

MeshedSystem::MeshedSystem(const BodyFile& body, const ProfileCurve& curve, const std::filesystem::path& mesh,
                           std::span<const std::size_t> stations, Timing& timing)
    : reference_radius(reference_radius_of(body)) {
  const TimedScope timer(timing.assembly);
  section = std::make_unique<Section>(mesh, body.harmonic.degree, curve, body.strip,
                                      Refinement{.borders = body.harmonic.border_levels});
  system = lay_out_system(*section, body, curve, stations);
}

AssembledSystem add_matrices(MeshedSystem meshed, Timing& timing, std::span<SectionOperator::Block> memory) {
  {
    const TimedScope timer(timing.assembly);
    fill(meshed.system.op, *meshed.section, meshed.reference_radius, memory);
    meshed.section.reset();
  }
  const TimedScope timer(timing.analysis);
  std::vector<int> order = elimination_order(meshed.system);
  return {std::move(meshed.system), std::move(order)};
}

} // namespace bem_contact::fem
