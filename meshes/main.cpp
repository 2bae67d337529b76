#include "bem_contact/base/argument_error.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/message_file.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/base/printable.hpp"
#include "bem_contact/base/program.hpp"
#include "bem_contact/base/provenance.hpp"
#include "bem_contact/base/said_by.hpp"
#include "bem_contact/profile/bodies/body_file.hpp"
#include "bem_contact/profile/message_sink.hpp"
#include "bem_contact/profile/standard_profiles.hpp"
#include "meshes/heartbeat.hpp"
#include "meshes/section_mesh.hpp"
#include "meshes/settings.hpp"
#include "meshes/solid_mesh.hpp"
#include "meshes/write_msh.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <exception>
#include <iostream>
#include <optional>
#include <string>

namespace {

using namespace bem_contact;

/// s. How often a mesh that takes longer says that it is still made. Chosen: a usual mesh takes one to five.
constexpr double sign_of_life = 10.0;

constexpr const char* description =
    "Meshes the cross-section of a body in quadrilaterals. The body is described by a body file: a rail,\n"
    "wheel, block, disc, bore, or an outline of your own. Elements are small on the contact strip and grow\n"
    "away from it. The mesh is what fem_influence computes influence functions on.";

constexpr const char* example =
    "Example:\n"
    "  mesh_body data/bodies/rail_60E1_gauge_corner.toml -o rail.msh --quality\n"
    "You should see the number of quadrilaterals, their total area next to that of the section (equal to\n"
    "some 0.01 %), and the smallest scaled Jacobian: 1 is a rectangle, and below 0.2 you get a warning.\n"
    "Then open rail.msh in gmsh. Its x and y are y (to the right) and z (down) of the section, in mm.\n"
    "\n"
    "A body file of your own:\n"
    "  mesh_body --print-default > body.toml\n"
    "writes every key with its default, unit and meaning. Delete the keys that you leave as they are.\n"
    "\n"
    "Physical groups of the mesh: curves contact = 1, held = 2, free = 3; surface body = 10.\n"
    "With --solid: half of the 3-D body (x >= 0) in coarse hexahedra, which fem_influence --solid refines\n"
    "towards the load; surfaces contact = 1, held = 2, free = 3, symmetry = 4; volume body = 10.";

void print_quality(std::FILE* words, const meshes::QuadMesh& mesh, const meshes::Quality& quality) {
  fmt::print(words, "quadrilaterals           {}\n", quality.quads);
  fmt::print(words, "vertices                 {}\n", mesh.points.size());
  fmt::print(words, "area                     {:.3f} mm^2 (section {:.3f})\n", quality.area,
             mesh.section_area);
  fmt::print(words, "edges, shortest/longest  {:.4f} / {:.4f} mm\n", quality.shortest_edge,
             quality.longest_edge);
  fmt::print(words, "scaled Jacobian, mean    {:.3f}\n", quality.mean);
  fmt::print(words, "scaled Jacobian, least   {:.3f} at y = {:.3f}, z = {:.3f} mm\n", quality.smallest,
             quality.worst.y, quality.worst.z);
}

int run(const std::string& body_file, const std::string& output, bool solid, bool report) {
  const BodyFile body = read_body_file(body_file);
  require_outputs({body_file, profile_file_of(body)}, {{"--output", output}});
  meshes::require_replaceable_mesh(output);
  for (const std::string& warning : body_warnings(body))
    print_error("warning: {}\n", warning);
  std::optional<meshes::SolidMesh> whole;
  const meshes::QuadMesh mesh = [&] {
    const meshes::Heartbeat heartbeat("meshing " + body.body.name,
                                      std::chrono::milliseconds(static_cast<long>(1000 * sign_of_life)),
                                      std::cerr);
    if (!solid)
      return meshes::mesh_section(body);
    whole = meshes::mesh_solid(body);
    return whole->section;
  }();
  solid ? meshes::write_msh(*whole, output) : meshes::write_msh(mesh, output);
  const meshes::Quality quality = meshes::quality(mesh);
  if (quality.smallest < meshes::poor_quality)
    print_error("warning: the smallest scaled Jacobian is {:.3f} (below {} near y = {:.3f}, z = {:.3f} mm) "
                "Lower [mesh] grading or move the strip's ends.\n",
                quality.smallest, meshes::poor_quality, quality.worst.y, quality.worst.z);
  if (!mesh.note.empty())
    print_error("{}\n", mesh.note);
  // Standard output is the mesh's if it goes there.
  std::FILE* words = output_target(output, OutputForm::text).stream ? stderr : stdout;
  if (solid)
    fmt::print(words, "{}: {} hexahedra in {} layers, smallest scaled Jacobian {:.2f}, written to {}\n",
               mesh.name, whole->hexahedra.size(), whole->layers.size() - 1, quality.smallest, output);
  else
    fmt::print(words, "{}: {} quadrilaterals, smallest scaled Jacobian {:.2f}, written to {}\n", mesh.name,
               quality.quads, quality.smallest, output);
  if (report)
    print_quality(words, mesh, quality);
  return 0;
}

int run_program(int argc, char** argv) {
  CLI::App app(description, "mesh_body");
  app.footer(example);
  app.set_version_flag("--version", provenance("mesh_body"));
  std::string body_file, output;
  bool report = false, solid = false, print_default = false;
  app.add_option("BODY.toml", body_file, "body file");
  add_output_option(app, "-o,--output", output, "mesh to write, e.g. rail.msh");
  app.add_flag("--solid", solid, "mesh the 3-D body in hexahedra ([solid] of the body file)");
  app.add_flag("--quality", report, "print sizes, areas and the quality of the mesh");
  app.add_flag("--print-default", print_default, "print all keys of a body file with defaults and units");
  try {
    app.parse(argc, argv);
    if (print_default) {
      print_out("{}", default_body_file());
      return 0;
    }
    if (body_file.empty() || output.empty())
      throw InputError("Nothing to mesh", "a body file and -o OUT.msh are needed", "See mesh_body --help.");
    return run(body_file, output, solid, report);
  } catch (const CLI::ParseError& error) {
    return exit_code_of(app, error);
  } catch (const InputError& error) {
    say_error(error.what());
    return 2;
  } catch (const std::exception& error) {
    say_error(said_by(error));
    return 1;
  }
}

} // namespace

int main(int argc, char** argv) {
  begin_program(argv);
  const auto messages = install_message_sink(); // the profile is read more than once
  return checked_exit_code(run_program(argc, argv));
}
