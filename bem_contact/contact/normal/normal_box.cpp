#include "bem_contact/contact/normal/normal_box.hpp"

#include <algorithm>

namespace bem_contact::contact {

NormalBox::NormalBox(const InfluenceNumbers& numbers, const Boxes& the_boxes, TransformPool* pool)
    : boxes(the_boxes), nn(numbers, boxes, {component_n}, {component_n}, pool), fast(nn, pool),
      inverse(numbers, boxes.mx(), boxes.ms(), {component_n}, {component_n},
              BasicPlaneOperator<float>::Form::periodic, boxes.boxes.front().first_s + boxes.ms() / 2, pool) {
  inverse.invert();
}

void NormalBox::invert(std::span<const float> in, std::span<float> out) const {
  const std::size_t n = boxes.boxes.front().size();
  for (int k = 0; k < boxes.count(); ++k)
    inverse.apply(in.subspan(k * n, n), out.subspan(k * n, n), 0);
}

void NormalBox::copy_to_grid(std::span<const double> from, int grid_mx, Eigen::VectorXd& field) const {
  const double* row = from.data();
  for (const Box& box : boxes.boxes)
    for (int is = 0; is < box.ms; ++is, row += box.mx)
      std::copy_n(row, box.mx, &field[static_cast<Eigen::Index>(box.first_s + is) * grid_mx + box.first_x]);
}

void NormalBoxVectors::resize(int size) {
  for (auto* v : {&p, &u})
    v->resize(size);
  for (auto* v : {&x, &r, &z, &d, &q})
    v->resize(size);
}

} // namespace bem_contact::contact
