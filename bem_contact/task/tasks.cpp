#include "bem_contact/task/tasks.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/base/stopped.hpp"
#include "bem_contact/base/temporary_folder.hpp"
#include "bem_contact/sequence/shared_files.hpp"
#include "bem_contact/task/packing.hpp"
#include "bem_contact/uses/conicity/wheelset_conicity.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <functional>
#include <span>
#include <utility>

namespace bem_contact::task {

namespace {

using CreepPoints = std::vector<Creepages>;
using Points = std::vector<table::Point>;

struct CreepAsked {
  SceneText scene{""};
  std::vector<SceneChange> changes;
  HeldContact held;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CreepAsked, scene, changes, held)

std::vector<CreepPoint> creep_points_of(const CreepAsked& asked, const CreepPoints& points,
                                        const std::atomic<bool>* stop) {
  return creep_points(parse_scene_file(asked.scene, asked.changes), asked.held, points, stop);
}

struct ScenePointsAsked {
  SceneText scene{""};
  std::string model;
  std::vector<table::SceneTable::KeyAxis> axes;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ScenePointsAsked, scene, model, axes)

struct CreepTableAsked {
  table::CreepScale scale;
  int elements = 0;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CreepTableAsked, scale, elements)

std::vector<table::PointValues> solve_points(const table::PointSolver& solve, const Points& points,
                                             const std::atomic<bool>* stop) {
  const auto until_stopped = [&](const table::Point& point) {
    end_if_stopped(stop);
    return solve(point);
  };
  return table::one_by_one(until_stopped)(points);
}

std::vector<table::PointValues> scene_points_of(const ScenePointsAsked& asked, const Points& points,
                                                const std::atomic<bool>* stop) {
  return solve_points(table::scene_point_solver({asked.scene, asked.model, asked.axes}), points, stop);
}

std::vector<table::PointValues> creep_table_points_of(const CreepTableAsked& asked, const Points& points,
                                                      const std::atomic<bool>* stop) {
  return solve_points(table::creep_point_solver(asked.scale, asked.elements), points, stop);
}

struct WearAsked {
  SceneText collective{""};
  std::string model, law;
  double hardness = 0, speed = 0;
  wear::WornPair now;
  std::string rail_influence, wheel_influence; ///< files; "": none
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(WearAsked, collective, model, law, hardness, speed, now, rail_influence,
                                   wheel_influence)

std::vector<wear::CaseWear> wear_of(const WearAsked& asked, const CaseRange& some,
                                    const std::atomic<bool>* stop) {
  const std::vector<wear::CollectiveCase> cases =
      wear::collective_of(parse_sweep_file(asked.collective), some, asked.model);
  const wear::EvolutionOptions options{
      .law = wear::law_named(asked.law, asked.hardness, asked.speed, wear::wear_map_of(cases.front().scene)),
      .stop = stop};
  const TemporaryFolder folder;
  wear::write_profiles(asked.now, folder.path());
  return wear::wear_of_cases(asked.now, cases, options, folder.path(),
                             {{asked.rail_influence, {}}, {asked.wheel_influence, {}}});
}

struct MapAsked {
  std::optional<SceneText> scene;
  std::vector<SceneChange> changes;
  ConicityMapRange range;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(MapAsked, scene, changes, range)
using WheelAndRail = std::pair<std::string, std::string>;

std::vector<ConicityMap::Entry> map_entries_of(const MapAsked& asked, const WheelAndRail& pair,
                                               const std::atomic<bool>* stop) {
  ConicityMapRange range = asked.range;
  range.wheels = {pair.first}, range.rails = {pair.second};
  const auto scene_of = [&](const std::string& wheel, const std::string& rail) {
    std::vector<SceneChange> all = asked.changes;
    all.push_back({"wheel.profile", wheel});
    all.push_back({"rail.profile", rail});
    return asked.scene ? parse_scene_file(*asked.scene, all) : scene_without_file(all);
  };
  return conicity_map(
             range, scene_of, [] {}, stop)
      .entries;
}

struct SweepAsked {
  SceneText scene{""};
  std::vector<SceneChange> changes;
  std::string model;

  SharedSweep shared() const { return {scene, changes, model}; }
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SweepAsked, scene, changes, model)
using PartAsked = std::pair<CaseRange, std::string>; ///< and its file; "": none

/// As the program asks for a sweep that it writes. Changes are options.
AskedSweep asked_sweep(const SharedSweep& shared) {
  AskedSweep asked{.scene = shared.scene.source, .sweep = shared.sweep(), .model = shared.model};
  std::string options = shared.model;
  for (const SceneChange& change : shared.changes)
    options += fmt::format(" {} = {}", change.key, to_text(change.value));
  asked.origins = origins_of(asked.sweep, options);
  asked.digest = digest_of(asked.origins);
  return asked;
}

/// Whether a former call has left the part. One that is damaged is solved again.
bool is_there(const AskedSweep& asked, const std::filesystem::path& file) {
  if (!is_regular(file))
    return false;
  try {
    read_part(asked, file);
    return true;
  } catch (const PartFault& fault) {
    if (!fault.damaged)
      throw;
    return false;
  }
}

SweepRows sweep_rows_of(const SweepAsked& asked, const PartAsked& part, const std::atomic<bool>* stop) {
  const SweepFile sweep = asked.shared().sweep();
  std::vector<SweepCase> solved;
  solve_cases(sweep, part.first, {.model = asked.model, .stop = stop}, shared_files(), [&](SweepCase one) {
    solved.push_back(std::move(one));
    return true;
  });
  return rows_of(part.first, solved, columns_of(sweep));
}

/// Writes the file of a part, unless it is there.
bool write_sweep_part(const SweepAsked& asked, const PartAsked& part, const std::atomic<bool>* stop) {
  const AskedSweep sweep = asked_sweep(asked.shared());
  if (!is_there(sweep, part.second))
    solve_part(
        sweep, part.first, part.second, [] {}, stop);
  return true;
}

constexpr Task creep_points_task{"creep points", Packed<creep_points_of>::run},
    scene_points_task{"points of a table", Packed<scene_points_of>::run},
    creep_table_task{"points of a table of creep forces", Packed<creep_table_points_of>::run},
    wear_task{"wear of cases", Packed<wear_of>::run},
    map_task{"conicities of a pair", Packed<map_entries_of>::run},
    sweep_task{"cases of a sweep", Packed<sweep_rows_of>::run},
    sweep_file_task{"file of cases of a sweep", Packed<write_sweep_part>::run};

constexpr const Task* all_tasks[] = {&creep_points_task, &scene_points_task, &creep_table_task, &wear_task,
                                     &map_task,          &sweep_task,        &sweep_file_task};

/// How much work there is, and what is told of it.
struct Items {
  std::size_t count = 0;
  std::function<std::string(std::size_t)> name; ///< of an item: "A point ..., from (1, 2) on,"
  Done done = nullptr;
};

/// Cuts items into portions and gives the answers, one an item. `ask`: what a range of items is asked.
template <class Answer, class Common, class Ask>
std::vector<Answer> answers(const Engine& engine, const Task& task, const Items& items, const Common& common,
                            const Ask& ask) {
  const std::size_t length = chunk_size(items.count);
  std::vector<Answer> out(items.count);
  Portions all{.task = task,
               .common = pack(common),
               .name = [&](std::size_t i) { return items.name(i * length); },
               .take =
                   [&](std::size_t i, const std::string& answer) {
                     auto some = unpack<std::vector<Answer>>(answer);
                     std::ranges::move(some, out.begin() + static_cast<std::ptrdiff_t>(i * length));
                     if (items.done)
                       items.done(some.size());
                   }};
  for (std::size_t first = 0; first < items.count; first += length)
    all.asked.push_back(pack(ask(CaseRange{first, std::min(items.count, first + length)})));
  engine(all);
  return out;
}

/// What portions of a list are asked.
template <class Item> auto parts_of(std::span<const Item> items) {
  return [items](CaseRange some) {
    const auto part = items.subspan(some.first, some.size());
    return std::vector<Item>(part.begin(), part.end());
  };
}

/// For a process that may work in another folder; "": no file.
std::string absolute_or_none(const std::filesystem::path& file) {
  return file.empty() ? "" : std::filesystem::absolute(file).string();
}

template <class Asked>
table::PointsSolver table_points_by(Engine engine, const Task& task, Asked asked, Done done) {
  return [=, &task](std::span<const table::Point> points) {
    const auto name = [&](std::size_t i) {
      return fmt::format("A point of the table, from ({:.6g}) on,", fmt::join(points[i], ", "));
    };
    return answers<table::PointValues>(engine, task, {points.size(), name, done}, asked, parts_of(points));
  };
}

/// Of whole chunks, so that what is found is what one process finds.
std::vector<CaseRange> portions_of(const SweepFile& sweep, const SharedSweep& asked) {
  const std::size_t cases = sweep.size(), chunk = cut_of(sweep, asked.model, *shared_files()).chunk,
                    chunks = (cases + chunk - 1) / chunk,
                    size = chunk * ((chunks + asked.portions - 1) / asked.portions);
  std::vector<CaseRange> out;
  for (std::size_t first = 0; first < cases; first += size)
    out.push_back({first, std::min(cases, first + size)});
  return out;
}

} // namespace

const Task& task_named(std::string_view name) {
  for (const Task* task : all_tasks)
    if (task->name == name)
      return *task;
  throw Error(fmt::format("There is no task '{}'", name), "it was asked by another version",
              "Use one version everywhere.");
}

CreepSolver creep_points_by(Engine engine, SceneText scene, std::vector<SceneChange> changes) {
  return [=](const HeldContact& held, std::span<const Creepages> points) {
    const auto name = [&](std::size_t i) {
      return fmt::format("A point of the creep curves, from xi = {:g}, eta = {:g}, phi = {:g} on,",
                         points[i][0], points[i][1], points[i][2]);
    };
    return answers<CreepPoint>(engine, creep_points_task, {points.size(), name},
                               CreepAsked{scene, changes, held}, parts_of(points));
  };
}

table::PointsSolver points_by(Engine engine, table::SceneTable order, Done done) {
  return table_points_by(std::move(engine), scene_points_task,
                         ScenePointsAsked{order.text, order.model, order.axes}, std::move(done));
}

table::PointsSolver points_by(Engine engine, table::CreepScale scale, int elements, Done done) {
  return table_points_by(std::move(engine), creep_table_task, CreepTableAsked{std::move(scale), elements},
                         std::move(done));
}

wear::CasesSolver wear_by(Engine engine, const SweepFile& collective, std::string model,
                          const wear::StudyOptions& asked) {
  return [=, text = collective.text, count = collective.size(), law = asked.law, hardness = asked.hardness,
          speed = asked.speed](const wear::WornPair& now, const wear::KeptPair& influence) {
    const auto name = [](std::size_t i) {
      return fmt::format("A case of the load collective, from number {} on,", i + 1);
    };
    const WearAsked common{text,
                           model,
                           law,
                           hardness,
                           speed,
                           now,
                           absolute_or_none(influence.rail.file),
                           absolute_or_none(influence.wheel.file)};
    return answers<wear::CaseWear>(engine, wear_task, {count, name}, common, std::identity());
  };
}

ConicityMap conicity_map_by(const Engine& engine, const std::optional<SceneText>& scene,
                            const std::vector<SceneChange>& changes, const ConicityMapRange& range) {
  ConicityMap map{.wheels = range.wheels,
                  .rails = range.rails,
                  .amplitude = range.amplitude,
                  .scatter = range.scatter,
                  .entries = {}};
  std::vector<std::vector<ConicityMap::Entry>> pairs(map.wheels.size() * map.rails.size());
  Portions all{.task = map_task,
               .common = pack(MapAsked{scene, changes, range}),
               .name = [&](std::size_t i) { return fmt::format("Pair {} of the map", i + 1); },
               .take =
                   [&](std::size_t i, const std::string& answer) {
                     pairs[i] = unpack<std::vector<ConicityMap::Entry>>(answer);
                     for (ConicityMap::Entry& entry : pairs[i])
                       entry.wheel = i / map.rails.size(), entry.rail = i % map.rails.size();
                   }};
  for (const std::string& wheel : map.wheels)
    for (const std::string& rail : map.rails)
      all.asked.push_back(pack(WheelAndRail{wheel, rail}));
  engine(all);
  for (const std::vector<ConicityMap::Entry>& pair : pairs)
    map.entries.insert(map.entries.end(), pair.begin(), pair.end());
  return map;
}

SweepFile SharedSweep::sweep() const {
  SweepFile out = parse_sweep_file(scene);
  for (const SceneChange& change : changes) {
    if (std::ranges::count(out.axes, change.key, &SweepFile::Axis::key) > 0)
      throw InputError("The change of " + change.key + " cannot be made",
                       "the sweep gives it a value in each case", "Leave it out, or take it out of [sweep].");
    out.axes.push_back({change.key, {change.value}});
  }
  return out;
}

AllSweepRows sweep_by(const Engine& engine, const SharedSweep& asked, const Done& done) {
  const SweepFile sweep = asked.sweep();
  const std::vector<CaseRange> ranges = portions_of(sweep, asked);
  const bool files = !asked.folder.empty();
  if (files)
    make_folder(asked.folder);
  AllSweepRows rows;
  Portions all{
      .task = files ? sweep_file_task : sweep_task,
      .common = pack(SweepAsked{asked.scene, asked.changes, asked.model}),
      .name = [&](std::size_t i) { return fmt::format("A case from number {} on", ranges[i].first + 1); },
      .take =
          [&](std::size_t i, const std::string& answer) {
            if (!files)
              rows[ranges[i].first] = unpack<SweepRows>(answer);
            if (done)
              done(ranges[i].size());
          }};
  const auto file = [&](CaseRange cases) {
    return files ? (asked.folder / fmt::format("{}-{}.h5", cases.first, cases.last)).string() : std::string();
  };
  for (const CaseRange& cases : ranges)
    all.asked.push_back(pack(PartAsked{cases, file(cases)}));
  engine(all);
  if (files) {
    const AskedSweep written = asked_sweep(asked);
    for (const CaseRange& cases : ranges)
      rows[cases.first] = read_rows(read_part(written, file(cases)), written.columns());
  }
  return rows;
}

} // namespace bem_contact::task
