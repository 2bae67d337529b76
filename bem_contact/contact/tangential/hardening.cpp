#include "bem_contact/contact/tangential/hardening.hpp"

namespace bem_contact::contact {

using Eigen::VectorXd;

Linearisation linearise_hardening(const ContactElements& elements, int columns, const VectorXd& p,
                                  const VectorXd& slip) {
  const int count = elements.unknowns() / 2;
  TangentialTask task{VectorXd::Zero(elements.grid_size), {}, {}, {}, 0, elements.layer, elements.limits};
  std::vector<int> place(elements.grid_size, -1);
  for (int a = 0; a < count; ++a) {
    task.bound[elements.contact[a]] = elements.bound[a];
    place[elements.contact[a]] = a;
  }
  const std::vector<LayerAnswer> answers = layer_answers(task, elements.scatter(p), elements.scatter(slip));
  VectorXd bound(count);
  for (int a = 0; a < count; ++a)
    bound[a] = answers[elements.contact[a]].bound;
  Linearisation out = linearise(elements.stiffness, bound, p, slip);
  out.carried.share = {static_cast<float>(elements.layer->share(1)),
                       static_cast<float>(elements.layer->share(2))};
  for (int a = 0; a < count; ++a) {
    const int i = elements.contact[a];
    const LayerAnswer& at = answers[i];
    const Eigen::Vector2d z = p.segment<2>(2 * a) + elements.stiffness[a] * slip.segment<2>(2 * a),
                          direction = z.stableNormalized();
    if (at.yields)
      out.projection[a] += at.rise * direction * direction.transpose();
    const auto ahead = [&](int k) { return i % columns + k < columns ? place[i + k] : -1; };
    out.carried.elements.push_back({direction.cast<float>(),
                                    static_cast<float>(at.rise),
                                    static_cast<float>(at.kept),
                                    at.yields,
                                    {ahead(1), ahead(2)}});
  }
  return out;
}

} // namespace bem_contact::contact
