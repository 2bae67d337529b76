#pragma once

#include "fem_influence/shared/sparse_columns.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace bem_contact::fem {

/// Lists of members (nodes, or unknowns of a matrix), from 0, each at most once in a list: those of element e
/// are member[begin[e]] .. member[begin[e + 1] - 1].
struct Elements {
  std::vector<std::size_t> begin{0};
  std::vector<int> member;

  std::size_t count() const { return begin.size() - 1; }
  std::span<const int> operator[](std::size_t e) const {
    return std::span(member).subspan(begin[e], begin[e + 1] - begin[e]);
  }
  void add(std::span<const int> members) {
    member.insert(member.end(), members.begin(), members.end());
    begin.push_back(member.size());
  }
};

/// Place of each of so many nodes in the elimination, from 0, by METIS's nested dissection where the nodes of
/// an element are neighbours of each other; nodes of no element come last. Deterministic.
std::vector<int> nested_dissection(std::size_t nodes, const Elements& elements);

/// Appends elements that hold the entries of `border`; the unknown of column c is `size` + c. Two unknowns
/// share a new element only if they shared one before. Returns the new elements' values, each a lower
/// triangle column by column.
std::vector<double> add_border(Elements& elements, int size, const SparseColumns& border);

} // namespace bem_contact::fem
