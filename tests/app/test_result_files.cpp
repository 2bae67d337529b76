#include "bem_contact/base/error.hpp"
#include "bem_contact/h5/table.hpp"
#include "bem_contact/halfspace/flat_strip.hpp"
#include "bem_contact/influence/influence_file.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "tests/app/run_program.hpp"

#include <cmath>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace {

using namespace bem_contact;
using nlohmann::json;
using ::testing::HasSubstr;

class ResultFiles : public ProgramTest {
protected:
  std::string scene(const std::string& name, const std::string& extra) {
    return write(name, "kind = \"wheel_rail\"\nposition.lateral = 6.5\nload.force = 2e4\n"
                       "motion.friction = 0.3\n[grid]\ndx = 1.0\nds = 0.5\n" +
                           extra)
        .string();
  }
  /// The kernel of a made-up body: a layer, softer for long waves; any symmetric positive one will do.
  std::string influence(const std::string& name, const std::string& standard, ProfileKind kind, double from,
                        double to, const Material& material = {}) {
    const ProfileCurve curve = named_profile(standard, kind);
    InfluenceFunction f;
    f.body = "made up " + standard;
    f.profile = curve.name();
    f.profile_digest = curve.digest();
    f.material = material;
    f.held = "a layer for the test";
    f.method = "closed form";
    f.half_period = 600;
    f.station_width = 0.5;
    for (double s = from + 0.25; s < to; s += 0.5) {
      const CurvePoint p = curve.at(s);
      f.stations.push_back({s, p.position, p.delta});
    }
    f.wavenumber = {0};
    for (double k = 0.005236; k < 22; k *= 1.4)
      f.wavenumber.push_back(k);
    const std::size_t n = 3 * f.stations.size();
    f.kernel.assign(f.wavenumber.size() * f.kernel_size(), 0.0);
    const double unit = (1 - material.poisson) / material.shear_modulus * f.station_width / 3.14159;
    for (std::size_t k = 0; k < f.wavenumber.size(); ++k)
      for (std::size_t a = 0; a < n; ++a)
        for (std::size_t b = 0; b < n; ++b)
          if (a % 3 == b % 3) {
            const double distance = std::hypot((double(a / 3) - double(b / 3)) * f.station_width, 0.1);
            f.kernel[f.kernel_index(k, a, b)] = unit * std::exp(-f.wavenumber[k] * distance) /
                                                (0.2 + f.wavenumber[k] * 0.25 + 0.1 * distance);
          }
    f.remote.assign(f.wavenumber.size() * 6 * n, 0.0);
    f.remote_self.assign(f.wavenumber.size() * 36, 0.0);
    for (std::size_t k = 0; k < f.wavenumber.size(); ++k)
      for (int i = 0; i < 6; ++i)
        f.remote_self[(k * 6 + i) * 6 + i] = 1e-6;
    write_influence_file(folder_ / name, f);
    return name;
  }
  std::string sides(const std::string& rail, const std::string& wheel) {
    return "[rail]\nprofile = \"60E1\"\ninfluence = \"" + rail +
           "\"\n[wheel]\nprofile = \"S1002\"\ninfluence = \"" + wheel + "\"\n";
  }
  void refused(const std::string& arguments, const std::vector<std::string>& words) {
    const Outcome r = run(arguments);
    EXPECT_EQ(r.code, 2) << r.err;
    EXPECT_EQ(r.out, "");
    for (const std::string& word : words)
      EXPECT_THAT(r.err, HasSubstr(word));
  }
};

TEST_F(ResultFiles, AResultHasFieldsWithUnits) {
  const std::string file = (folder_ / "r.h5").string();
  const Outcome r =
      run("solve '" + scene("s.toml", "[rail]\nprofile = \"60E1\"\n[wheel]\nprofile = \"S1002\"\n") +
          "' --model halfspace --json -o '" + file + "'");
  ASSERT_EQ(r.code, 0) << r.err;
  const json j = json::parse(r.out);
  const H5Table table = read_h5(file);
  const H5Dataset& p = table.datasets.at("p_n");
  EXPECT_THAT(p.shape,
              ::testing::ElementsAre(j["quantities"]["ms"].get<int>(), j["quantities"]["mx"].get<int>()));
  EXPECT_EQ(p.unit, "MPa");
  EXPECT_DOUBLE_EQ(*std::max_element(p.values.begin(), p.values.end()),
                   j["quantities"]["pmax"].get<double>());
  for (const auto& [name, data] : table.datasets) {
    EXPECT_FALSE(data.unit.empty()) << name;
    EXPECT_FALSE(data.description.empty()) << name;
  }
  // Fz from the file's own fields: p_n cos(delta) + p_s sin(delta).
  double fz = 0;
  const std::size_t mx = p.shape[1];
  for (std::size_t i = 0; i < p.values.size(); ++i) {
    const double delta = table.datasets.at("delta").values[i / mx];
    fz += (p.values[i] * std::cos(delta) + table.datasets.at("p_s").values[i] * std::sin(delta)) * 1.0 * 0.5;
  }
  EXPECT_NEAR(fz, 2e4, 1);
  const Outcome described = run("info '" + file + "'");
  EXPECT_EQ(described.code, 0);
  EXPECT_THAT(described.out, HasSubstr("p_n"));
}

TEST_F(ResultFiles, ALeftWheelSaysWhereItsYPoints) {
  const std::string sides = "[rail]\nprofile = \"60E1\"\n[wheel]\nprofile = \"S1002\"\n";
  for (const std::string side : {"left", "right"}) {
    const std::string file = (folder_ / (side + ".h5")).string();
    const std::string text = "kind = \"wheel_rail\"\nposition.side = \"" + side +
                             "\"\nload.force = 2e4\n[grid]\ndx = 1.0\nds = 0.5\n" + sides;
    const std::string solve = "solve '" + write(side + ".toml", text).string() + "' --model halfspace ";
    const Outcome r = run(solve + "--json -o '" + file + "'");
    ASSERT_EQ(r.code, 0) << r.err;
    const json j = json::parse(r.out);
    EXPECT_THAT(j["frame"].get<std::string>(), HasSubstr("y to the " + side));
    EXPECT_EQ(j["units"]["Mz"], "N mm");
    const H5Table table = read_h5(file);
    EXPECT_THAT(std::get<std::string>(table.attributes.at("frame")), HasSubstr("y to the " + side));
    EXPECT_THAT(table.datasets.at("y").description, HasSubstr("to the " + side));
    EXPECT_EQ(run(solve).out.find("counted to the left") != std::string::npos, side == "left");
  }
}

TEST_F(ResultFiles, StressesBelowTheSurfaceWhereAskedFor) {
  const std::string file = (folder_ / "b.h5").string();
  const std::string patch = "kind = \"patch\"\nload.force = 1e4\nmotion.frictionless = true\nsolver.model = "
                            "\"halfspace\"\n[grid]\ndx = 0.5\n"
                            "ds = 0.5\nmx = 16\nms = 16\n[gap]\na = 1e-3\nb = 1e-3\n";
  const Outcome without = run("solve '" + write("w.toml", patch).string() + "' --json");
  ASSERT_EQ(without.code, 0) << without.err;
  EXPECT_TRUE(json::parse(without.out)["stresses"].is_null());
  const std::string asked = patch + "[stresses]\nx = [0, 1]\ns = [-1, 0, 1]\ndepths = [0.5, 1.5]\n";
  const Outcome r = run("solve '" + write("s.toml", asked).string() + "' --json -o '" + file + "'");
  ASSERT_EQ(r.code, 0) << r.err;
  const json j = json::parse(r.out)["stresses"];
  ASSERT_EQ(j["stress"].size(), 2u) << "[x][s][depth][component]";
  ASSERT_EQ(j["stress"][0][1][0].size(), j["components"].size());
  EXPECT_LT(j["stress"][0][1][0][2].get<double>(), 0) << "below the contact n is compressed";
  // s = -1 and s = 1 are mirror images: points 0, 1 and 4, 5
  EXPECT_NEAR(j["von_mises"][0][0][0].get<double>(), j["von_mises"][0][2][0].get<double>(), 1e-6);
  const H5Table table = read_h5(file);
  const H5Dataset& stress = table.datasets.at("stresses/stress");
  EXPECT_THAT(stress.shape, ::testing::ElementsAre(2, 3, 2, 6));
  EXPECT_EQ(stress.unit, "MPa");
  EXPECT_DOUBLE_EQ(stress.values[6 * 5 + 2], j["stress"][0][2][1][2].get<double>());
  EXPECT_THAT(run("solve '" + (folder_ / "s.toml").string() + "'").out,
              HasSubstr("below the surface: largest shear"));
}

TEST_F(ResultFiles, InfluenceFunctionsOfAnotherWheelOrStripAreRefused) {
  const std::string folder = std::string(CONFORMAL_SOURCE_DIR) + "/data/influence/";
  const std::string files = sides(folder + "small_rail.h5", folder + "small_wheel.h5");
  const std::string other =
      "kind = \"wheel_rail\"\nload.force = 2e4\nmotion.frictionless = true\n[grid]\ndx = 1.0\nds = 0.5\n"
      "[position]\nlateral = 6.5\nwheel_radius = 400\n" +
      files;
  refused("solve --model fem '" + write("w.toml", other).string() + "'",
          {"do not belong to this wheel", "460 mm", "400 mm"});
  // A flat patch where the file's surface is a gauge corner.
  const std::string patch = "kind = \"patch\"\nload.force = 1e4\nmotion.frictionless = true\n"
                            "rail.influence = \"" +
                            folder + "small_rail.h5\"\nwheel.influence = \"" + folder +
                            "small_wheel.h5\"\nstrip.rail_s0 = -32\nstrip.wheel_s0 = 35\n[grid]\ndx = 1.0\n"
                            "ds = 0.5\nmx = 8\nms = 8\n[gap]\na = 1e-3\nb = 1e-3\n";
  refused("solve --model fem '" + write("p.toml", patch).string() + "'", {"do not fit the patch", "rad"});
}

TEST_F(ResultFiles, AVtkFileHasEveryElement) {
  const std::string file = (folder_ / "r.vts").string();
  const Outcome r =
      run("solve '" + scene("s.toml", "[rail]\nprofile = \"60E1\"\n[wheel]\nprofile = \"S1002\"\n") +
          "' --model halfspace --json --vtk '" + file + "'");
  ASSERT_EQ(r.code, 0) << r.err;
  const json j = json::parse(r.out);
  const int mx = j["quantities"]["mx"].get<int>(), ms = j["quantities"]["ms"].get<int>();
  const std::string text = text_of(file);
  EXPECT_THAT(text,
              HasSubstr("WholeExtent=\"0 " + std::to_string(mx) + " 0 " + std::to_string(ms) + " 0 0\""));
  for (const char* name : {"pressure", "traction", "state", "slip", "undeformed_distance"})
    EXPECT_THAT(text, HasSubstr("Name=\"" + std::string(name) + "\""));
  const auto from = text.find('\n', text.find("Name=\"pressure\"")) + 1, to = text.find("</DataArray>", from);
  std::istringstream values(text.substr(from, to - from));
  int count = 0;
  for (double v; values >> v;)
    ++count;
  EXPECT_EQ(count, mx * ms);
}

TEST_F(ResultFiles, CompareRunsBothModelsAtEqualForce) {
  influence("rail.h5", "60E1", ProfileKind::rail, -44, -20);
  influence("wheel.h5", "S1002", ProfileKind::wheel, 22, 48);
  const std::string prefix = (folder_ / "c").string();
  const Outcome r = run("compare '" + scene("s.toml", sides("rail.h5", "wheel.h5")) + "' --json -o '" +
                        prefix + ".h5' --vtk-prefix '" + prefix + "'");
  ASSERT_EQ(r.code, 0) << r.err;
  const json all = json::parse(r.out), j = all["at_equal_position"];
  EXPECT_EQ(all["reference"], "fem");
  EXPECT_EQ(j["fem"]["model"], "fem");
  EXPECT_NEAR(j["fem"]["quantities"]["Fz"].get<double>(), j["halfspace"]["quantities"]["Fz"].get<double>(),
              0.1);
  const double fem = j["fem"]["quantities"]["pmax"].get<double>(),
               halfspace = j["halfspace"]["quantities"]["pmax"].get<double>();
  EXPECT_NEAR(j["difference"]["halfspace"]["pmax"].get<double>(), (fem - halfspace) / halfspace, 1e-12);
  EXPECT_EQ(j["fem"]["quantities"]["dx"], j["halfspace"]["quantities"]["dx"]);
  const json equal = all["at_equal_forces"];
  EXPECT_NEAR(equal["difference"]["halfspace"]["Fy"].get<double>(), 0, 1e-5);
  const H5Table table = read_h5(prefix + ".h5");
  for (const char* set : {"at_equal_forces/", "at_equal_position/"})
    for (const char* model : {"fem/", "halfspace/"})
      for (const char* name : {"p_n", "x", "s", "gap"})
        EXPECT_TRUE(table.datasets.contains(std::string(set) + model + name)) << set << model << name;
  for (const auto& [name, data] : table.datasets)
    EXPECT_FALSE(data.unit.empty() || data.description.empty()) << name;
  const auto column = [&](const std::string& name) {
    return table.datasets.at("creep_forces/" + name).values;
  };
  const json& said = all["creep_forces"];
  ASSERT_EQ(said["xi_from_free_rolling"].size(), column("xi_from_free_rolling").size());
  ASSERT_FALSE(said["xi_from_free_rolling"].empty());
  for (std::size_t k = 0; k < said["xi_from_free_rolling"].size(); ++k) {
    EXPECT_EQ(column("xi_from_free_rolling")[k], said["xi_from_free_rolling"][k].get<double>());
    for (const std::string model : {"fem", "halfspace"})
      for (const std::string name : {"Fx", "Fx_error"}) {
        const double kept = column(name + "/" + model).at(k);
        EXPECT_EQ(std::isnan(kept) ? json(nullptr) : json(kept), said[name][model][k]) << name << model;
      }
  }
  EXPECT_FALSE(std::isnan(column("Fx/fem").front()));
  EXPECT_EQ(table.datasets.at("creep_forces/Fx_error/fem").unit, "N");
  EXPECT_TRUE(std::filesystem::exists(prefix + "_fem.vts") &&
              std::filesystem::exists(prefix + "_halfspace.vts"));
}

TEST_F(ResultFiles, AComparisonAtOneForceHasNoCreepForces) {
  const std::string file = (folder_ / "c.h5").string();
  const std::string given = "load.force_x = 1000\n[rail]\nprofile = \"60E1\"\n[wheel]\nprofile = \"S1002\"\n";
  const std::string text = "position.lateral = 6.5\nload.force = 2e4\ngrid.dx = 1.0\ngrid.ds = 0.5\n" + given;
  const Outcome r = run("compare '" + write("s.toml", text).string() +
                        "' --models halfspace tangent_plane -o '" + file + "'");
  ASSERT_EQ(r.code, 0) << r.err;
  for (const auto& [name, data] : read_h5(file).datasets)
    EXPECT_FALSE(name.starts_with("creep_forces")) << name;
}

TEST_F(ResultFiles, AnotherProfilesInfluenceFileIsRefused) {
  influence("rail.h5", "60E2", ProfileKind::rail, -44, -20);
  influence("wheel.h5", "S1002", ProfileKind::wheel, 22, 48);
  refused("solve '" + scene("s.toml", sides("rail.h5", "wheel.h5")) + "' --model fem", {"60E2", "60E1"});
}

TEST_F(ResultFiles, AnotherMaterialsInfluenceFileIsRefused) {
  influence("rail.h5", "60E1", ProfileKind::rail, -44, -20, {70000, 0.3});
  influence("wheel.h5", "S1002", ProfileKind::wheel, 22, 48);
  refused("solve '" + scene("s.toml", sides("rail.h5", "wheel.h5")) + "' --model fem", {"material"});
}

TEST_F(ResultFiles, APatchOutsideTheStripIsRefused) {
  influence("rail.h5", "60E1", ProfileKind::rail, -44, -29);
  influence("wheel.h5", "S1002", ProfileKind::wheel, 22, 48);
  refused("solve '" + scene("s.toml", sides("rail.h5", "wheel.h5")) + "' --model fem", {"strip"});
  influence("far.h5", "60E1", ProfileKind::rail, -20, -10);
  refused("solve '" + scene("f.toml", sides("far.h5", "wheel.h5")) + "' --model fem", {"strip"});
}

TEST_F(ResultFiles, ATruncatedInfluenceFileIsRefused) {
  influence("rail.h5", "60E1", ProfileKind::rail, -44, -20);
  influence("wheel.h5", "S1002", ProfileKind::wheel, 22, 48);
  std::filesystem::resize_file(folder_ / "rail.h5", std::filesystem::file_size(folder_ / "rail.h5") / 2);
  refused("solve '" + scene("s.toml", sides("rail.h5", "wheel.h5")) + "' --model fem", {"rail.h5"});
  refused("info '" + (folder_ / "rail.h5").string() + "'", {"rail.h5"});
}

TEST_F(ResultFiles, InfoDescribesAnInfluenceFile) {
  influence("rail.h5", "60E1", ProfileKind::rail, -44, -20);
  const Outcome r = run("info '" + (folder_ / "rail.h5").string() + "'");
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("made up 60E1"));
  EXPECT_THAT(r.out, HasSubstr("48 stations 0.5 mm wide"));
  for (const char* said :
       {"elements along x from", "held: ", "estimated error", "Maxwell-Betti", "MB on disk"})
    EXPECT_THAT(r.out, HasSubstr(said));
}

TEST_F(ResultFiles, CheckSaysWhetherTheStripsCoverTheRows) {
  influence("wide.h5", "60E1", ProfileKind::rail, -44, -20);
  influence("narrow.h5", "60E1", ProfileKind::rail, -44, -41);
  influence("wheel.h5", "S1002", ProfileKind::wheel, 22, 48);
  const Outcome wide = run("check '" + scene("wide.toml", sides("wide.h5", "wheel.h5")) + "'");
  EXPECT_EQ(wide.code, 0) << wide.err;
  EXPECT_THAT(wide.out, HasSubstr("mm: covered"));
  const Outcome narrow = run("check '" + scene("narrow.toml", sides("narrow.h5", "wheel.h5")) + "'");
  EXPECT_EQ(narrow.code, 0) << narrow.err;
  EXPECT_THAT(narrow.out, HasSubstr("they leave the strip by"));
}

TEST_F(ResultFiles, TheSmallSceneIsConformalUnderTheShippedInfluenceFiles) {
  const Outcome r = run("compare '" CONFORMAL_SOURCE_DIR "/data/scenes/conformal_small.toml' --json");
  ASSERT_EQ(r.code, 0) << r.err;
  const json j = json::parse(r.out)["at_equal_position"];
  for (const char* model : {"halfspace", "fem"}) {
    EXPECT_LE(j[model]["quantities"]["certificate"].get<double>(), 1e-6);
    EXPECT_NEAR(j[model]["quantities"]["Fz"].get<double>(), 1e5, 0.1);
  }
  // Both share geometry and force; the bodies' own compliance spreads the contact.
  EXPECT_LT(j["difference"]["halfspace"]["pmax"].get<double>(), -0.02);
  EXPECT_GT(j["difference"]["halfspace"]["area"].get<double>(), 0.05);
  const Outcome chosen = run("solve '" CONFORMAL_SOURCE_DIR "/data/scenes/conformal_small.toml' --json");
  EXPECT_EQ(json::parse(chosen.out)["model"], "fem");
  EXPECT_THAT(json::parse(chosen.out)["why_this_model"].get<std::string>(),
              HasSubstr("more than the 1 % allowed"));
}

} // namespace
