#pragma once

#include "bem_contact/contact_input/digits.hpp"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace bem_contact::contact_input {

/// The data of a case. Each is read by one item of the file, or by several that belong together.
enum class Data {
  solver,
  kinematics,
  friction,
  rolling,
  inclinations,
  influence_file,
  material,
  sheet,
  viscoelastic,
  simplified,
  layer,
  damping,
  heat,
  plastic_heat,
  potential,
  distance,
  slip,
  stresses,
  elements,
  track,
  rail_profile,
  rail_deviation,
  rail_springs,
  wheelset,
  wheel_profile,
  position,
  velocity,
  wheel_deviation
};

/// What people call it.
std::string_view name_of(Data data);

/// Numbers that were read together. They have CONTACT's own names.
class Block {
public:
  Block() = default;
  Block(std::string_view format, const Item& item);

  int line = 0;
  std::string text;           ///< a name of a file
  std::vector<double> values; ///< of blocks that are tables (friction, distance, slip, places): row by row
  std::size_t columns = 0;    ///< of `values`

  /// The number of that name. Throws std::out_of_range where the item has none.
  double operator[](std::string_view name) const;
  double number(std::string_view name, double otherwise) const; ///< `otherwise` where the item has none
  bool has(std::string_view name) const;
  std::size_t rows() const { return columns == 0 ? 0 : values.size() / columns; }
  double at(std::size_t row, std::size_t column) const { return values.at(row * columns + column); }
  /// More numbers beside those that are there.
  void add(std::string_view format, const Item& item);

private:
  std::vector<std::pair<std::string, double>> numbers_;
};

/// All that holds in one case: its digits, and the data that it read or kept from cases before.
class CaseState {
public:
  int module = 3;
  int element = 0, patch = 1; ///< result element and contact patch: each pair has data of its own
  int line = 0;               ///< where the case begins
  int number = 1;             ///< of all cases of the file, from 1
  bool first = true;          ///< of its result element
  Digits digits;
  Digits effective; ///< C, D, L, V as given last: 0 and 1 mean "as before"
  /// Module 3: load and material with which the potential contact was formed (D = 1, 2); D = 0 keeps it.
  std::shared_ptr<const Block> grid_load, grid_material;
  std::vector<std::string> remarks; ///< numbers that CONTACT would take for remarks, in sentences

  bool has(Data data) const { return blocks_.at(index(data)) != nullptr; }
  /// Throws std::out_of_range where there is none.
  const Block& operator[](Data data) const;
  void set(Data data, Block block) {
    blocks_.at(index(data)) = std::make_shared<const Block>(std::move(block));
  }
  std::shared_ptr<const Block> shared(Data data) const { return blocks_.at(index(data)); } ///< null: none
  void remove(Data data) { blocks_.at(index(data)) = nullptr; }

private:
  static std::size_t index(Data data) { return static_cast<std::size_t>(data); }
  std::vector<std::shared_ptr<const Block>> blocks_ =
      std::vector<std::shared_ptr<const Block>>(static_cast<std::size_t>(Data::wheel_deviation) + 1);
};

} // namespace bem_contact::contact_input
