// Asks every room above `sequence` one question about scenes of a folder, and prints a name and a number for
// each.
#include <bem_contact/base/error.hpp>
#include <bem_contact/scene/scene_file.hpp>
#include <bem_contact/sequence/sequence.hpp>
#include <bem_contact/sequence/shared_files.hpp>
#include <bem_contact/uses/conicity/wheelset_conicity.hpp>
#include <bem_contact/uses/curves/creep_curves.hpp>
#include <bem_contact/uses/fatigue/fatigue_of_result.hpp>
#include <bem_contact/uses/sweep/sweep_columns.hpp>
#include <bem_contact/uses/table/creep_table.hpp>
#include <bem_contact/uses/table/table_file.hpp>
#include <bem_contact/uses/wear/wear_of_result.hpp>
#include <bem_contact/uses/wheelset/solve_wheelset.hpp>

#include <cstdio>

using namespace bem_contact;

namespace {

void print(const char* name, double value) {
  std::printf("%s %.9g\n", name, value);
}

void answer(const std::filesystem::path& scenes) {
  const SceneFile axle = read_scene_file(scenes / "wheelset.toml"),
                  rolling = read_scene_file(scenes / "steady_rolling.toml");
  print("tan_gamma_3mm", wheelset_conicity(wheelset_of(axle)).values.at(2).motion.value().tan_gamma);
  print("axle_Fy", solve_wheelset(axle).state.sum().force[1]);
  const SweepFile sweep = read_sweep_file(scenes / "wheelset_sweep.toml");
  solve_cases(sweep, {4, 5}, {}, shared_files(), [](const SweepCase& middle) {
    print("case_status", static_cast<double>(middle.status));
    return true;
  });

  const CreepRange range{CreepKind::xi, {0, 1e-2}};
  const CreepCurves curves = creep_curves(rolling, {&range, 1});
  print("slope_over_kalker", curves.slopes.values[0][0] / curves.linear.value().slopes[0][0]);

  const SceneResult result = Sequence().solve(rolling);
  const wear::Wear worn = wear::wear_of(result, wear::EnergyLaw{});
  print("volume_over_section", worn.volume_per_distance / worn.rail.area());
  print("p0_over_k", fatigue::fatigue_of(result, {.yield_shear = 100}).patches.at(0).point.load);

  const table::ContactTable creep = table::creep_table({.elements = 8});
  const double full_slip = 1; // t of creep_table.hpp
  print("full_slip_Fx", table::creep_point_solver(creep.scale.value(), 8)({0, full_slip, 0, 0}).values.at(0));
  print("table_datasets", static_cast<double>(record_of(creep).entries().size()));
}

} // namespace

int main(int argc, char** argv) {
  try {
    answer(argc > 1 ? argv[1] : "");
  } catch (const Error& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 1;
  }
}
