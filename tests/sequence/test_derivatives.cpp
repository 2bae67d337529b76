// Derivatives of results against central differences of whole solutions on the same elements.
#include "bem_contact/sequence/numbers/sequence_files.hpp"
#include "bem_contact/sequence/plan/contact_case.hpp"
#include "bem_contact/sequence/quantities.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "bem_contact/sequence/solution/derivatives_of.hpp"
#include "bem_contact/sequence/solution/grow_grid.hpp"
#include "bem_contact/sequence/solution/profile_changes.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/standard_profiles.hpp"
#include "bem_contact/scene/derivative_inputs.hpp"
#include "tests/base/temporary_folder.hpp"
#include "tests/sanitized.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <random>
#include <utility>

namespace bem_contact {
namespace {

using testing::HasSubstr;

/// The numbers that have derivatives, of one solution; of patches in their order.
struct Numbers {
  std::map<std::string, double> all;
  std::vector<ElementState> states;
  std::vector<double> pressure; ///< field
};

/// A case on the elements of its first solution.
class HeldGrid {
public:
  explicit HeldGrid(const SceneFile& scene, Model model)
      : asked_(prepare_case(scene, files_)), model_(model) {
    ContactCase known = has_files(model) ? with_influence(asked_, files_) : asked_;
    asked_ = known;
    solved_ = solve_on_growing_grid(asked_, asked_.setup.on(first_plan(asked_, scene.grid, has_files(model))),
                                    {model}, {.work = work_}, has_files(model));
  }

  const GridSolution& solved() const { return solved_; }
  std::vector<InputDerivatives> derivatives() {
    WorkBudget work;
    return derivatives_of(asked_, solved_, {.work = work}).numbers;
  }
  std::vector<ProfileDerivatives> profiles() {
    WorkBudget work;
    return derivatives_of(asked_, solved_, {.work = work}).profiles;
  }
  /// The whole solutions where one point of a profile is moved to both sides, and by how much.
  struct Sides {
    Numbers lower, upper;
    double step;
  };
  Sides at_point(std::size_t which) {
    const ChangedContact changed = ProfileChanges(asked_, solved_).changed(which);
    return {solved_again(changed.lower_case), solved_again(changed.upper_case), changed.step};
  }
  /// The whole solution with another value of a number.
  Numbers at(int which, double change) {
    SceneFile scene = asked_.scene;
    *derivative_inputs(scene)[std::size_t(which)].value += change;
    ContactCase moved = prepare_case(scene, files_);
    moved.files = asked_.files;
    return solved_again(moved);
  }
  Numbers here() { return numbers_of(asked_, solved_); }

private:
  static bool has_files(Model model) { return model == Model::fem; }
  Numbers solved_again(const ContactCase& moved) {
    WorkBudget work;
    GridSolution there = solve_on_grid(moved, moved.setup.on(solved_.contact.plan), {model_}, {.work = work});
    EXPECT_TRUE(there.result.certified());
    return numbers_of(moved, there);
  }
  static Numbers numbers_of(const ContactCase& asked, const GridSolution& solved) {
    SceneResult r;
    r.problem = solved.contact.problem;
    r.result = solved.result;
    r.motion.reference = asked.setup.reference();
    if (const WheelRailGeometry* placed = asked.setup.wheel_rail())
      r.motion.lowered = placed->lowered;
    r.moment = moment_about(r.motion.reference, r.result);
    Numbers out;
    for (const std::string_view name : derived_totals())
      out.all[std::string(name)] = quantity(name).value(r);
    for (std::size_t patch = 0; patch < r.result.patches.size(); ++patch)
      for (const std::string_view name : derived_patch_numbers())
        out.all[fmt::format("{}.{}", patch, name)] = named(patch_quantities(), name).value(r, patch);
    out.states = r.result.state;
    out.pressure = r.result.pn;
    return out;
  }

  SequenceFiles files_;
  WorkBudget work_;
  ContactCase asked_;
  Model model_;
  GridSolution solved_;
};

std::map<std::string, double> by_name(const InputDerivatives& d) {
  std::map<std::string, double> out;
  for (std::size_t k = 0; k < d.totals.size(); ++k)
    out[std::string(derived_totals()[k])] = d.totals[k];
  for (std::size_t patch = 0; patch < d.patches.size(); ++patch)
    for (std::size_t k = 0; k < d.patches[patch].size(); ++k)
      out[fmt::format("{}.{}", patch, derived_patch_numbers()[k])] = d.patches[patch][k];
  return out;
}

std::string kind_of(std::string name) {
  if (const auto dot = name.find('.'); dot != std::string::npos)
    name = name.substr(dot + 1);
  return name.front() == 'F' ? "F" : name.front() == 'M' ? "M" : name;
}

/// What one comparison found.
struct Compared {
  int smooth = 0, bent = 0; ///< inputs without a change of state nearby, and others
  double worst = 0;         ///< over the largest derivative of the kind, of the smooth ones
  std::string worst_name;
  double outside = 0; ///< the same of the bent ones: how far outside of both one-sided differences
  std::string outside_name;
};

/// 1, over the largest derivative of its kind: what derivatives may be off by.
constexpr double within = 1e-5;

/// Differences of whole solutions to both sides. Those to one side miss a curved function by half of its
/// curvature times the step, which half of the step tells: wheels on flanges and with influence files are
/// curved so much that the approach's slope changes by 2 % within 4e-7 rad of roll.
class Differences {
public:
  Differences(HeldGrid& held, int which, double step)
      : here_(held.here()), step_(step), lower_(held.at(which, -step)), upper_(held.at(which, step)) {}
  /// Before one_sided() is asked.
  void take_half_steps(HeldGrid& held, int which) {
    half_lower_ = held.at(which, -0.5 * step_);
    half_upper_ = held.at(which, 0.5 * step_);
  }

  bool keep_states() const { return lower_.states == here_.states && upper_.states == here_.states; }
  /// Another element has the largest pressure on one side: there pmax bends.
  bool peak_moves() const {
    const auto peak = [](const Numbers& n) {
      return std::ranges::max_element(n.pressure) - n.pressure.begin();
    };
    return peak(lower_) != peak(upper_) || peak(lower_) != peak(here_);
  }
  double central(const std::string& name) const {
    return (upper_.all.at(name) - lower_.all.at(name)) / (2 * step_);
  }
  /// How far the third derivative puts the central one off, by half of the step.
  double error_of_central(const std::string& name) const {
    return 4.0 / 3 * std::abs(central(name) - (half_upper_.all.at(name) - half_lower_.all.at(name)) / step_);
  }
  /// To both sides, in rising order, with and without the curvature taken out: the latter where a state
  /// changes within half of the step.
  std::pair<double, double> one_sided(const std::string& name) const {
    const double here = here_.all.at(name), below = (here - lower_.all.at(name)) / step_,
                 above = (upper_.all.at(name) - here) / step_,
                 near_below = (here - half_lower_.all.at(name)) / (0.5 * step_),
                 near_above = (half_upper_.all.at(name) - here) / (0.5 * step_);
    return std::minmax({below, above, 2 * near_below - below, 2 * near_above - above});
  }

private:
  Numbers here_;
  double step_;
  Numbers lower_, upper_, half_lower_, half_upper_;
};

/// The largest derivative of each kind of number, or what changes a number by a millionth within a step: less
/// is noise of the differences.
std::map<std::string, double> scales_of(const std::map<std::string, double>& derivatives, const Numbers& here,
                                        double step) {
  std::map<std::string, double> out;
  for (const auto& [name, value] : derivatives)
    if (!std::isnan(value))
      out[kind_of(name)] =
          std::max({out[kind_of(name)], std::abs(value), 1e-6 * std::abs(here.all.at(name)) / step});
  return out;
}

/// Each derivative of a scene against differences.
Compared compare(const SceneFile& scene, Model model = Model::halfspace) {
  HeldGrid held(scene, model);
  EXPECT_TRUE(held.solved().result.certified());
  Compared out;
  const std::vector<InputDerivatives> all = held.derivatives();
  for (std::size_t k = 0; k < all.size(); ++k) {
    const InputDerivatives& d = all[k];
    SceneFile looked_at = scene;
    // the same step as that of the geometry's differences, so that these are off by as much
    const double unit = derivative_inputs(looked_at)[k].step;
    const bool foreseen = std::min(d.below, d.above) < 2 * unit; // it says that the solution bends here
    Differences differences(held, int(k), foreseen ? 4 * unit : unit);
    const bool smooth = !foreseen && differences.keep_states();
    if (!smooth || differences.peak_moves())
      differences.take_half_steps(held, int(k));
    ++(smooth ? out.smooth : out.bent);
    const std::map<std::string, double> found = by_name(d), scales = scales_of(found, held.here(), unit);
    for (const auto& [name, value] : found) {
      if (std::isnan(value))
        continue;
      const double scale = scales.at(kind_of(name));
      const bool bends = !smooth || (kind_of(name) == "pmax" && differences.peak_moves());
      const auto outside = [&](std::pair<double, double> ends) {
        return std::max({ends.first - value, value - ends.second, 0.0});
      };
      double off =
          (bends ? outside(differences.one_sided(name)) : std::abs(value - differences.central(name))) /
          scale;
      if (!bends && off > within) {
        differences.take_half_steps(held, int(k));
        off = std::max(off - differences.error_of_central(name) / scale, 0.0);
      }
      if (double& worst = bends ? out.outside : out.worst; off > worst) {
        worst = off;
        (bends ? out.outside_name : out.worst_name) = d.name + " " + name;
      }
    }
  }
  return out;
}

const std::string pair = "rail.profile = '60E1'\nwheel.profile = 'S1002'\nload.force = 1e5\n"
                         "grid = { dx = 0.8, ds = 0.8 }\nsolver.tolerance = 1e-12\n";

SceneFile patch_scene(const std::string& more) {
  return parse_scene_file(
      "kind = 'patch'\nload.force = 8e3\nsolver.tolerance = 1e-12\n"
      "grid = { dx = 0.3, ds = 0.3, mx = 32, ms = 36 }\ngap = { a = 1.1e-3, b = 0.9e-3, c = 2e-4 }\n" +
      more);
}

double derivative(const SceneResult& r, const std::string& input, const std::string& name) {
  const auto found = std::ranges::find(r.derivatives, input, &InputDerivatives::name);
  return found == r.derivatives.end() ? std::nan("") : by_name(*found).at(name);
}

/// Tractions, approach and forces are in proportion to load, undeformed distance and creepages together. So
/// by Euler's theorem each number is the sum of its derivatives times what they are by. No differences.
TEST(Derivatives, AddUpByEulersTheorem) {
  const SceneResult r = Sequence().solve(
      patch_scene("motion = { xi = 4e-4, eta = -2e-4, phi = 1e-4, friction = 0.3 }\n"
                  "derivatives = ['load', 'xi', 'eta', 'phi', 'gap_a', 'gap_b', 'gap_c']\n"));
  ASSERT_TRUE(r.result.certified());
  ASSERT_GT(count_elements(r.result).slip, 20);
  ASSERT_GT(count_elements(r.result).adhesion, 20);
  const std::map<std::string, double> at{{"load", 8e3},     {"xi", 4e-4},      {"eta", -2e-4}, {"phi", 1e-4},
                                         {"gap_a", 1.1e-3}, {"gap_b", 0.9e-3}, {"gap_c", 2e-4}};
  for (const auto& [name, degree] :
       {std::pair{"Fx", 1}, {"Fy", 1}, {"Fz", 1}, {"Mz", 1}, {"approach", 1}, {"pmax", 1}, {"T_gamma", 2}}) {
    double sum = 0;
    for (const auto& [input, value] : at)
      sum += value * derivative(r, input, name);
    EXPECT_NEAR(sum / (degree * quantity(name).value(r)), 1, 1e-7) << name;
  }
}

/// Hertz: the approach grows with the force's power 2/3, the pressure with 1/3; elements add some percent.
TEST(Derivatives, OfTheLoadAreHertzs) {
  const SceneResult r = Sequence().solve(
      patch_scene("motion.frictionless = true\nsolver.model = 'halfspace'\nderivatives = ['load']\n"));
  EXPECT_NEAR(derivative(r, "load", "approach") * 8e3 / r.result.totals.approach, 2.0 / 3, 0.01);
  EXPECT_NEAR(derivative(r, "load", "pmax") * 8e3 / r.result.totals.pmax, 1.0 / 3, 0.03);
  EXPECT_NEAR(derivative(r, "load", "Fz"), 1, 1e-9);
}

TEST(Derivatives, AreRefusedWithAReason) {
  const auto refusal = [](const std::string& more) {
    try {
      Sequence().solve(patch_scene(more));
      return std::string("solved");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
  };
  const std::string by_load = "derivatives = ['load']\n";
  EXPECT_THAT(refusal(by_load + "motion = { kind = 'shift', xi = 1e-4 }\n"), HasSubstr("history"));
  EXPECT_THAT(refusal(by_load + "motion = { xi = 1e-3, kinetic_friction = 0.2 }\n"),
              HasSubstr("kinetic_friction"));
  EXPECT_THAT(
      refusal(by_load +
              "motion = { xi = 1e-3, speed = 1e4, falling_friction = 0.2, half_slip_velocity = 500 }\n"),
      HasSubstr("friction falls with the slip velocity"));
  EXPECT_THAT(refusal(by_load + "motion.xi = 1e-3\nlayer = { yield_shear = 100, hardening = 1e3 }\n"),
              HasSubstr("hardens or softens"));
  EXPECT_THAT(refusal(by_load + "motion.frictionless = true\nsolver.model = 'hertz'\n"),
              HasSubstr("closed form"));
  EXPECT_THAT(refusal("derivatives = ['lateral']\n"), HasSubstr("'lateral'"));
  EXPECT_THAT(refusal("derivatives = ['rail_profile']\n"), HasSubstr("a patch has no profiles"));
  EXPECT_THAT(refusal("derivatives = ['laod']\n"), HasSubstr("Did you mean \"load\"?"));
  EXPECT_THAT(refusal("derivatives = ['friction']\nmotion.frictionless = true\n"), HasSubstr("'friction'"));
  try {
    Sequence().solve(parse_scene_file(
        by_load +
        "wheel.profile = 'S1002'\nload.force = 1e4\nmotion.friction = 0.3\nsolver.model = 'halfspace'\n"
        "rail.sections = [{ at = 0, profile = '60E1' }, { at = 300, profile = '54E1' }]\n"
        "position.along = 100\n"));
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("changes along the track"));
  }
}

TEST(Derivatives, OnTheTread) {
  NEEDS_NO_SANITIZER();
  const Compared c = compare(parse_scene_file(
      pair + "position.lateral = 1.3\nmotion = { xi = 1e-3, eta = 5e-4, phi = 1e-4 }\n"
             "derivatives = ['load', 'lateral', 'yaw', 'roll', 'xi', 'eta', 'phi', 'friction']\n"));
  EXPECT_LT(c.worst, 1e-5) << c.worst_name;
  EXPECT_LT(c.outside, 1e-3) << c.outside_name;
  EXPECT_GE(c.smooth, 6);
}

/// A file with points of a standard, `step` mm apart.
std::string points_file(const TemporaryFolder& folder, const std::string& standard, double step) {
  const std::string file = folder.path() / (standard + ".csv");
  std::ofstream out(file);
  for (const CurvePoint& p : points_along(standard_profile(standard), step))
    out << fmt::format("{:.9f},{:.9f}\n", p.position.y, p.position.z);
  return file;
}

/// Every point of rail and wheel that is near, against whole solutions with this point moved.
TEST(Derivatives, OfThePointsOfProfilesAreThoseOfDifferences) {
  NEEDS_NO_SANITIZER();
  const TemporaryFolder folder;
  HeldGrid held(parse_scene_file(fmt::format(
                    "rail.profile = '{}'\nwheel.profile = '{}'\nload.force = 8e4\nposition.lateral = 1.3\n"
                    "motion = {{ xi = 1e-3, eta = 5e-4, phi = 1e-4 }}\ngrid = {{ dx = 1, ds = 1 }}\n"
                    "solver.tolerance = 1e-12\nderivatives = ['rail_profile', 'wheel_profile']\n",
                    points_file(folder, "60E1", 2), points_file(folder, "S1002", 2))),
                Model::halfspace);
  const std::vector<ProfileDerivatives> found = held.profiles();
  ASSERT_EQ(found.size(), 2U);
  std::size_t which = 0;
  for (const ProfileDerivatives& profile : found) {
    std::vector<double> largest(derived_totals().size(), 0.0);
    for (const InputDerivatives& d : profile.by_point)
      for (std::size_t n = 0; n < largest.size(); ++n)
        largest[n] = std::max(largest[n], std::abs(d.totals[n]));
    int compared = 0;
    double sum = 0;
    for (const InputDerivatives& d : profile.by_point) {
      if (d.patches.empty()) // far away
        continue;
      const HeldGrid::Sides sides = held.at_point(which++);
      if (std::min(d.below, d.above) < 2 * sides.step)
        continue;
      ++compared;
      for (std::size_t n = 0; n < largest.size(); ++n) {
        const std::string name(derived_totals()[n]);
        const double noise = 1e-11 * std::abs(sides.upper.all.at(name)) / sides.step,
                     difference = (sides.upper.all.at(name) - sides.lower.all.at(name)) / (2 * sides.step);
        if (largest[n] > 0) {
          EXPECT_NEAR(d.totals[n], difference, 1e-5 * largest[n] + noise) << profile.name << " " << name;
        }
      }
      sum += d.totals[7];
    }
    EXPECT_GE(compared, 15) << profile.name;
    EXPECT_NE(sum, 0);
  }
}

/// A random scene, with the model that solves it.
struct RandomCase {
  std::string scene;
  Model model = Model::halfspace;
};

/// From tread to flange, with two patches, spin, unlike materials, a layer, influence files, prescribed shear
/// forces; and a few inputs of each.
RandomCase random_case(unsigned seed) {
  std::mt19937 random(seed);
  const auto between = [&](double from, double to) {
    return from + (to - from) * std::uniform_real_distribution<>()(random);
  };
  RandomCase out;
  std::vector<std::string> inputs{"load", "lateral", "yaw", "roll", "xi", "eta", "phi", "friction"};
  std::string& scene = out.scene;
  const int kind = int(seed % 10);
  double from = -4, to = 5; // mm, on the tread
  if (kind == 1 || kind == 2)
    from = 6.75, to = 7.4; // on the flange
  if (kind == 3)
    from = 6.68, to = 6.74; // two patches
  if (kind == 4)
    scene += "rail.material = { shear_modulus = 4e4, poisson = 0.3 }\n";
  if (kind == 5) {
    scene += fmt::format("layer = {{ compliance = {}, yield_shear = {} }}\n", between(1e-5, 1e-4),
                         between(100, 250));
    inputs.insert(inputs.end(), {"compliance", "yield_shear"});
  }
  if (kind == 6) {
    scene += fmt::format("load.force_x = {}\n", between(-8e3, 8e3));
    inputs.push_back("force_x");
  }
  if (kind == 7) {
    scene += fmt::format("load.force_s = {}\n", between(-6e3, 6e3));
    inputs.push_back("force_s");
  }
  if (kind == 8)
    out.model = Model::tangent_plane;
  if (kind == 9) {
    const std::string folder = CONFORMAL_SOURCE_DIR "/data/influence/";
    scene +=
        fmt::format("rail.influence = '{0}small_rail.h5'\nwheel.influence = '{0}small_wheel.h5'\n", folder);
    out.model = Model::fem;
    from = 6.3, to = 6.65;
  }
  std::ranges::shuffle(inputs, random);
  inputs.resize(3);
  scene += fmt::format("rail.profile = '60E1'\nwheel.profile = 'S1002'\nload.force = {}\n"
                       "position = {{ lateral = {}, yaw = {}, roll = {} }}\n"
                       "motion = {{ xi = {}, eta = {}, phi = {}, friction = {} }}\n"
                       "grid = {{ dx = {}, ds = {} }}\nsolver.tolerance = 1e-12\nderivatives = '{}'\n",
                       between(4e4, 1.2e5), between(from, to), between(-0.01, 0.01), between(-1e-3, 1e-3),
                       between(-3e-3, 3e-3), between(-3e-3, 3e-3), between(-5e-4, 5e-4), between(0.15, 0.5),
                       kind == 9 ? 1.0 : between(0.8, 1.2), kind == 9 ? 1.0 : between(0.6, 1),
                       fmt::join(inputs, ", "));
  return out;
}

/// From DERIVATIVES_FIRST on DERIVATIVES_CASES of them, in tools/benchmarks/derivatives.
TEST(Derivatives, OfRandomCasesAreThoseOfDifferences) {
  const auto given = [](const char* name, int usual) {
    const char* text = std::getenv(name);
    return text ? std::atoi(text) : usual;
  };
  const int first = given("DERIVATIVES_FIRST", 1),
            cases = given("DERIVATIVES_CASES", tests::sanitized ? 10 : 30); // one of each kind, or three
  int smooth = 0, bent = 0, refused = 0;
  double worst = 0, outside = 0;
  for (int seed = first; seed < first + cases; ++seed) {
    const RandomCase one = random_case(unsigned(seed));
    try {
      const Compared c = compare(parse_scene_file(one.scene), one.model);
      smooth += c.smooth;
      bent += c.bent;
      worst = std::max(worst, c.worst);
      outside = std::max(outside, c.outside);
      EXPECT_LT(c.worst, within) << seed << ": " << c.worst_name << "\n" << one.scene;
      EXPECT_LT(c.outside, 1e-3) << seed << ": " << c.outside_name << "\n" << one.scene;
    } catch (const Error& error) {
      ++refused;
      ADD_FAILURE() << seed << ": " << error.what() << "\n" << one.scene;
    }
  }
  fmt::print(
      "{} cases: {} inputs without a change of state nearby, worst {:.1e}; {} with one, at most {:.1e} "
      "outside of both one-sided differences; {} refused\n",
      cases, smooth, worst, bent, outside, refused);
  if (cases >= 10) { // one of each kind
    EXPECT_GT(smooth, 10 * bent);
  }
}

} // namespace
} // namespace bem_contact
