#include "bem_contact/base/error.hpp"
#include "bem_contact/influence/expand.hpp"
#include "bem_contact/influence/influence_file.hpp"
#include "fem_influence/harmonic/harmonic_run.hpp"
#include "fem_influence/harmonic/run_plan.hpp"
#include "section_meshes.hpp"
#include "tests/base/message.hpp"
#include "tests/halfspace/rectangle_oracle.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/resource.h>

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>

namespace bem_contact::fem::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// A small block with few wavenumbers: a second or so.
BodyFile flat_block() {
  BodyFile body;
  body.body.kind = BodyKind::block;
  body.body.size = 40;
  body.strip = {-2, 2, 0.5};
  body.harmonic = {.degree = 2,
                   .border_levels = 1,
                   .half_period = 120,
                   .shortest_dx = 0.5,
                   .samples_per_decade = 6,
                   .remote_distance = 20};
  return body;
}

constexpr const char* program_body = "[body]\nkind = \"block\"\nsize = 40.0\n"
                                     "[strip]\nfrom = -2.0\nto = 2.0\nstation_width = 0.5\n"
                                     "[harmonic]\ndegree = 2\nhalf_period = 120.0\nshortest_dx = 0.5\n"
                                     "samples_per_decade = 6\nremote_distance = 20.0\n"
                                     "[stress]\ndepths = 5\n";

std::string bytes(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class Run : public ::testing::Test {
protected:
  void SetUp() override { write_block_mesh(folder_ / "block.msh", 0.25, 2, 40); }
  std::string error_of(const std::string& mesh, const std::string& output = "out.h5",
                       const BodyFile& body = flat_block()) {
    return message_of([&] { run_harmonic(body, straight_line(40), folder_ / mesh, folder_ / output); });
  }
  Folder folder_;
};

TEST_F(Run, flat_block_gives_the_halfspace_numbers_and_knows_their_error) {
  // Self and differences to 10 patch sizes along x and s, all nine components.
  BodyFile body = flat_block();
  body.strip = {-3, 3, 0.5};
  body.body.size = 100;
  body.harmonic = {
      .degree = 3, .border_levels = 4, .half_period = 600, .shortest_dx = 0.5, .remote_distance = 50};
  write_block_mesh(folder_ / "large.msh", 0.5, 3, 100);
  const auto file = folder_ / "large.h5";
  const RunReport report = run_harmonic(body, straight_line(100), folder_ / "large.msh", file);
  EXPECT_LT(report.betti_error, 1e-10);
  EXPECT_LT(report.reaction_error, 1e-8);
  const InfluenceFunction function = read_influence_file(file);
  EXPECT_EQ(function.stations.size(), 12u);
  EXPECT_GT(report.smallest_eigenvalue, 0);
  const int offsets = 11, rows = 12;
  const auto numbers = expand(function, {.dx = 0.5, .offsets = offsets});
  const auto exact = halfspace::averaged(body.material, 0, 0, 0.25, 0.25);
  // What is left of the rigid motion is the same for all pairs: taken from the farthest one.
  std::array<double, 3> shift{};
  for (std::size_t i = 0; i < 3; ++i) {
    const int c = static_cast<int>(i);
    shift[i] = numbers.at(offsets - 1, rows - 1, c, 0, c) -
               halfspace::averaged(body.material, 0.5 * (offsets - 1), 0.5 * (rows - 1), 0.25, 0.25)[i][i];
    EXPECT_LT(std::abs(shift[i]), 0.02 * exact[i][i]);
  }
  double worst = 0;
  for (int m = 0; m < offsets; ++m)
    for (int I = 0; I < rows; ++I)
      for (int J = 0; J < rows; ++J) {
        const auto half = halfspace::averaged(body.material, 0.5 * m, 0.5 * (I - J), 0.25, 0.25);
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j) {
            const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
            const double error = numbers.at(m, I, i, J, j) - half[a][b] - (i == j ? shift[a] : 0.0);
            ASSERT_LT(std::abs(error), 5e-4 * std::sqrt(exact[a][a] * exact[b][b]))
                << "component " << i << j << ", offset " << m << ", rows " << I << ' ' << J;
            worst = std::max(worst, std::abs(error) / std::sqrt(exact[a][a] * exact[b][b]));
          }
      }
  EXPECT_LT(worst, function.estimated_error);
  EXPECT_LT(function.estimated_error, 5 * worst);
}

TEST_F(Run, a_body_twice_as_large_has_the_same_numbers_without_its_structural_motion) {
  std::vector<double> last;
  for (const double size : {100.0, 200.0}) {
    BodyFile body = flat_block();
    body.body.size = size;
    body.harmonic = {.degree = 2, .border_levels = 2, .half_period = 6 * size, .shortest_dx = 0.5};
    body.harmonic.remote_distance = 20;
    write_block_mesh(folder_ / "sized.msh", 0.5, 2, size);
    run_harmonic(body, straight_line(size), folder_ / "sized.msh", folder_ / "sized.h5");
    const auto function = read_influence_file(folder_ / "sized.h5");
    const auto numbers = expand(function, {.dx = 0.5, .offsets = 20});
    if (!last.empty()) {
      double difference = 0;
      for (std::size_t i = 0; i < last.size(); ++i)
        difference = std::max(difference, std::abs(numbers.values[i] - last[i]));
      const double self = numbers.at(0, 4, 2, 4, 2);
      EXPECT_LT(difference, 2e-3 * self);
      // With the support's compliance they are not the same: the test can fail.
      const auto included =
          expand(function, {.dx = 0.5, .offsets = 20, .structural = StructuralCompliance::included});
      EXPECT_GT(std::abs(included.at(0, 4, 2, 4, 2) - self), 5e-3 * self);
    }
    last.assign(numbers.values.begin(), numbers.values.end());
  }
}

TEST_F(Run, a_stopped_run_goes_on_and_gives_the_same_file) {
  const BodyFile body = flat_block();
  const ProfileCurve curve = straight_line(40);
  const auto whole = folder_ / "whole.h5", stopped = folder_ / "stopped.h5";
  const RunReport first = run_harmonic(body, curve, folder_ / "block.msh", whole);
  EXPECT_EQ(first.resumed, 0u);
  struct Stop {};
  EXPECT_THROW(run_harmonic(body, curve, folder_ / "block.msh", stopped,
                            [](std::size_t done, std::size_t) {
                              if (done == 5)
                                throw Stop();
                            }),
               Stop);
  EXPECT_FALSE(std::filesystem::exists(stopped));
  const RunReport second = run_harmonic(body, curve, folder_ / "block.msh", stopped);
  EXPECT_EQ(second.resumed, 5u);
  EXPECT_EQ(second.wavenumbers, first.wavenumbers);
  EXPECT_TRUE(bytes(whole) == bytes(stopped));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "stopped.h5.part"));
}

TEST_F(Run, one_that_stopped_among_its_stresses_goes_on_and_gives_the_same_file) {
  BodyFile body = flat_block();
  body.stress.depths = 5;
  const ProfileCurve curve = straight_line(40);
  const auto whole = folder_ / "whole.h5", stopped = folder_ / "stopped.h5";
  run_harmonic(body, curve, folder_ / "block.msh", whole);
  struct Stop {};
  EXPECT_THROW(run_harmonic(body, curve, folder_ / "block.msh", stopped,
                            [](std::size_t done, std::size_t all) {
                              if (done == all - 2)
                                throw Stop();
                            }),
               Stop);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "stopped.h5.stresses.part"));
  const RunReport second = run_harmonic(body, curve, folder_ / "block.msh", stopped);
  EXPECT_EQ(second.resumed, second.wavenumbers + second.companion_wavenumbers);
  EXPECT_TRUE(bytes(whole) == bytes(stopped));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "stopped.h5.stresses.part"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "stopped.h5.part"));
}

TEST_F(Run, finished_wavenumbers_of_another_material_are_refused_and_kept) {
  BodyFile body = flat_block();
  struct Stop {};
  const auto stop = [](std::size_t done, std::size_t) {
    if (done == 2)
      throw Stop();
  };
  const ProfileCurve curve = straight_line(40);
  EXPECT_THROW(run_harmonic(body, curve, folder_ / "block.msh", folder_ / "out.h5", stop), Stop);
  body.material.poisson = 0.3;
  try {
    run_harmonic(body, curve, folder_ / "block.msh", folder_ / "out.h5");
    FAIL() << "what is finished must not be lost";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(),
                AllOf(HasSubstr("holds finished wavenumbers of another body"), HasSubstr("remove it")));
  }
  body = flat_block();
  EXPECT_GT(run_harmonic(body, curve, folder_ / "block.msh", folder_ / "out.h5").resumed, 0u);
}

TEST_F(Run, the_program_gives_the_same_file_on_one_two_and_four_processes) {
  write_text(folder_ / "body.toml", program_body);
  const auto run = [&](int processes) {
    const auto out = folder_ / ("out" + std::to_string(processes) + ".h5");
    // A clean environment: this program is an MPI process itself, and mpirun would take its settings over.
    const char* path = std::getenv("PATH");
    const std::string command = std::string("env -i PATH='") + (path ? path : "") + "' HOME='" +
                                (folder_ / "").string() + "' " + // OpenMPI 5 wants a home
                                "OPENBLAS_NUM_THREADS=1 OMPI_ALLOW_RUN_AS_ROOT=1 "
                                "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 " MPIEXEC " --oversubscribe -n " +
                                std::to_string(processes) + " " FEM_INFLUENCE_PROGRAM " " +
                                (folder_ / "body.toml").string() + " " + (folder_ / "block.msh").string() +
                                " -o " + out.string() + " 2> " + (folder_ / "messages").string();
    EXPECT_EQ(std::system(command.c_str()), 0) << bytes(folder_ / "messages");
    return bytes(out);
  };
  const std::string one = run(1);
  EXPECT_GT(one.size(), 10000u);
  for (const int processes : {2, 4})
    EXPECT_TRUE(one == run(processes)) << processes << " processes";
}

TEST_F(Run, says_what_is_wrong_with_a_mesh) {
  EXPECT_THAT(error_of("absent.msh"), AllOf(HasSubstr("absent.msh"), HasSubstr("cannot be read")));
  write_text(folder_ / "text.msh", "this is not a mesh\n");
  EXPECT_THAT(error_of("text.msh"), HasSubstr("is not a gmsh mesh of quadrilaterals"));
  write_text(folder_ / "empty.msh", "");
  EXPECT_THAT(error_of("empty.msh"), HasSubstr("is not a gmsh mesh of quadrilaterals"));
  const std::string nodes =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 -2 0 0\n2 2 0 0\n3 2 4 0\n4 -2 4 0\n"
      "$EndNodes\n$Elements\n";
  write_text(folder_ / "triangles.msh", nodes + "4\n1 1 2 1 1 1 2\n2 1 2 2 2 3 4\n3 2 2 10 10 1 2 3\n"
                                                "4 2 2 10 10 1 3 4\n$EndElements\n");
  EXPECT_THAT(error_of("triangles.msh"), HasSubstr("quadrilaterals"));
  write_text(folder_ / "no_groups.msh", nodes + "1\n1 3 2 10 10 1 2 3 4\n$EndElements\n");
  EXPECT_THAT(error_of("no_groups.msh"),
              AllOf(HasSubstr("has no group 'contact' (physical curve 1)"), HasSubstr("mesh_body")));
  write_text(folder_ / "no_held.msh", nodes + "2\n1 1 2 1 1 1 2\n2 3 2 10 10 1 2 3 4\n$EndElements\n");
  EXPECT_THAT(error_of("no_held.msh"), HasSubstr("has no group 'held' (physical curve 2)"));
}

/// The edges that mesh_body lists behind the elements are then straight.
TEST_F(Run, refuses_a_mesh_that_was_cut_off) {
  const auto mesh = [](int geometric_points) {
    return "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n" + std::to_string(geometric_points) +
           " 3 1 0\n$EndEntities\n$Nodes\n$EndNodes\n$Elements\n$EndElements\n";
  };
  for (const char* end : {"", "$Comments\ncurved edges, y z of an end\n1 2 3 4 5 6\n"}) {
    write_text(folder_ / "cut.msh", mesh(0) + end);
    EXPECT_THAT(error_of("cut.msh"), AllOf(HasSubstr("cut.msh' is not whole"), HasSubstr("it was cut off")));
  }
  write_text(folder_ / "own.msh", mesh(4)); // gmsh's own, of a geometry
  EXPECT_THAT(error_of("own.msh"), HasSubstr("is not a gmsh mesh of quadrilaterals"));
}

TEST_F(Run, refuses_a_strip_that_does_not_match_the_mesh) {
  BodyFile body = flat_block();
  body.strip = {-2.4, 2.4, 0.6};
  EXPECT_THAT(error_of("block.msh", "out.h5", body), HasSubstr("The mesh does not match the strip"));
  body.strip = {-2.5, 2.5, 0.5};
  EXPECT_THAT(error_of("block.msh", "out.h5", body),
              AllOf(HasSubstr("The mesh does not match the strip"), HasSubstr("station 0")));
  body.strip = {-41, 41, 0.5};
  EXPECT_THAT(error_of("block.msh", "out.h5", body), HasSubstr("is not on profile straight line"));
  write_ring_mesh(folder_ / "ring.msh", 2, 6, 24);
  EXPECT_THAT(error_of("ring.msh"), HasSubstr("The mesh does not fit the profile 'straight line'"));
  body = flat_block();
  body.harmonic.remote_distance = 400;
  EXPECT_THAT(error_of("block.msh", "out.h5", body), HasSubstr("No cell is farther than 400"));
  body.harmonic.remote_distance = 0.01; // nearer than any cell's centre is to twice that
  EXPECT_THAT(error_of("block.msh", "out.h5", body), HasSubstr("No cell lies between 0.01"));
  body = flat_block();
  body.harmonic.half_period = 1;
  EXPECT_THAT(error_of("block.msh", "out.h5", body), HasSubstr("does not exceed that of harmonic 8"));
}

TEST_F(Run, refuses_the_mesh_of_another_body_file) {
  const BodyFile body = flat_block();
  const ProfileCurve curve = straight_line(40);
  const std::string mesh = bytes(folder_ / "block.msh");
  const auto marked = [&](const std::string& digest) {
    write_text(folder_ / "marked.msh", mesh + "$Comments\nbody file " + digest + "\n$EndComments\n");
  };
  BodyFile other = body;
  other.body.size = 50;
  marked(mesh_digest(other, curve.digest()));
  EXPECT_THAT(error_of("marked.msh"),
              AllOf(HasSubstr("was made from another body file"), HasSubstr("mesh_body")));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out.h5.part"));
  marked(mesh_digest(body, curve.digest()));
  EXPECT_EQ(error_of("marked.msh"), "no error");
}

// A limit on the size of files fails a write as a full disk does.
TEST_F(Run, a_full_disk_leaves_nothing_under_the_final_name) {
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const rlimit small{40 * 1024, before.rlim_max};
  std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  std::string message;
  try {
    run_harmonic(flat_block(), straight_line(40), folder_ / "block.msh", folder_ / "full.h5");
  } catch (const InputError&) { // nothing is wrong with the input
  } catch (const Error& error) {
    message = error.what();
  }
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, SIG_DFL);
  EXPECT_THAT(message, AllOf(HasSubstr("cannot be written"), HasSubstr("the disk may be full")));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "full.h5"));
}

TEST_F(Run, refuses_an_output_that_cannot_be_written) {
  EXPECT_THAT(error_of("block.msh", "absent/out.h5"),
              AllOf(HasSubstr("cannot be written"), HasSubstr("absent")));
  std::filesystem::create_directory(folder_ / "folder.h5");
  EXPECT_THAT(error_of("block.msh", "folder.h5"), HasSubstr("it is a folder"));
}

TEST(Wavenumbers, are_the_harmonics_then_equal_steps_up_to_the_largest) {
  const auto k = wavenumber_samples(600, 0.2, 7);
  for (int n = 0; n <= 8; ++n)
    EXPECT_DOUBLE_EQ(k[static_cast<std::size_t>(n)], n * std::acos(-1.0) / 600);
  EXPECT_DOUBLE_EQ(k.back(), 50);
  for (std::size_t i = 9; i + 1 < k.size(); ++i)
    EXPECT_NEAR(k[i + 1] / k[i], k[9] / k[8], 1e-12);
  EXPECT_LE(std::log10(k[9] / k[8]), 1.0 / 7);
  EXPECT_GT(std::log10(k[9] / k[8]), 1.0 / 8);
  EXPECT_EQ(k.size() % 2, 1u);
}

TEST(Wavenumbers, every_second_logarithmic_sample_can_be_left_out) {
  for (const int samples : {4, 5, 7}) {
    const auto k = wavenumber_samples(600, 0.2, samples);
    const auto kept = companion_samples(k.size());
    EXPECT_EQ(kept.size(), 9 + (k.size() - 9) / 2);
    EXPECT_EQ(kept.back(), k.size() - 1);
    for (std::size_t i = 8; i + 1 < kept.size(); ++i)
      EXPECT_EQ(kept[i + 1], kept[i] + 2);
  }
}

} // namespace
} // namespace bem_contact::fem::test
