// `bem_contact influence expand` on two flat half-spaces of unlike materials: what another program reads from
// its files are the closed forms of a pair, signs and order included.
#include "bem_contact/influence/influence_file.hpp"
#include "tests/app/run_program.hpp"
#include "tests/halfspace/strip_kernel.hpp"

#include <gmock/gmock.h>

#include <iomanip>

namespace {

using namespace bem_contact;
using ::testing::AllOf;
using ::testing::HasSubstr;

const Material rail_material{82000, 0.28}, wheel_material{60000, 0.4};
constexpr double dx = 0.5, dy = 0.4;
constexpr int mx = 5, my = 4;

class InfluenceCommand : public ProgramTest {
protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write_influence_file(folder_ / "rail.h5", halfspace_function(rail_material, 8, 0.4, 0.4));
    write_influence_file(folder_ / "wheel.h5", halfspace_function(wheel_material, 9, 0.4, 0.4));
  }
  std::string path(const std::string& name) const { return "'" + (folder_ / name).string() + "'"; }
  Outcome expand(const std::string& files, const std::string& rest) const {
    return run("influence expand " + files + " --dx 0.5 --ds 0.4 --mx 5 --my 4 " + rest);
  }
  void refused(const Outcome& outcome, const std::vector<std::string>& words) const {
    EXPECT_EQ(outcome.code, 2) << outcome.out;
    for (const std::string& word : words)
      EXPECT_THAT(outcome.err, HasSubstr(word));
  }
};

/// Coefficients as the program CONTACT holds them after loading: [ix][iy][imat][ik][jk], 1-based axes x, y, z
/// = 0, 1, 2 here, negative ix by mirroring. Reads what its loader reads: 4 lines of header, then for nmatrix
/// > 1 four lines a matrix, then for each offset two lines that are skipped and mx lines of numbers.
struct Loaded {
  int nmatrix = 0, convex = 0, quasi = 0, order = 0, symmetric_x = 0, symmetric_y = 0, mx = 0, my = 0;
  double dx = 0, dy = 0;
  std::map<std::array<int, 5>, double> c;

  explicit Loaded(const std::filesystem::path& file) {
    std::ifstream in(file);
    const auto numbers = [&in](auto&... values) { // the rest of the line is a comment
      std::string line;
      std::getline(in, line);
      std::istringstream text(line);
      EXPECT_TRUE((text >> ... >> values)) << line;
    };
    const auto skip = [&in](int lines) {
      std::string line;
      while (lines-- > 0)
        std::getline(in, line);
    };
    numbers(nmatrix, convex);
    numbers(quasi, order);
    numbers(symmetric_x, symmetric_y);
    numbers(mx, my, dx, dy);
    for (int imat = 1; imat <= nmatrix; ++imat) {
      if (nmatrix > 1)
        skip(4);
      for (int iy = -my + 1; iy < my; ++iy) {
        skip(2);
        for (int ix = 0; ix < mx; ++ix) {
          int index = -1;
          std::array<double, 10> v{}; // x, zz, zx, zy, xz, xx, xy, yz, yx, yy
          numbers(index, v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8], v[9]);
          EXPECT_EQ(index, ix);
          const std::array<int, 3> axis = {2, 0, 1};
          for (std::size_t e = 0; e < 9; ++e) {
            const int ik = axis[e / 3], jk = axis[e % 3];
            c[{ix, iy, imat, ik, jk}] = v[e + 1];
            c[{-ix, iy, imat, ik, jk}] = ((ik == 0) != (jk == 0) ? -1 : 1) * v[e + 1];
          }
        }
      }
    }
    std::string rest;
    EXPECT_FALSE(in >> rest) << rest;
  }
};

/// C of the pair at the point (x, y) for a unit load on the element about the origin. With J1 = [Y
/// asinh(X/|Y|)], J2 = [X asinh(Y/|X|)], R = [r], J5 = [Y ln r + X atan(Y/X)], J6 = [X ln r + Y atan(X/Y)] as
/// corner sums, 1/G = (1/G1 + 1/G2)/2, nu/G = (nu1/G1 + nu2/G2)/2, K/G = ((1 - 2 nu1)/G1 - (1 - 2 nu2)/G2)/4,
/// body 1 the upper: pi C_xx = J1 + (1-nu) J2, C_yy = J2 + (1-nu) J1, C_zz = (1-nu)(J1 + J2), C_xy = C_yx =
/// -nu R, C_xz = -K J5 = -C_zx, C_yz = -K J6 = -C_zy.
std::array<std::array<double, 3>, 3> pair_at_point(double x, double y) {
  const Material &a = rail_material, &b = wheel_material;
  const double g = 2 / (1 / a.shear_modulus + 1 / b.shear_modulus);
  const double nu = g * (a.poisson / a.shear_modulus + b.poisson / b.shear_modulus) / 2;
  const double k = g * ((1 - 2 * a.poisson) / a.shear_modulus - (1 - 2 * b.poisson) / b.shear_modulus) / 4;
  double j1 = 0, j2 = 0, r_sum = 0, j5 = 0, j6 = 0;
  for (const int p : {-1, 1})
    for (const int q : {-1, 1}) {
      const double px = x + p * dx / 2, py = y + q * dy / 2, r = std::hypot(px, py), w = p * q;
      j1 += w * py * std::asinh(px / std::abs(py));
      j2 += w * px * std::asinh(py / std::abs(px));
      r_sum += w * r;
      j5 += w * (py * std::log(r) + px * std::atan(py / px));
      j6 += w * (px * std::log(r) + py * std::atan(px / py));
    }
  const double pi = std::numbers::pi;
  return {{{(j1 + (1 - nu) * j2) / pi, -nu * r_sum / pi, -k * j5 / pi},
           {-nu * r_sum / pi, (j2 + (1 - nu) * j1) / pi, -k * j6 / pi},
           {k * j5 / pi, k * j6 / pi, (1 - nu) * (j1 + j2) / pi}}};
}

/// The mean over the element ix, iy elements away.
std::array<std::array<double, 3>, 3> pair_mean(int ix, int iy) {
  std::array<std::array<double, 3>, 3> mean{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      mean[i][j] = integrate(-0.5, 0.5, 24, [&](double u) {
        return integrate(-0.5, 0.5, 24,
                         [&](double v) { return pair_at_point((ix + u) * dx, (iy + v) * dy)[i][j]; });
      });
  return mean;
}

void expect_closed_forms(const Loaded& file, int imat, int first_iy, int last_iy) {
  const double self = pair_mean(0, 0)[2][2];
  for (int iy = first_iy; iy <= last_iy; ++iy)
    for (int ix = -mx + 1; ix < mx; ++ix) {
      const auto exact = pair_mean(ix, iy);
      for (int ik = 0; ik < 3; ++ik)
        for (int jk = 0; jk < 3; ++jk)
          EXPECT_NEAR(file.c.at({ix, iy, imat, ik, jk}), exact[ik][jk], 1e-4 * self)
              << "ix " << ix << " iy " << iy << " matrix " << imat << " component " << ik << jk;
    }
}

void expect_header(const Loaded& file, int nmatrix) {
  EXPECT_EQ(file.nmatrix, nmatrix);
  EXPECT_EQ(file.convex, 1);
  EXPECT_EQ(file.quasi, 0);
  EXPECT_EQ(file.order, 312);
  EXPECT_EQ(file.symmetric_x, 1);
  EXPECT_EQ(file.symmetric_y, 0);
  EXPECT_EQ(file.mx, mx);
  EXPECT_EQ(file.my, my);
  EXPECT_EQ(file.dx, dx);
  EXPECT_EQ(file.dy, dy);
}

TEST_F(InfluenceCommand, ContactReadsTheClosedFormsOfAPair) {
  const std::string files = path("rail.h5") + " " + path("wheel.h5");
  const Outcome each = expand(files, "--format contact -o " + path("each.txt"));
  ASSERT_EQ(each.code, 0) << each.err;
  const Loaded matrices(folder_ / "each.txt");
  expect_header(matrices, my);
  for (int loaded = 1; loaded <= my; ++loaded)
    expect_closed_forms(matrices, loaded, 1 - loaded, my - loaded);

  ASSERT_EQ(expand(files, "--format contact --matrices one -o " + path("one.txt")).code, 0);
  const Loaded matrix(folder_ / "one.txt");
  expect_header(matrix, 1);
  expect_closed_forms(matrix, 1, 1 - my, my - 1);

  // The couplings are fifty times the tolerance above: a wrong sign would show.
  const double self = matrix.c.at({0, 0, 1, 2, 2});
  EXPECT_LT(matrix.c.at({2, 0, 1, 0, 2}), -0.005 * self); // u_x ahead of a pressure
  EXPECT_GT(matrix.c.at({2, 0, 1, 2, 0}), 0.005 * self);
  EXPECT_LT(matrix.c.at({0, 2, 1, 1, 2}), -0.005 * self);
  EXPECT_GT(matrix.c.at({1, 1, 1, 0, 1}), 0.005 * self);
}

TEST_F(InfluenceCommand, OneMatrixIsRefusedWhereTheCurvatureVaries) {
  InfluenceFunction bent = halfspace_function(rail_material, 8, 0.4, 0.4);
  const std::size_t n = 24;
  for (std::size_t k = 0; k < bent.wavenumber_count(); ++k)
    for (std::size_t a = 0; a < n; ++a)
      bent.kernel[bent.kernel_index(k, a, a)] *= 1 + 0.02 * static_cast<double>(a / 3);
  write_influence_file(folder_ / "bent.h5", bent);
  const std::string files = path("bent.h5") + " " + path("wheel.h5");
  refused(expand(files, "--format contact --matrices one -o " + path("one.txt")),
          {"does not serve this strip", "% of self", "--matrices each"});
  EXPECT_FALSE(std::filesystem::exists(folder_ / "one.txt"));
  EXPECT_EQ(expand(files, "--format contact -o " + path("each.txt")).code, 0);
}

TEST_F(InfluenceCommand, RefusesWhatDoesNotFit) {
  const std::string rail = path("rail.h5"), both = rail + " " + path("wheel.h5");
  refused(expand(rail, "--format contact -o " + path("a.txt")), {"of a pair", "rail's and then the wheel's"});
  refused(expand(rail, "--wheel-centre 1 -o " + path("a.h5")), {"no wheel"});
  refused(expand(rail, "-o " + path("a.dat")), {"neither in .h5 nor in .csv", "--format"});
  refused(expand(rail, "-o " + rail), {"would overwrite"});
  refused(expand(rail, "--centre -1.2 -o " + path("a.h5")), {"leaves the contact strip"});
  refused(expand(both, "--wheel-centre 1.3 -o " + path("a.h5")), {"leaves the contact strip"});
  refused(expand(rail, "--matrices one -o " + path("a.csv")), {"--matrices", "csv"});
  refused(expand(path("none.h5"), "-o " + path("a.h5")), {"none.h5", "cannot be opened"});
  refused(expand(rail, "-o " + path("no/such/folder.csv")), {"cannot be written"});
  refused(run("influence expand " + rail + " --dx 0.1 --ds 0.4 --mx 5 --my 4 -o " + path("a.h5")),
          {"too coarse along x", "dx >= 0.4"});
  refused(run("influence expand " + rail + " --dx 0.5 --ds 0.4 --mx 5 --my 40000 -o " + path("a.h5")),
          {"too large", "GB"});
  refused(run("influence expand " + rail + " --dx nan --ds 0.4 --mx 5 --my 4 -o " + path("a.h5")),
          {"no finite number"});
  for (const auto& entry : std::filesystem::directory_iterator(folder_))
    EXPECT_THAT(entry.path().filename().string(), testing::AnyOf("rail.h5", "wheel.h5", "stdout", "stderr"));
}

/// The folder of the sources has two prepared files.
TEST_F(InfluenceCommand, PreparedFilesAreCopiedByTheNamesOfStandards) {
  const std::string from = " --folder '" CONFORMAL_SOURCE_DIR "/data/influence'";
  const Outcome list = run("influence list" + from);
  EXPECT_EQ(list.code, 0) << list.err;
  EXPECT_THAT(list.out, AllOf(HasSubstr("small_rail.h5: rail 60E1, gauge corner, s = -44 .. -20 mm"),
                              HasSubstr("small_wheel.h5: wheel S1002, flange root")));
  const std::string get = "influence get 'UIC 60' S1002 -o " + path("got") + from;
  for (int time = 0; time < 2; ++time) { // what is there already stays
    const Outcome got = run(get);
    EXPECT_EQ(got.code, 0) << got.err;
    EXPECT_THAT(got.out, HasSubstr("rail.influence = \"" + (folder_ / "got/small_rail.h5").string() + "\""));
    EXPECT_EQ(read_influence_file(folder_ / "got/small_rail.h5").kernel,
              read_influence_file(CONFORMAL_SOURCE_DIR "/data/influence/small_rail.h5").kernel);
  }
  write("got/small_rail.h5", "mine");
  refused(run(get), {"exists and would be replaced"});
  EXPECT_EQ(text_of(folder_ / "got/small_rail.h5"), "mine");
  refused(run("influence get 56E1 -o " + path("none") + from),
          {"56E1", "60E1, S1002", "tools/influence \"56E1\""});
  refused(run("influence get 61E1 -o " + path("none") + from), {"61E1", "Did you mean", "60E1"});
  EXPECT_THAT(run("influence list UIC60 '60 E1'" + from).out,
              testing::Not(HasSubstr("\nsmall_rail"))); // once
  refused(run("influence get 60E1 --strip tread -o " + path("none") + from), {"tread", "gauge corner"});
  refused(run("influence get 60E1 -o " + path("none") + " --folder " + path("nowhere")), {"index.toml"});
  EXPECT_FALSE(std::filesystem::exists(folder_ / "none"));
}

/// What an index says of a body by another of its names, and what is wrong with the second file, is seen
/// before the first is copied.
TEST_F(InfluenceCommand, AFolderByHandIsReadByAnyNameAndCopiedAsAWhole) {
  std::filesystem::copy(CONFORMAL_SOURCE_DIR "/data/influence", folder_ / "own");
  std::string index = text_of(folder_ / "own/index.toml");
  index.replace(index.find("60E1"), 4, "UIC60");
  write("own/index.toml", index);
  const std::string from = " --folder " + path("own");
  EXPECT_EQ(run("influence get 60E1 -o " + path("got") + from).code, 0);
  std::filesystem::resize_file(folder_ / "own/small_wheel.h5", 1000);
  refused(run("influence get 60E1 S1002 -o " + path("none") + from), {"small_wheel.h5", "1000 bytes"});
  EXPECT_FALSE(std::filesystem::exists(folder_ / "none"));
}

TEST_F(InfluenceCommand, PackedFilesAreSmallerAndUsed) {
  const std::string file = CONFORMAL_SOURCE_DIR "/data/influence/small_rail.h5";
  const Outcome packed = run("influence pack '" + file + "' -o " + path("packed.h5"));
  EXPECT_EQ(packed.code, 0) << packed.err;
  EXPECT_LT(3 * std::filesystem::file_size(folder_ / "packed.h5"), std::filesystem::file_size(file));
  EXPECT_EQ(run("info " + path("packed.h5")).code, 0);
  refused(run("influence pack " + path("packed.h5") + " -o " + path("packed.h5")), {"would overwrite"});
  write("foreign.h5", "mine");
  refused(run("influence pack " + path("packed.h5") + " -o " + path("foreign.h5")),
          {"exists", "no influence file"});
  EXPECT_EQ(text_of(folder_ / "foreign.h5"), "mine");
}

TEST_F(InfluenceCommand, HelpHasExamplesThatAreItsOptions) {
  const Outcome help = run("influence --help");
  EXPECT_EQ(help.code, 0);
  const std::string text = help.out + help.err;
  EXPECT_THAT(text, AllOf(HasSubstr("bem_contact influence expand rail.h5 wheel.h5"),
                          HasSubstr("--wheel-centre"), HasSubstr("--format contact")));
}

} // namespace
