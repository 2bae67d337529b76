#include "bem_contact/report/mesh_file.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"

#include <fmt/format.h>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace bem_contact::report {

namespace {

constexpr int line_of_two = 1, quadrilateral = 3; // types of gmsh's elements

/// The sections of a mesh, read in their order.
class MeshReader {
public:
  explicit MeshReader(const std::string& text) : in_(text) {
    in_.exceptions(std::ios::failbit | std::ios::badbit);
  }

  record::Record read() {
    for (std::string name; in_.peek() != EOF && in_ >> name && name != "$Comments";) {
      if (name == "$PhysicalNames")
        read_names();
      else if (name == "$Entities")
        read_entities();
      else if (name == "$Nodes")
        read_nodes();
      else if (name == "$Elements") {
        read_elements();
        break; // the rest says which edges are curved
      }
    }
    if (points_.empty() || quads_.empty())
      in_.setstate(std::ios::failbit);
    record::Record edges;
    for (auto& [name, ends] : edges_)
      edges.add(name, record::field(std::move(ends), "1", "points of each edge", {ends.size() / 2, 2}));
    const std::size_t points = points_.size() / 2, quads = quads_.size() / 4;
    return {{"points", record::field(std::move(points_), "mm", "y, z", {points, 2})},
            {"quads", record::field(std::move(quads_), "1", "points of each quadrilateral", {quads, 4})},
            {"edges", std::move(edges)}};
  }

private:
  template <class T = std::size_t> T take() {
    T value{};
    in_ >> value;
    return value;
  }
  void skip(std::size_t count) {
    for (std::size_t k = 0; k < count; ++k)
      take<std::string>();
  }

  void read_names() {
    for (auto count = take(); count > 0; --count) {
      const auto dimension = take(), tag = take();
      const auto name = take<std::string>();
      if (dimension == 1 && name.size() > 2)
        names_[tag] = name.substr(1, name.size() - 2); // without its quotes
    }
  }

  void read_entities() {
    const auto points = take(), curves = take();
    skip(2);
    for (std::size_t k = 0; k < points; ++k) {
      skip(4);
      skip(take());
    }
    for (std::size_t k = 0; k < curves; ++k) {
      const auto tag = take();
      skip(6); // its box
      for (auto groups = take(); groups > 0; --groups)
        group_of_[tag] = take();
      skip(take()); // its ends
    }
  }

  void read_nodes() {
    auto blocks = take();
    skip(3);
    for (; blocks > 0; --blocks) {
      skip(3);
      std::vector<std::size_t> tags(take());
      for (std::size_t& tag : tags)
        tag = take();
      for (const std::size_t tag : tags) {
        place_[tag] = points_.size() / 2;
        points_.push_back(take<double>());
        points_.push_back(take<double>());
        skip(1);
      }
    }
  }

  void read_elements() {
    auto blocks = take();
    skip(3);
    for (; blocks > 0; --blocks) {
      skip(1);
      const auto entity = take();
      const auto type = take<int>();
      const bool is_line = type == line_of_two;
      if (!is_line && type != quadrilateral)
        in_.setstate(std::ios::failbit); // a solid mesh
      std::vector<double>& out = is_line ? edges_[names_[group_of_[entity]]] : quads_;
      for (auto count = take(); count > 0; --count) {
        skip(1);
        for (int k = 0; k < (is_line ? 2 : 4); ++k)
          out.push_back(static_cast<double>(place_.at(take())));
      }
    }
  }

  std::istringstream in_;
  std::map<std::size_t, std::string> names_;
  std::map<std::size_t, std::size_t> group_of_, place_;
  std::vector<double> points_, quads_;
  std::map<std::string, std::vector<double>> edges_;
};

} // namespace

record::Record mesh_data(const std::filesystem::path& file) {
  try {
    return MeshReader(read_text_file(file.string(), "mesh")).read();
  } catch (const std::ios_base::failure&) {
  } catch (const std::out_of_range&) {
  }
  throw InputError(fmt::format("'{}' cannot be shown as a page", file.string()),
                   "it is no whole mesh of a section, as mesh_body writes it",
                   "Make it again, or open a solid mesh in gmsh.");
}

} // namespace bem_contact::report
