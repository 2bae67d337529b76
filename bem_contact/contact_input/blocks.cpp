#include "bem_contact/contact_input/blocks.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace bem_contact::contact_input {

std::string_view name_of(Data data) {
  static constexpr std::string_view names[] = {
      "parameters of the solver",
      "load and creepages",
      "law of friction",
      "rolling direction, step and speed",
      "inclinations of the surface",
      "file of influence coefficients",
      "material",
      "compressible sheet",
      "viscoelastic material",
      "simplified theory",
      "third body layer",
      "damping",
      "thermal properties",
      "share of plastic work",
      "potential contact",
      "undeformed distance",
      "extra rigid slip",
      "points below the surface",
      "size of the elements",
      "track",
      "profile of the rail",
      "deviation of the rail",
      "springs of the rail",
      "dimensions of the wheelset",
      "profile of the wheel",
      "position of the wheelset",
      "velocity of the wheelset",
      "deviation of the wheel",
  };
  return names[static_cast<std::size_t>(data)];
}

Block::Block(std::string_view format, const Item& item)
    : line(item.line), text(item.texts.empty() ? "" : item.texts[0]) {
  add(format, item);
}

void Block::add(std::string_view format, const Item& item) {
  std::size_t k = 0;
  for (const Field& field : fields_of(format))
    if (field.type != 's' && k < item.numbers.size())
      numbers_.emplace_back(field.name, item.numbers[k++]);
}

bool Block::has(std::string_view name) const {
  return std::ranges::any_of(numbers_, [&](const auto& n) { return n.first == name; });
}

double Block::number(std::string_view name, double otherwise) const {
  const auto found = std::ranges::find_if(numbers_, [&](const auto& n) { return n.first == name; });
  return found == numbers_.end() ? otherwise : found->second;
}

double Block::operator[](std::string_view name) const {
  if (!has(name))
    throw std::out_of_range("no number is named " + std::string(name));
  return number(name, 0);
}

const Block& CaseState::operator[](Data data) const {
  if (!has(data))
    throw std::out_of_range("there is no " + std::string(name_of(data)));
  return *blocks_.at(index(data));
}

} // namespace bem_contact::contact_input
