#include "fem_influence/shared/read_msh.hpp"

#include "bem_contact/base/error.hpp"

#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/tria.h>

#include <fstream>
#include <sstream>

namespace bem_contact::fem {

namespace {

/// What the messages say of meshes in two and in three dimensions.
struct Wording {
  const char *program, *mesh, *remedy, *cells, *why_not, *recombine;
};
constexpr Wording of_sections = {"mesh_body",
                                 "quadrilaterals in the plane",
                                 "Make it with mesh_body, and give --solid with a 3-D mesh.",
                                 "quadrilaterals",
                                 "the elements are tensor products",
                                 "Recombine all triangles, or use mesh_body."};
constexpr Wording of_solids = {
    "mesh_body --solid",
    "hexahedra",
    "Make it with mesh_body --solid, or of first-order hexahedra alone.",
    "hexahedra",
    "the elements are tensor products: tetrahedra, wedges and pyramids are not served",
    "Recombine all cells, or use mesh_body --solid."};

} // namespace

std::string short_reason(const std::exception& error) {
  std::string why = error.what();
  if (const auto at = why.find("Additional information:"); at != std::string::npos)
    why = why.substr(at + 23);
  why = why.substr(0, why.find("\nStacktrace"));
  std::istringstream words(why);
  std::string line;
  for (std::string word; words >> word && line.size() < 300;)
    if (word.find_first_not_of('-') != std::string::npos)
      line += (line.empty() ? "" : " ") + word;
  return line;
}

template <int dim> void read_msh(dealii::Triangulation<dim, dim>& mesh, const std::filesystem::path& path) {
  const Wording& words = dim == 2 ? of_sections : of_solids;
  const std::string file = path.string();
  std::ifstream in(path);
  if (!in || std::filesystem::is_directory(path))
    throw InputError("The mesh file '" + file + "' cannot be read", "no readable file has that name",
                     std::string("Make it with ") + words.program + ", or correct the path.");
  try {
    dealii::GridIn<dim> reader(mesh);
    reader.read_msh(in);
  } catch (const std::exception& error) {
    throw InputError("The mesh '" + file + "' is not a gmsh mesh of " + words.mesh,
                     "deal.II refuses it: " + short_reason(error), words.remedy);
  }
  if (mesh.n_active_cells() == 0 || !mesh.all_reference_cells_are_hyper_cube())
    throw InputError("The mesh '" + file + "' has cells that are not " + words.cells, words.why_not,
                     words.recombine);
}

template void read_msh<2>(dealii::Triangulation<2, 2>&, const std::filesystem::path&);
template void read_msh<3>(dealii::Triangulation<3, 3>&, const std::filesystem::path&);

} // namespace bem_contact::fem
