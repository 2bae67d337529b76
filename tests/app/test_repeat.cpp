#include "bem_contact/h5/table.hpp"
#include "bem_contact/scene/scene_file.hpp"
#include "tests/app/run_program.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <tuple>

namespace {

using namespace bem_contact;
using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

const std::string data = CONFORMAL_SOURCE_DIR "/data/";

/// Result files, and `solve` of them.
class Repeat : public ProgramTest {
protected:
  std::string quoted(const fs::path& file) const {
    return std::string("'").append((folder_ / file).string()).append("'"); // gcc 12 warns of operator+
  }
  void solve(const std::string& scene, const std::string& more = "") const {
    const Outcome r = run("solve " + quoted(scene) + " -o " + quoted("r.h5") + " " + more);
    ASSERT_EQ(r.code, 0) << r.err;
  }
  Outcome repeat(const std::string& more = "") const { return run("solve " + quoted("r.h5") + " " + more); }
  void expect_same(const std::string& more = "") const {
    const Outcome r = repeat(more);
    EXPECT_EQ(r.code, 0) << r.err << r.out;
    EXPECT_THAT(r.out, HasSubstr("the same: every total"));
  }
  void expect_refused(const std::string& more, const std::vector<std::string>& words) const {
    const Outcome r = repeat(more);
    EXPECT_EQ(r.code, 2) << r.err;
    EXPECT_EQ(r.out, "");
    for (const std::string& word : words)
      EXPECT_THAT(r.err, HasSubstr(word));
  }
  /// The scene of the gauge corner with its two influence files beside it.
  void corner() const {
    std::string text = text_of(data + "scenes/conformal_small.toml");
    for (std::string::size_type at; (at = text.find("../influence/")) != std::string::npos;)
      text.erase(at, 13);
    write("s.toml", text);
    for (const char* name : {"small_rail.h5", "small_wheel.h5"})
      fs::copy_file(data + "influence/" + name, folder_ / name);
  }
  static std::string sha256sum(const fs::path& file) {
    std::FILE* said = popen(("sha256sum '" + file.string() + "'").c_str(), "r");
    std::string digest(64, '?');
    EXPECT_EQ(std::fread(digest.data(), 1, digest.size(), said), digest.size());
    pclose(said);
    return digest;
  }
  /// A wheel and a rail with measured profiles.
  void measured() const {
    for (const char* name : {"worn_rail.txt", "worn_wheel.txt"})
      fs::copy_file(data + "bodies/" + name, folder_ / name);
    write("s.toml",
          "# worn\nrail.profile = \"worn_rail.txt\"\nwheel.profile = \"worn_wheel.txt\"\nload.force = 2e4\n"
          "rail.smoothing = 8\nwheel.smoothing = 8\n[grid]\ndx = 1.0\nds = 0.5\n");
  }
};

TEST_F(Repeat, AResultSaysWhatItIs) {
  corner();
  solve("s.toml", "--model fem");
  const H5Table table = read_h5(folder_ / "r.h5");
  const auto text = [&](const char* name) { return std::get<std::string>(table.attributes.at(name)); };
  EXPECT_EQ(table.texts.at("scene_text").text, text_of(folder_ / "s.toml"));
  const SceneFile again = parse_scene_file(table.texts.at("scene_with_defaults").text);
  EXPECT_EQ(again.solver.model, Model::fem) << "the option's model, not the scene's";
  EXPECT_EQ(again.position.gauge, 1435);
  EXPECT_EQ(text("model_option"), "fem");
  EXPECT_THAT(text("program"), HasSubstr("bem_contact "));
  EXPECT_FALSE(text("commit").empty());
  EXPECT_EQ(text("scene"), "s.toml");
  EXPECT_EQ(text("scene_folder"), ".");
  EXPECT_EQ(text("inputs/rail.influence/name"), "small_rail.h5");
  EXPECT_EQ(text("inputs/rail.influence/sha256"), sha256sum(folder_ / "small_rail.h5"));
  EXPECT_EQ(text("inputs/wheel.profile/name"), "S1002");
  EXPECT_EQ(text("geometry/wheel").size(), 16u);
  EXPECT_EQ(table.datasets.at("materials/rail_shear_modulus").unit, "MPa");
  EXPECT_EQ(table.datasets.at("materials/rail_shear_modulus").values.front(), 82000);
  EXPECT_THAT(table.texts.at("warnings").text, HasSubstr("yield strength"));
  EXPECT_EQ(text("solver/tangential"), "Newton, GCR");
  EXPECT_EQ(table.datasets.at("patches/wheel_s").values.size(), 1u);
  // No path of the machine, and the same bytes but for the seconds.
  for (const auto& [name, value] : table.attributes)
    if (const auto* word = std::get_if<std::string>(&value)) {
      EXPECT_THAT(*word, ::testing::Not(HasSubstr(folder_.string()))) << name;
    }
}

TEST_F(Repeat, TheSceneCanBeTakenOut) {
  corner();
  solve("s.toml");
  EXPECT_EQ(run("info --scene " + quoted("r.h5")).out, text_of(folder_ / "s.toml"));
  write("full.toml", run("info --scene-with-defaults " + quoted("r.h5")).out);
  const auto pmax = [&](const char* scene) {
    const Outcome r = run("solve --json " + quoted(scene));
    EXPECT_EQ(r.code, 0) << r.err;
    return json::parse(r.out)["quantities"]["pmax"].get<double>();
  };
  EXPECT_EQ(pmax("full.toml"), pmax("s.toml"));
  EXPECT_THAT(run("info --scene " + quoted("small_rail.h5")).err, HasSubstr("holds no scene"));
}

TEST_F(Repeat, ItIsTheSameWhereverTheTreeIsMoved) {
  fs::create_directories(folder_ / "scenes");
  fs::create_directories(folder_ / "out");
  corner();
  for (const char* name : {"s.toml", "small_rail.h5", "small_wheel.h5"})
    fs::rename(folder_ / name, folder_ / "scenes" / name);
  const Outcome r = run("solve " + quoted("scenes/s.toml") + " -o " + quoted("out/r.h5"));
  ASSERT_EQ(r.code, 0) << r.err;
  fs::create_directories(folder_ / "elsewhere");
  for (const char* name : {"scenes", "out"})
    fs::rename(folder_ / name, folder_ / "elsewhere" / name);
  EXPECT_EQ(run("solve " + quoted("elsewhere/out/r.h5")).code, 0);
  fs::rename(folder_ / "elsewhere/out/r.h5", folder_ / "r.h5"); // now alone
  expect_refused("", {"The influence file 'small_rail.h5' is missing",
                      sha256sum(data + "influence/small_rail.h5").c_str(), "--folder"});
  expect_same("--folder " + quoted("elsewhere/scenes"));
}

TEST_F(Repeat, AChangedInfluenceFileIsRefusedWithBothDigests) {
  corner();
  solve("s.toml");
  const std::string before = sha256sum(folder_ / "small_wheel.h5");
  std::ofstream(folder_ / "small_wheel.h5", std::ios::app) << "x";
  expect_refused("", {"small_wheel.h5", "has changed since", before, sha256sum(folder_ / "small_wheel.h5")});
}

/// Profiles and tables are kept in the result file.
TEST_F(Repeat, ProfilesNeedNotBeThere) {
  measured();
  solve("s.toml");
  expect_same();
  const std::string before = sha256sum(folder_ / "worn_rail.txt");
  std::ofstream(folder_ / "worn_rail.txt", std::ios::app) << "\n";
  const Outcome changed = repeat();
  EXPECT_EQ(changed.code, 0) << changed.err;
  EXPECT_THAT(changed.err, AllOf(HasSubstr("worn_rail.txt"), HasSubstr("has changed since"),
                                 HasSubstr(before), HasSubstr(sha256sum(folder_ / "worn_rail.txt"))));
  for (const char* name : {"s.toml", "worn_rail.txt", "worn_wheel.txt"})
    fs::remove(folder_ / name);
  expect_same();
}

/// A rail of sections: profiles of a list are kept, those of a slices file must lie where they were.
TEST_F(Repeat, RailsOfSections) {
  measured();
  const std::string rest =
      "wheel.profile = 'S1002'\nload.force = 2e4\nsolver.model = 'halfspace'\nposition.along = 20\n"
      "rail.smoothing = 8\ngrid = { dx = 1.0, ds = 0.5 }\n";
  write("s.toml",
        "rail.sections = [ { at = 0, profile = 'worn_rail.txt' }, { at = 90, profile = '60E1' } ]\n" + rest);
  solve("s.toml");
  fs::rename(folder_ / "worn_rail.txt", folder_ / "kept.txt");
  expect_same();
  fs::create_directory(folder_ / "all");
  fs::rename(folder_ / "kept.txt", folder_ / "all" / "worn.txt");
  write("all/r.slcs", "0 1\n2\n0\n1\n0 'worn.txt'\n90 '60E1'\n");
  write("s.toml", "rail.profile = 'all/r.slcs'\n" + rest);
  solve("s.toml");
  expect_same();
  std::ofstream(folder_ / "all" / "worn.txt", std::ios::app) << "\n";
  expect_refused("", {"worn.txt", "has changed since", "rail.profile.sections[0].profile"});
}

TEST_F(Repeat, TablesNeedNotBeThere) {
  for (const auto& entry : fs::directory_iterator(data + "scenes"))
    if (entry.path().filename().string().starts_with("by_tables"))
      fs::copy_file(entry.path(), folder_ / entry.path().filename());
  solve("by_tables.toml");
  for (const auto& entry : fs::directory_iterator(folder_))
    if (entry.path().extension() == ".csv")
      fs::remove(entry.path());
  expect_same();
}

TEST_F(Repeat, WhatDiffersIsSaidWithHowMuchAndBeyondWhat) {
  corner();
  solve("s.toml", "--model halfspace");
  H5Table table = read_h5(folder_ / "r.h5");
  table.datasets.at("quantities/Fy").values[0] += 1.0; // of 1e5 N, and 0.1 N are allowed
  table.datasets.at("quantities/contact").values[0] += 1;
  table.datasets.at("quantities/pmax").values[0] *= 1 + 1e-8;
  table.attributes.at("geometry/rail") = std::string("0123456789abcdef");
  write_h5(folder_ / "r.h5", table);
  const Outcome r = repeat();
  EXPECT_EQ(r.code, 3);
  EXPECT_THAT(r.out, HasSubstr("\nFy "));
  EXPECT_THAT(r.out, HasSubstr("-1.00e+00"));
  EXPECT_THAT(r.out, HasSubstr("\ncontact "));
  EXPECT_THAT(r.out, ::testing::Not(HasSubstr("\npmax ")));
  EXPECT_THAT(r.out, HasSubstr("0123456789abcdef"));
  const json j = json::parse(repeat("--json").out);
  EXPECT_EQ(j["same"], false);
  EXPECT_EQ(j["differences"].size(), 2u);
  EXPECT_NEAR(j["differences"]["Fy"]["allowed"].get<double>(), 0.1, 0.01);
  EXPECT_EQ(j["result"]["model"], "halfspace");
}

TEST_F(Repeat, ADamagedCopyIsRefused) {
  measured();
  solve("s.toml");
  H5Table table = read_h5(folder_ / "r.h5");
  table.texts.at("inputs/rail.profile/content").text += "0 0\n";
  write_h5(folder_ / "r.h5", table);
  expect_refused("", {"copy of 'worn_rail.txt' is damaged"});
}

/// Names of a result file become names of files: they lead nowhere else, and nothing is written before all
/// are known to be fine.
TEST_F(Repeat, NamesThatLeadElsewhereAreRefused) {
  measured();
  solve("s.toml");
  const H5Table whole = read_h5(folder_ / "r.h5");
  const fs::path victim = write("victim.txt", "precious");
  const std::string up = "../../../../../../../.." + victim.parent_path().string(), content = "not precious";
  const auto with = [&](const std::string& key, const std::string& name) {
    H5Table table = whole;
    const std::string group = "inputs/" + key + "/";
    table.texts[group + "content"] = {content, "a file"};
    table.attributes[group + "name"] = name;
    table.attributes[group + "sha256"] = sha256sum(write("content", content));
    write_h5(folder_ / "r.h5", table);
  };
  for (const auto& [key, name, words] : {std::tuple{"../x", "victim.txt", "unknown key"},
                                         {"a/b", "victim.txt", "unknown key"},
                                         {"rail.profil", "victim.txt", "unknown key"},
                                         {"rail.profile", "..", "the file of its input rail.profile"},
                                         {"wheel.profile", "a/", "the file of its input wheel.profile"}}) {
    with(key, name);
    expect_refused("", {words});
    EXPECT_EQ(text_of(victim), "precious");
  }
  with("rail.profile", up + "/victim.txt"); // only the last part of a name is used
  EXPECT_NE(repeat().code, 1);
  EXPECT_EQ(text_of(victim), "precious");
}

TEST_F(Repeat, WhatIsNoResultIsRefusedWithTheWayOut) {
  corner();
  solve("s.toml");
  expect_refused("--model hertz", {"--model cannot be given", "info --scene"});
  expect_refused("-o " + quoted("other.h5"), {"--output cannot be given"});
  const Outcome compared = run("compare " + quoted("s.toml") + " -o " + quoted("r.h5"));
  ASSERT_EQ(compared.code, 0) << compared.err;
  expect_refused("", {"holds a comparison", "bem_contact compare"});
  EXPECT_EQ(run("info --scene " + quoted("r.h5")).out, text_of(folder_ / "s.toml"));
  EXPECT_THAT(run("info " + quoted("r.h5")).out, HasSubstr("A comparison of bem_contact"));
  write("w.toml", text_of(folder_ / "s.toml") + "\n[sweep]\nposition.lateral = [6.5, 6.6]\n");
  fs::remove(folder_ / "r.h5");
  ASSERT_EQ(run("sweep " + quoted("w.toml") + " --model halfspace -o " + quoted("r.h5")).code, 0);
  expect_refused("", {"holds the cases of a sweep", "bem_contact sweep"});
  EXPECT_EQ(run("info --scene " + quoted("r.h5")).out, text_of(folder_ / "w.toml"));
  fs::copy_file(folder_ / "small_rail.h5", folder_ / "r.h5", fs::copy_options::overwrite_existing);
  expect_refused("", {"r.h5"}); // an influence file begins with its seal, and is no scene either
  EXPECT_THAT(run("solve " + quoted("s.toml") + " --folder .").err, HasSubstr("--folder cannot be given"));
}

} // namespace
