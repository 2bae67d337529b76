#include "bem_contact/app/from_contact/patch_keys.hpp"

#include "bem_contact/app/from_contact/common_keys.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

// Rigid slip in CONTACT, of the lower over the upper body: w = (CKSI - CPHI (y - y0), CETA + CPHI (x - x0)),
// and an extra term. Here it is that of the upper over the lower body, about the middle of the grid.
namespace bem_contact::app::from_contact {

namespace {

using contact_input::Block;
using contact_input::CaseState;
using contact_input::Data;

constexpr double rounding = 1e-9;

/// The grid, or nothing where it is refused. Sets the ellipse's curvatures.
std::optional<PatchGrid> add_grid(const CaseState& state, ContactCase& out) {
  const Block &p = state[Data::potential], &k = *state.grid_load;
  std::optional<PatchGrid> grid;
  if (p["IPOTCN"] > 0)
    grid = grid_by_places(p);
  else if (p["IPOTCN"] >= -3) {
    const bool by_force = k.has("FN");
    try {
      const HertzianGrid found =
          grid_by_ellipse(p, contact_modulus(*state.grid_material), by_force, by_force ? k["FN"] : k["PEN"]);
      out.set("gap.a", found.curvature_x);
      out.set("gap.b", found.curvature_s);
      grid = found.grid;
    } catch (const InputError& error) {
      out.refuse(fmt::format("IPOTCN = {}: {}", p["IPOTCN"], error.what()));
    }
  } else
    out.refuse(fmt::format("IPOTCN = {}: {}", p["IPOTCN"],
                           p["IPOTCN"] == -6 ? "half ellipses of unequal width"
                                             : "a rectangle of a given length under a cylinder"));
  if (!grid)
    return grid;
  if (state.has(Data::rolling) && state.digits.is('T', "23")) {
    const double turns = state[Data::rolling]["CHI"] / std::numbers::pi;
    if (std::abs(turns - std::round(turns)) > rounding)
      out.refuse(fmt::format("CHI = {} rad: rolling at an angle to x", state[Data::rolling]["CHI"]));
    grid->turned = std::abs(std::fmod(std::round(turns), 2)) == 1;
    if (grid->turned)
      out.leave("CHI = 180 degrees: x and s of the scene point the other way, and so do Fx and Fs");
  }
  for (const auto& [key, value] : {std::pair{"grid.dx", grid->dx}, {"grid.ds", grid->ds}})
    out.set(key, fmt::format("{:.12g}", value));
  out.set("grid.mx", static_cast<double>(grid->mx));
  out.set("grid.ms", static_cast<double>(grid->ms));
  return grid;
}

void add_rolling(const CaseState& state, const PatchGrid& grid, ContactCase& out) {
  if (!state.digits.is('T', "23"))
    return;
  if (!state.has(Data::rolling))
    return out.refuse(fmt::format("T = {}: CHI, DQ and VELOC are not given", state.digits['T']));
  const Block& rolling = state[Data::rolling];
  out.set("motion.speed", rolling["VELOC"]);
  if (std::abs(rolling["DQ"] / grid.dx - 1) < 1e-3)
    return;
  if (state.digits['T'] == 2)
    out.refuse(fmt::format("DQ = {} mm: a rolling step is dx here", rolling["DQ"]));
  else
    out.leave(fmt::format("DQ = {} mm: steady rolling has steps of dx here", rolling["DQ"]));
}

/// The undeformed distance at a place in CONTACT's coordinates; of IBASE = 9 by element.
double distance_at(const Block& d, double x, double y) {
  const auto b = [&](std::size_t k) { return d.values.at(k); };
  if (d["IBASE"] == 1)
    return b(0) * x * x + b(1) * x * y + b(2) * y * y + b(3) * x + b(4) * y + b(5);
  if (d["IBASE"] == 3)
    return b(0) * std::sin(b(1) * (x - b(2))) - b(3) * std::sin(b(4) * (x - b(5))) + x * x / b(6) +
           y * y / b(7);
  // IBASE = 2: a circle along x, straight lines between points along y and beyond them
  const double step = d["DY1"], first = d["Y1"];
  const auto last = static_cast<double>(d.values.size()) - 2;
  const double k = std::clamp(std::floor((y - first) / step), 0.0, last);
  const auto at = static_cast<std::size_t>(k);
  return b(at) + (b(at + 1) - b(at)) / step * (y - first - k * step) +
         std::pow(x - d["XM"], 2) / (2 * d["RM"]);
}

/// B1 x^2 + B2 x y + B3 y^2 about the middle of the grid, or, of shifts, about another place along x. False
/// where that does not serve.
bool add_quadratic(const Block& d, const PatchGrid& grid, ContactCase& out) {
  const auto& b = d.values;
  const double scale = std::max(std::abs(b[0]), std::abs(b[2])) * std::max(grid.dx, grid.ds);
  const auto is_bottom = [&](double x, double y) {
    const double by_x = 2 * b[0] * x + b[1] * y + b[3], by_s = 2 * b[2] * y + b[1] * x + b[4];
    return std::abs(by_x) < rounding * scale && std::abs(by_s) < rounding * scale &&
           std::abs(distance_at(d, x, y)) < rounding * scale;
  };
  const bool along = out.is_shift() && b[0] != 0 && b[1] == 0 && out.number("motion.phi") == 0;
  const double x = along ? -b[3] / (2 * b[0]) : grid.x;
  if (!is_bottom(x, grid.y))
    return false;
  if (along)
    out.gap_x = x;
  out.set("gap.a", b[0]);
  out.set("gap.b", b[2]);
  if (b[1] != 0)
    out.set("gap.c", b[1]);
  return true;
}

void add_distance(const CaseState& state, const PatchGrid& grid, ContactCase& out) {
  const Block& d = state[Data::distance];
  if (!d.has("IBASE")) { // the ellipse has said it
    if (state[Data::potential]["IPOTCN"] > 0)
      out.refuse(
          fmt::format("Z = {}: the distance of the case before was that of an ellipse", state.digits['Z']));
    return;
  }
  if (state[Data::potential]["IPOTCN"] < 0)
    return;
  if (d["IPLAN"] != 1)
    out.refuse(fmt::format("IPLAN = {}: a planform that is given; here it is found", d["IPLAN"]));
  if (d["IBASE"] == 1 && add_quadratic(d, grid, out))
    return;
  if (d["IBASE"] == 9 && d.values.size() != grid.elements())
    return out.refuse("Z: the distance of another number of elements");
  std::string text = "ix,is,h\n";
  for (std::size_t j = 0; j < grid.ms; ++j)
    for (std::size_t i = 0; i < grid.mx; ++i)
      text += fmt::format("{},{},{:.12g}\n", i, j,
                          d["IBASE"] == 9 ? d.values[grid.contact_element(i, j)]
                                          : distance_at(d, grid.contact_x(i), grid.contact_y(j)));
  out.tables.push_back({"gap.table", std::move(text)});
}

void add_slip_table(const CaseState& state, const PatchGrid& grid, double creep_x, double creep_y,
                    ContactCase& out) {
  const Block& k = state[Data::kinematics];
  if (state.digits['F'] > 0)
    return out.refuse(fmt::format("E = {} with F = {}: a slip table leaves no creepage to be found",
                                  state.digits['E'], state.digits['F']));
  const bool read = state.digits.is('E', "19");
  if (read && state[Data::slip].rows() != grid.elements())
    return out.refuse("E = 1: the extra slip of another number of elements");
  const double spin = k["CPHI"], x0 = k.number("SPINXO", 0), y0 = k.number("SPINYO", 0);
  std::string text = "ix,is,wx,ws\n";
  for (std::size_t j = 0; j < grid.ms; ++j)
    for (std::size_t i = 0; i < grid.mx; ++i) {
      const double by_x = spin * (grid.contact_x(i) - x0), by_y = -spin * (grid.contact_y(j) - y0);
      const std::size_t n = grid.contact_element(i, j);
      const double extra_x = read ? state[Data::slip].at(n, 0) : state.digits['E'] == 3 ? -by_y : 0;
      const double extra_y = read ? state[Data::slip].at(n, 1) : state.digits['E'] == 2 ? -by_x : 0;
      text += fmt::format("{},{},{:.12g},{:.12g}\n", i, j, -grid.sign() * (creep_x + by_y + extra_x),
                          -grid.sign() * (creep_y + by_x + extra_y));
    }
  out.tables.push_back({"motion.slip_table", std::move(text)});
}

/// Load, creepages and forces.
void add_kinematics(const CaseState& state, const PatchGrid& grid, ContactCase& out) {
  const Block& k = state[Data::kinematics];
  const bool by_force = state.digits['N'] == 1;
  const double load = k[by_force ? "FN" : "PEN"];
  if (by_force && load <= 0)
    out.refuse(fmt::format("FN = {}: CONTACT itself asks for a force above 0", load));
  out.set(by_force ? "load.force" : "load.approach", load);
  if (state.digits['T'] == 0)
    return;
  const double creep_x = k.number("CKSI", 0), creep_y = k.number("CETA", 0), spin = k["CPHI"];
  if (state.digits['E'] == 9 || (state.digits['E'] != 0 && (spin != 0 || state.digits['E'] == 1)))
    return add_slip_table(state, grid, creep_x, creep_y, out);
  const double limit =
      (state.effective['V'] == 3 ? 1 : out.friction) * load; // what FX and FY are relative to
  const auto along = [&](const char* name, const char* key, std::optional<double>& share, double creepage,
                         const char* creep) {
    if (!k.has(name))
      return out.set(creep, -grid.sign() * creepage);
    out.set(key, grid.sign() * k[name] * limit);
    if (!by_force)
      share = grid.sign() * k[name];
  };
  along("FX", "load.force_x", out.share_x, creep_x - spin * (grid.y - k.number("SPINYO", 0)), "motion.xi");
  along("FY", "load.force_s", out.share_s, creep_y + spin * (grid.x - k.number("SPINXO", 0)), "motion.eta");
  out.set("motion.phi", -spin);
}

void add_inclinations(const CaseState& state, const PatchGrid& grid, ContactCase& out) {
  if (state.effective['C'] != 4)
    return;
  const Block& inclinations = state[Data::inclinations];
  std::string text = "is,delta\n";
  for (std::size_t j = 0; j < grid.ms; ++j) {
    const double y = grid.contact_y(j);
    std::size_t row = 0;
    while (row + 2 < inclinations.rows() && y > inclinations.at(row + 1, 0))
      ++row;
    const double span = inclinations.rows() > 1 ? inclinations.at(row + 1, 0) - inclinations.at(row, 0) : 1;
    const double share =
        inclinations.rows() > 1 ? std::clamp((y - inclinations.at(row, 0)) / span, 0.0, 1.0) : 0;
    const double delta =
        inclinations.at(row, 1) +
        share * (inclinations.rows() > 1 ? inclinations.at(row + 1, 1) - inclinations.at(row, 1) : 0);
    text += fmt::format("{},{:.12g}\n", j, grid.sign() * delta);
  }
  out.tables.push_back({"strip.inclination", std::move(text)});
}

/// Friction of each row (V = 3): along s from the middle of the grid.
void add_friction_of_rows(const CaseState& state, const PatchGrid& grid, ContactCase& out) {
  if (state.effective['V'] != 3)
    return add_friction(state, 0, out);
  const Block& f = state[Data::friction];
  if (f.rows() != grid.ms)
    return out.refuse("V = 3: friction of another number of rows");
  std::vector<double> places;
  for (std::size_t j = 0; j < grid.ms; ++j)
    places.push_back(grid.sign() * (static_cast<double>(j) - 0.5 * (static_cast<double>(grid.ms) - 1)) *
                     grid.ds);
  if (grid.turned)
    return out.refuse("V = 3 with CHI = 180 degrees: friction by row of a contact that rolls backwards");
  add_friction_table(state, "s", places, out);
}

} // namespace

void add_patch_keys(const CaseState& state, ContactCase& out) {
  out.set_text("kind", "patch");
  add_common_keys(state, out);
  const std::optional<PatchGrid> grid = add_grid(state, out);
  out.grid = grid;
  if (!grid)
    return;
  add_friction_of_rows(state, *grid, out);
  add_rolling(state, *grid, out);
  add_kinematics(state, *grid, out);
  add_distance(state, *grid, out);
  add_inclinations(state, *grid, out);
  if (state.digits.is('T', "12") && !state.first) {
    if (state.digits['P'] == 0)
      out.goes_on_from = state.number - 1;
    else if (state.digits['P'] == 3)
      out.refuse("P = 3: it starts from the tractions of the case before the one before");
  }
}

} // namespace bem_contact::app::from_contact
