#include "bem_contact/app/table_workers.hpp"

#include "bem_contact/app/sweep_workers.hpp"
#include "bem_contact/base/progress.hpp"

#include <cstring>
#include <utility>

namespace bem_contact::app {

namespace {

std::string to_bytes(const table::PointValues& point) {
  std::string out(2 * sizeof(double) * point.values.size(), '\0');
  std::memcpy(out.data(), point.values.data(), out.size() / 2);
  std::memcpy(out.data() + out.size() / 2, point.element_errors.data(), out.size() / 2);
  return out;
}

table::PointValues point_of(const std::string& bytes) {
  table::PointValues out;
  out.values.resize(bytes.size() / 2 / sizeof(double));
  out.element_errors.resize(out.values.size());
  std::memcpy(out.values.data(), bytes.data(), bytes.size() / 2);
  std::memcpy(out.element_errors.data(), bytes.data() + bytes.size() / 2, bytes.size() / 2);
  return out;
}

std::vector<Chunk> chunks_of(std::size_t points) {
  const std::size_t length = chunk_size(points);
  std::vector<Chunk> out;
  for (std::size_t i = 0; i < points; ++i) {
    if (i % length == 0)
      out.emplace_back();
    out.back().push_back(i);
  }
  return out;
}

} // namespace

table::PointsSolver side_by_side(std::function<table::PointSolver()> make, int jobs) {
  return [make = std::move(make), jobs](std::span<const table::Point> points) {
    std::vector<table::PointValues> out(points.size());
    if (points.empty())
      return out;
    Progress progress("contacts", points.size());
    WorkerCalls calls;
    calls.make_solver = [&]() -> CaseSolver {
      return [&, solve = make()](std::size_t index) {
        try {
          return to_bytes(solve(points[index]));
        } catch (const std::exception&) {
          return std::string(); // solved again below, where the error can be thrown
        }
      };
    };
    calls.done = [&](std::size_t index, std::string bytes) {
      out[index] = bytes.empty() ? make()(points[index]) : point_of(bytes);
      progress.step();
    };
    calls.died = [&](std::size_t index, const std::string&) { calls.done(index, ""); };
    solve_in_processes(chunks_of(points.size()), jobs, calls);
    progress.finish();
    return out;
  };
}

} // namespace bem_contact::app
