#include "bem_contact/app/from_contact/solved_cases.hpp"

#include "bem_contact/app/from_contact/histories.hpp"
#include "bem_contact/app/from_contact/scene_text.hpp"
#include "bem_contact/base/temporary_folder.hpp"
#include "bem_contact/scene/scene_file.hpp"
#include "bem_contact/sequence/sequence.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace bem_contact::app::from_contact {

namespace {

/// Solves the case's scene. Throws InputError and ConvergenceError as Sequence::solve(), and ConvergenceError
/// where the result is not certified.
SceneResult solve(const ContactCase& one) {
  const TemporaryFolder folder;
  for (const SceneTableFile& table : tables_of_case(one))
    folder.write(name_of_table("scene", table), table.text);
  const SceneFile scene =
      parse_scene_file({scene_of_case(one, "scene", folder.path(), "scene"), "scene.toml", folder.path()});
  SceneResult result = Sequence().solve(scene);
  if (!certified(result))
    throw ConvergenceError("it is not certified", "no solution was found within the bounds", "");
  return result;
}

bool equal_half_spaces(const ContactCase& one) {
  const auto bulk = [&](const char* body) {
    return (1 - 2 * one.number(fmt::format("{}.material.poisson", body))) /
           one.number(fmt::format("{}.material.shear_modulus", body));
  };
  const double rail = bulk("rail"), wheel = bulk("wheel");
  return one.keys.at("solver.model") == "\"halfspace\"" &&
         std::abs(rail - wheel) <= 1e-6 * std::max(rail, wheel);
}

/// The normal problem of the case alone.
ContactCase without_friction(const ContactCase& one) {
  ContactCase out = one;
  std::erase_if(out.keys, [](const auto& entry) {
    return entry.first.starts_with("motion.") || entry.first.starts_with("temperature.") ||
           entry.first == "load.force_x" || entry.first == "load.force_s" ||
           (entry.first.starts_with("layer.") && entry.first != "layer.normal_compliance");
  });
  std::erase_if(out.tables, [](const auto& table) { return table.key.starts_with("motion."); });
  out.set_text("motion.kind", "steady");
  out.set("motion.frictionless", "true");
  if (out.gap_x) // where on the grid it lies does not matter
    out.gap_x = out.grid->x;
  return out;
}

/// The tractions of one element as a line of the table.
std::string line_of(const Tractions& p, const PatchGrid& from, const PatchGrid& to, std::size_t i,
                    std::size_t j) {
  const double column =
      from.sign() * (to.contact_x(i) - from.x) / from.dx + 0.5 * (static_cast<double>(from.mx) - 1);
  const double row =
      from.sign() * (to.contact_y(j) - from.y) / from.ds + 0.5 * (static_cast<double>(from.ms) - 1);
  const auto near = [](double k, std::size_t count) {
    return k > -0.5 && k < static_cast<double>(count) - 0.5;
  };
  if (!near(column, from.mx) || !near(row, from.ms))
    return fmt::format("{},{},0,0,0{}\n", i, j, p.plastic.empty() ? "" : ",0");
  const auto k =
      static_cast<std::size_t>(std::lround(row)) * from.mx + static_cast<std::size_t>(std::lround(column));
  const double turn = from.sign() * to.sign();
  return fmt::format("{},{},{:.17g},{:.17g},{:.17g}{}\n", i, j, turn * p.px[k], turn * p.ps[k], p.pn[k],
                     p.plastic.empty() ? "" : fmt::format(",{:.17g}", p.plastic[k]));
}

} // namespace

void SolvedCases::set_forces(ContactCase& one) {
  if ((!one.share_x && !one.share_s) || !one.refused.empty())
    return;
  if (!equal_half_spaces(one))
    return one.refuse("F >= 1 with N = 0: FX is relative to a normal force that depends on it");
  const ContactCase normal = without_friction(one);
  std::string problem = scene_of_case(normal, "scene", "/", "scene");
  for (const SceneTableFile& table : normal.tables)
    problem += table.text;
  problem.erase(0, problem.find('\n'));
  try {
    const auto [at, is_new] = normal_forces_.try_emplace(problem, 0);
    if (is_new)
      at->second = solve(normal).result.totals.Fz;
    if (one.share_x)
      one.set("load.force_x", *one.share_x * one.friction * at->second);
    if (one.share_s)
      one.set("load.force_s", *one.share_s * one.friction * at->second);
    one.leave(
        fmt::format("FX is relative to the normal force, which is {:.6g} N at this approach", at->second));
  } catch (const Error& error) {
    one.refuse(fmt::format("F >= 1 with N = 0: its normal problem has no solution: {}", error.what()));
  }
}

void SolvedCases::set_start(const ContactCase& before, ContactCase& next) {
  if (!before.refused.empty())
    return next.refuse(fmt::format("P = 0: it goes on from case {}, which has no scene", before.last));
  if (!next.refused.empty())
    return;
  if (!before.grid || !next.grid)
    return next.refuse(
        fmt::format("P = 0: it goes on from case {}, and is no further step of the same history ({})",
                    before.last, other_than(before, next)));
  const PatchGrid &from = *before.grid, &to = *next.grid;
  const auto whole = [](double k) { return std::abs(k - std::round(k)) < 1e-3; };
  const double half = 0.5 * (static_cast<double>(from.mx) - static_cast<double>(to.mx)),
               half_s = 0.5 * (static_cast<double>(from.ms) - static_cast<double>(to.ms));
  if (std::abs(from.dx / to.dx - 1) > 1e-6 || std::abs(from.ds / to.ds - 1) > 1e-6 ||
      !whole((to.x - from.x) / to.dx + half) || !whole((to.y - from.y) / to.ds + half_s))
    return next.refuse(fmt::format("P = 0: it goes on from case {}, which has other elements", before.last));
  try {
    const Tractions start = tractions_of(solve(before).result);
    std::string text = start.plastic.empty() ? "ix,is,px,ps,pn\n" : "ix,is,px,ps,pn,plastic_slip\n";
    for (std::size_t j = 0; j < to.ms; ++j)
      for (std::size_t i = 0; i < to.mx; ++i)
        text += line_of(start, from, to, i, j);
    next.tables.push_back({"motion.start_table", std::move(text)});
  } catch (const Error& error) {
    next.refuse(
        fmt::format("P = 0: it goes on from case {}, which has no solution: {}", before.last, error.what()));
  }
}

} // namespace bem_contact::app::from_contact
