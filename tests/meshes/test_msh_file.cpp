#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/bodies/body_file.hpp"
#include "mesh_checks.hpp"
#include "meshes/section_mesh.hpp"
#include "meshes/write_msh.hpp"
#include "tests/base/temporary_folder.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

namespace bem_contact::meshes {
namespace {

using testing::HasSubstr;

class MshFile : public testing::Test {
protected:
  void SetUp() override {
    body.body = {.kind = BodyKind::block, .size = 20};
    body.strip = {.from = -5, .to = 5, .station_width = 0.5};
  }
  std::string text(const std::filesystem::path& file) const {
    std::ifstream in(file);
    std::stringstream all;
    all << in.rdbuf();
    return all.str();
  }

  TemporaryFolder own;
  std::filesystem::path folder = own.path();
  BodyFile body;
};

/// What a reader of MSH 4.1 finds.
struct Read {
  std::map<std::size_t, Point2> nodes;
  std::map<std::pair<int, int>, int> elements; ///< by entity's tag and element type
};

Read read(const std::string& text) {
  std::istringstream in(text);
  std::string word;
  Read result;
  while (in >> word)
    if (word == "$Nodes" || word == "$Elements") {
      std::size_t blocks, total, least, most;
      in >> blocks >> total >> least >> most;
      for (std::size_t b = 0; b < blocks; ++b) {
        int dimension, tag, kind;
        std::size_t count;
        in >> dimension >> tag >> kind >> count;
        if (word == "$Elements") {
          const std::size_t columns = kind == 1 ? 3 : 5;
          for (std::size_t i = 0, number; i < columns * count; ++i)
            in >> number;
          result.elements[{tag, kind}] += static_cast<int>(count);
          continue;
        }
        std::vector<std::size_t> tags(count);
        for (auto& t : tags)
          in >> t;
        for (const auto t : tags) {
          double z;
          in >> result.nodes[t].y >> result.nodes[t].z >> z;
        }
      }
    }
  return result;
}

TEST_F(MshFile, HoldsNamesGroupsAndPlacesOfTheMesh) {
  const QuadMesh mesh = mesh_section(body);
  write_msh(mesh, folder / "block.msh");
  const std::string content = text(folder / "block.msh");
  EXPECT_THAT(content, HasSubstr("$MeshFormat\n4.1 0 8\n"));
  EXPECT_THAT(content, HasSubstr("$Comments\nbody file " + mesh.body_digest + " sha256 "));
  EXPECT_THAT(content,
              HasSubstr("$PhysicalNames\n4\n1 1 \"contact\"\n1 2 \"held\"\n1 3 \"free\"\n2 10 \"body\"\n"));
  const Read found = read(content);
  ASSERT_EQ(found.nodes.size(), mesh.points.size());
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    EXPECT_LT(norm(found.nodes.at(v + 1) - mesh.points[v]), 1e-12);
  const std::map<std::pair<int, int>, int> expected{
      {{1, 1}, 20},
      {{2, 1}, static_cast<int>(edges_of(mesh, Group::held).size())},
      {{3, 1}, static_cast<int>(edges_of(mesh, Group::free).size())},
      {{10, 3}, static_cast<int>(mesh.quads.size())}};
  EXPECT_EQ(found.elements, expected);
}

TEST_F(MshFile, IsTheOnlyFileLeftAndReplacesAnOldOne) {
  std::ofstream(folder / "block.msh") << "old";
  write_msh(mesh_section(body), folder / "block.msh");
  EXPECT_THAT(text(folder / "block.msh"), HasSubstr("$Elements"));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1);
}

TEST_F(MshFile, TwoRunsGiveTheSameFile) {
  write_msh(mesh_section(body), folder / "a.msh");
  write_msh(mesh_section(body), folder / "b.msh");
  EXPECT_EQ(text(folder / "a.msh"), text(folder / "b.msh"));
}

TEST_F(MshFile, IsRefusedWhereItCannotBeWritten) {
  const QuadMesh mesh = mesh_section(body);
  for (const auto& file : {folder / "missing" / "block.msh", folder})
    try {
      write_msh(mesh, file);
      FAIL() << file;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("'" + file.string() + "' cannot be written"));
      EXPECT_THAT(error.what(), ::testing::AnyOf(HasSubstr("Make the folder, or give another file."),
                                                 HasSubstr("Give the name of a file in it.")));
    }
}

class Program : public MshFile {
protected:
  int run(const std::string& arguments) {
    const std::string command = fmt::format("'{}' {} > '{}' 2> '{}'", MESH_BODY_PROGRAM, arguments,
                                            (folder / "out").string(), (folder / "err").string());
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
};

TEST_F(Program, MeshesAndReports) {
  const auto file = (folder / "d.msh").string();
  EXPECT_EQ(run(fmt::format("'{}' -o '{}' --quality", (body_folder() / "disc.toml").string(), file)), 0)
      << text(folder / "err");
  EXPECT_TRUE(std::filesystem::exists(file));
  EXPECT_THAT(text(folder / "out"), HasSubstr("disc R 9.8: "));
  EXPECT_THAT(text(folder / "out"), HasSubstr("scaled Jacobian, least"));
  EXPECT_EQ(text(folder / "err"), "");
}

TEST_F(Program, NamesTheCurvedEdgesOfTheSolidToo) {
  const auto file = folder / "d.msh";
  ASSERT_EQ(run(fmt::format("'{}' --solid -o '{}'", (body_folder() / "disc.toml").string(), file.string())),
            0)
      << text(folder / "err");
  const std::string comments = text(file),
                    head = "curved edges, y z of an end, of a point between, of the other end\n";
  const auto at = comments.find(head);
  ASSERT_NE(at, std::string::npos);
  EXPECT_NE(comments[at + head.size()], '$'); // at least one edge
}

TEST_F(Program, PrintsADefaultThatItReads) {
  ASSERT_EQ(run("--print-default"), 0);
  std::filesystem::copy_file(folder / "out", folder / "body.toml");
  EXPECT_EQ(run(fmt::format("'{0}/body.toml' -o '{0}/body.msh'", folder.string())), 0)
      << text(folder / "err");
}

TEST_F(Program, ExitsWithTwoForWrongInput) {
  EXPECT_EQ(run(""), 2);
  EXPECT_THAT(text(folder / "err"), HasSubstr("Nothing to mesh (a body file and -o OUT.msh are needed)"));
  EXPECT_EQ(run("missing.toml -o a.msh"), 2);
  EXPECT_THAT(text(folder / "err"), HasSubstr("missing.toml"));
  EXPECT_EQ(run("--wrong-option"), 2);
  std::ofstream(folder / "bad.toml") << "[body]\nkind = \"rial\"\n";
  EXPECT_EQ(run(fmt::format("'{0}/bad.toml' -o '{0}/a.msh'", folder.string())), 2);
  EXPECT_THAT(text(folder / "err"), HasSubstr("rail"));
  EXPECT_FALSE(std::filesystem::exists(folder / "a.msh"));
}

} // namespace
} // namespace bem_contact::meshes
