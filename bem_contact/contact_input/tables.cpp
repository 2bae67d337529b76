#include "bem_contact/contact_input/tables.hpp"

#include "bem_contact/base/error.hpp"

#include <fmt/format.h>

namespace bem_contact::contact_input {

namespace {

/// Elements, points and rows that CONTACT accepts.
constexpr long most_elements = 1'000'000, most_points = 999'999;

/// Reads an item and adds its numbers to the block.
void read_into(InputLines& in, Block& block, std::string_view format) {
  block.add(format, in.take(format));
}

void read_profile(InputLines& in, CaseState& state, Data data) {
  constexpr std::string_view format = "FNAME s, MIRRORY i, SCALE d, SMOOTH d, MIRRORZ I, PRFOPT I";
  Block block(format, in.take(format));
  const double options = block.number("PRFOPT", 0);
  if (options >= 1)
    read_into(in, block, "ISMOOTH i, ZIGTHRS a, KINKHIGH a, KINKLOW a, KINKWID d");
  if (options >= 2)
    read_into(in, block, "ERRHND i, MAXOMIT d");
  state.set(data, std::move(block));
}

/// A list of numbers that stresses below the surface need, and that nothing here keeps.
void skip_numbers(InputLines& in, const char* name, long count) {
  in.take_array(name, 'd', static_cast<std::size_t>(count));
}

void read_points(InputLines& in, long kind, Block& block) {
  if (kind == 2 || kind == 6) {
    in.take("IXL i, IXINC i, IXH i");
    in.take("IYL i, IYINC i, IYH i");
  } else if (kind == 3 || kind == 7) {
    const Item n = in.take("NX i, NY i");
    skip_numbers(in, "IX", static_cast<long>(n.numbers[0]));
    skip_numbers(in, "IY", static_cast<long>(n.numbers[1]));
  } else if (kind == 9) {
    const Item n = in.take("NX i, NY i, NZ i");
    for (const auto& [name, k] : {std::pair{"X", 0}, {"Y", 1}, {"Z", 2}})
      skip_numbers(in, name, static_cast<long>(n.numbers[static_cast<std::size_t>(k)]));
  }
  if (kind <= 3)
    in.take("NZ i, ZL d, DZ d");
  else if (kind <= 7)
    skip_numbers(in, "Z", in.take_count("NZ i", 1, most_points));
  block.values.push_back(static_cast<double>(kind));
}

} // namespace

void read_solver(InputLines& in, CaseState& state) {
  constexpr std::string_view format = "MAXGS i, MAXIN i, MAXNR i, MAXOUT i, EPS d, NPOMAX I";
  Block block(format, in.take(format));
  if (state.digits.is('G', "23"))
    read_into(in, block, "OMEGAH d, OMEGAS d, INISLP i, OMGSLP d");
  else if (state.digits['G'] == 4)
    read_into(in, block, "INISLP i, OMGSLP d");
  else if (state.digits['G'] == 5)
    read_into(in, block, "FDECAY d, BETATH d, KDOWFB i, D_IFC d, D_LIN d, D_CNS d, D_SLP d, POW_S d");
  state.set(Data::solver, std::move(block));
}

void read_friction(InputLines& in, CaseState& state) {
  const int law = state.digits['L'], variation = state.digits['V'];
  const std::string coefficients = law == 0   ? "FSTAT d, FKIN d"
                                   : law == 6 ? "FREF d, TREF d, DFHEAT d, DTHEAT d"
                                              : "FKIN d, F1 d, SABSH1 d, F2 d, SABSH2 d";
  const std::string format = variation == 1   ? "ALPHA a, " + coefficients
                             : variation == 2 ? "SVF d, " + coefficients
                                              : coefficients;
  long sets = 1;
  if (variation == 1 || variation == 2)
    sets = in.take_count("NVF i", 1, most_points);
  else if (variation == 3)
    sets = static_cast<long>(state[Data::potential]["MY"]);
  Block block;
  for (long k = 0; k < sets; ++k) {
    const Item row = in.take(format);
    block.line = k == 0 ? row.line : block.line;
    block.values.insert(block.values.end(), row.numbers.begin(), row.numbers.end());
    block.columns = row.numbers.size();
  }
  if (law != 0)
    read_into(in, block, "MEMDST d, MEM_S0 d");
  state.set(Data::friction, std::move(block));
}

void read_inclinations(InputLines& in, CaseState& state) {
  constexpr std::string_view format = "IF_METH i, VARIANT i, NN i";
  Block block(format, in.take(format));
  if (block["NN"] < 1 || block["NN"] > 9999)
    throw InputError(fmt::format("{}NN is {}", in.where(block.line), block["NN"]),
                     "there are 1 to 9999 inclinations", "Correct the line.");
  block.values = in.take_array("YI, AI", 'a', static_cast<std::size_t>(2 * block["NN"])).numbers;
  block.columns = 2;
  state.set(Data::inclinations, std::move(block));
}

void read_heat(InputLines& in, CaseState& state) {
  constexpr std::string_view format = "BKTEMP1 d, HEATCP1 d, LAMBDA1 d, DENS1 d";
  Block block(format, in.take(format));
  read_into(in, block, "BKTEMP2 d, HEATCP2 d, LAMBDA2 d, DENS2 d");
  state.set(Data::heat, std::move(block));
}

void read_potential(InputLines& in, CaseState& state) {
  Block block("IPOTCN i", in.take("IPOTCN i"));
  const double kind = block["IPOTCN"];
  static constexpr std::string_view by_hertz[] = {
      "MX i, MY i, A1 d, B1 d, SCALE d", "MX i, MY i, A1 d, AOB d, SCALE d",
      "MX i, MY i, AA d, BB d, SCALE d", "MX i, MY i, A1 d, BB d, SCALE d",
      "MX i, MY i, AA d, BB d, SCALE d", "MX i, MY i, AA d, BNEG d, BPOS d, SCALE d"};
  static constexpr std::string_view by_grid[] = {
      "MX i, MY i, XL d, YL d, DX d, DY d", "MX i, MY i, XL d, YL d, XH d, YH d",
      "MX i, MY i, XC1 d, YC1 d, DX d, DY d", "MX i, MY i, XC1 d, YC1 d, XCM d, YCM d"};
  if (kind < -6 || kind == 0 || kind > 4)
    throw InputError(fmt::format("{}IPOTCN is {}", in.where(block.line), kind),
                     "CONTACT takes -6 to -1 and 1 to 4", "Correct the line.");
  read_into(in, block,
            kind < 0 ? by_hertz[static_cast<std::size_t>(-kind - 1)]
                     : by_grid[static_cast<std::size_t>(kind - 1)]);
  if (block["MX"] < 1 || block["MY"] < 1 || block["MX"] * block["MY"] > most_elements)
    throw InputError(fmt::format("{}MX, MY are {} and {}", in.where(block.line), block["MX"], block["MY"]),
                     fmt::format("a potential contact has 1 to {} elements", most_elements),
                     "Correct the line.");
  state.set(Data::potential, std::move(block));
}

void read_distance(InputLines& in, CaseState& state) {
  if (state[Data::potential]["IPOTCN"] < 0) { // the ellipse says it
    Block block;
    block.line = state[Data::potential].line;
    return state.set(Data::distance, std::move(block));
  }
  Block block("IBASE i, IPLAN i", in.take("IBASE i, IPLAN i"));
  const double base = block["IBASE"], plan = block["IPLAN"];
  const auto refuse = [&](const char* name, double value, const char* why) {
    throw InputError(fmt::format("{}{} is {}", in.where(block.line), name, value), why, "Correct the line.");
  };
  if (base != 1 && base != 2 && base != 3 && base != 9)
    refuse("IBASE", base, "CONTACT takes 1, 2, 3 and 9");
  if (plan < 1 || plan > 4)
    refuse("IPLAN", plan, "CONTACT takes 1 to 4");
  const double elements = state[Data::potential]["MX"] * state[Data::potential]["MY"];
  std::size_t count = base == 1 ? 6 : base == 3 ? 8 : static_cast<std::size_t>(elements);
  if (base == 2) {
    read_into(in, block, "NN i, XM d, RM d, Y1 d, DY1 d");
    if (block["NN"] < 2 || block["NN"] > most_points)
      refuse("NN", block["NN"], "there are 2 to 999999 points");
    count = static_cast<std::size_t>(block["NN"]);
  }
  block.values = in.take_array("undeformed distance", 'd', count).numbers;
  block.columns = 1;
  if (plan == 2 || plan == 3)
    in.take_array("planform", 'd', plan == 2 ? 6 : 8);
  else if (plan == 4) {
    const long patches = in.take_count("NPATCH i", 1, 100);
    in.take_array("XYLIM", 'd', static_cast<std::size_t>(4 * patches));
    in.take_array("FAC", 'd', static_cast<std::size_t>(patches * (patches - 1) / 2));
  }
  state.set(Data::distance, std::move(block));
}

void read_slip(InputLines& in, CaseState& state) {
  const double elements = state[Data::potential]["MX"] * state[Data::potential]["MY"];
  const Item item = in.take_array("extra rigid slip", 'd', static_cast<std::size_t>(2 * elements));
  Block block;
  block.line = item.line;
  block.values = item.numbers;
  block.columns = 2;
  state.set(Data::slip, std::move(block));
}

void read_rail_profile(InputLines& in, CaseState& state) {
  read_profile(in, state, Data::rail_profile);
}

void read_wheel_profile(InputLines& in, CaseState& state) {
  read_profile(in, state, Data::wheel_profile);
}

void read_velocity(InputLines& in, CaseState& state) {
  const bool roller = state.digits.is('1', "45"), force = state.digits['F'] == 1;
  const std::string format = fmt::format("{}, VY d, VZ d, VROLL a, VYAW a, {}", roller ? "RPITCH a" : "VS d",
                                         force ? "FX d" : "VPITCH a");
  state.set(Data::velocity, Block(format, in.take(format)));
}

void read_wheel_deviation(InputLines& in, CaseState& state) {
  constexpr std::string_view format = "DX d, DY d, DZ d, DROLL a, DYAW a, DPITCH a";
  Block block(format, in.take(format));
  read_into(in, block, "VX d, VY d, VZ d, VROLL a, VYAW a, VPITCH a");
  state.set(Data::wheel_deviation, std::move(block));
}

void read_stresses(InputLines& in, CaseState& state) {
  constexpr std::string_view format = "MATFIL i, OUTPUT i";
  Block block(format, in.take(format));
  if (state.digits['S'] == 2) {
    if (state.has(Data::stresses))
      block.values = state[Data::stresses].values;
    return state.set(Data::stresses, std::move(block));
  }
  for (long kind = in.take_count("ISUBS i", -1000, 9); kind >= 1; kind = in.take_count("ISUBS i", -1000, 9)) {
    if (kind == 4 || kind == 8)
      throw InputError(fmt::format("{}ISUBS is {}", in.where(in.line()), kind),
                       "CONTACT takes 1 to 3, 5 to 7 and 9", "Correct the line.");
    read_points(in, kind, block);
  }
  state.set(Data::stresses, std::move(block));
}

} // namespace bem_contact::contact_input
