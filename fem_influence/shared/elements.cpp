#include "fem_influence/shared/elements.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/influence/lower_triangle.hpp"

#include <metis.h>

#include <algorithm>
#include <map>
#include <memory>

namespace bem_contact::fem {

std::vector<int> nested_dissection(std::size_t nodes, const Elements& elements) {
  std::vector<int> vertex(nodes, -1), place(nodes); // of METIS's graph; of a node
  for (const int node : elements.member)
    vertex[static_cast<std::size_t>(node)] = 0;
  int count = 0;
  for (int& v : vertex)
    if (v == 0)
      v = count++;
  idx_t cells = static_cast<idx_t>(elements.count()), vertices = count, from_zero = 0;
  std::vector<idx_t> begin(elements.begin.begin(), elements.begin.end()), member;
  for (const int node : elements.member)
    member.push_back(vertex[static_cast<std::size_t>(node)]);
  const auto free_metis = [](idx_t* array) { METIS_Free(array); };
  using Array = std::unique_ptr<idx_t, decltype(free_metis)>;
  idx_t *first = nullptr, *neighbour = nullptr;
  bool fine = METIS_MeshToNodal(&cells, &vertices, begin.data(), member.data(), &from_zero, &first,
                                &neighbour) == METIS_OK;
  const Array owned_first(first, free_metis), owned_neighbour(neighbour, free_metis);
  std::vector<idx_t> order(static_cast<std::size_t>(count)), of_vertex(order);
  fine = fine && METIS_NodeND(&vertices, first, neighbour, nullptr, nullptr, order.data(),
                              of_vertex.data()) == METIS_OK;
  if (!fine)
    throw Error("The unknowns could not be ordered", "METIS refused the mesh's graph",
                "Report this as a bug.");
  for (std::size_t a = 0; a < nodes; ++a)
    place[a] = vertex[a] < 0 ? count++ : static_cast<int>(of_vertex[static_cast<std::size_t>(vertex[a])]);
  return place;
}

std::vector<double> add_border(Elements& elements, int size, const SparseColumns& border) {
  std::vector<std::size_t> home(static_cast<std::size_t>(size), elements.count()); // an element of each row
  for (std::size_t e = elements.count(); e-- > 0;)
    for (const int row : elements[e])
      home[static_cast<std::size_t>(row)] = e;
  struct Entry {
    int row, column;
    double value;
  };
  std::map<std::size_t, std::vector<Entry>> of_home;
  for (std::size_t c = 0; c < border.columns(); ++c)
    border.for_each_entry(c, [&](int row, double value) {
      of_home[home[static_cast<std::size_t>(row)]].push_back({row, size + static_cast<int>(c), value});
    });
  std::vector<double> values;
  for (const auto& [e, entries] : of_home) {
    std::vector<int> members;
    for (const Entry& entry : entries)
      members.insert(members.end(), {entry.row, entry.column});
    std::sort(members.begin(), members.end());
    members.erase(std::unique(members.begin(), members.end()), members.end());
    const auto at = [&](int member) {
      return static_cast<std::size_t>(std::lower_bound(members.begin(), members.end(), member) -
                                      members.begin());
    };
    const std::size_t first = values.size(), m = members.size();
    values.resize(first + lower_size(m), 0.0);
    for (const auto& [row, column, value] : entries) // the column's unknown is the larger of the two
      values[first + at(row) * m - at(row) * (at(row) + 1) / 2 + at(column)] += value;
    elements.add(members);
  }
  return values;
}

} // namespace bem_contact::fem
