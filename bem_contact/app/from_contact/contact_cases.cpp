#include "bem_contact/app/from_contact/contact_cases.hpp"

#include "bem_contact/app/from_contact/inp_file.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/reference/hertz.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>

// What stands where in the file: as CONTACT itself reads it (E.A.H. Vollebregt, CONTACT, open source,
// github.com/eve70a/CONTACT: src/m_wr_input.f90, m_sinput.f90 and the examples). Its CANT turns the right
// rail by -CANT about x, and the left one as its mirror image: towards the track's centre if it is above 0.
// Its forces are those on the rail; FX of module 1 lies along the wheelset's own x axis.
namespace bem_contact::app {

namespace {

std::string toml_text_of(const std::string& text) {
  return fmt::format("\"{}\"", text);
}

/// Control digits by their letters.
struct Digits {
  int config = 0, previous = 0, bound = 0, tang = 0, norm = 0, force = 0, stress = 0; // C P B T N F S
  int varfrc = 0, law = 0, grid = 0, inflcf = 0, mater = 0, z = 0, e = 0;             // V L D C M Z E
  int debug = 0, heat = 0, solver = 0;                                                // X H G
  bool rolls() const { return tang >= 2; }
};

/// Friction that a case has used last: CONTACT keeps it where L = 1.
struct KeptData {
  Digits digits;
  std::map<std::string, std::string> keys;
  double friction = 0.3; ///< FSTAT
  double dq = 0, dx = 0, ds = 0;
  double modulus = 0; ///< contact modulus of the pair, MPa
  int mx = 0, ms = 0;
  double shift_x = 0, shift_s = 0; ///< middle of the grid, mm
  std::optional<int> potential;    ///< IPOTCN
};

/// Reads one case of either module.
class CaseReader {
public:
  CaseReader(InpFile& in, KeptData& kept, int module) : in_(in), kept_(kept) {
    out_.module = module;
    out_.line = in.line();
  }

  ContactCase read() {
    read_digits();
    out_.keys.swap(kept_.keys);
    if (out_.module == 1)
      read_wheel_on_rail();
    else
      read_patch();
    kept_.keys = out_.keys;
    kept_.digits = d_;
    return std::move(out_);
  }

  const Digits& digits() const { return d_; }

private:
  void set(const std::string& key, const std::string& value) { out_.keys[key] = value; }
  void set(const std::string& key, double value) { set(key, fmt::format("{}", value)); }
  void leave(const std::string& sentence) { out_.left_out.push_back(sentence); }
  void refuse(const std::string& sentence) { out_.refused.push_back(sentence); }

  void read_digits() {
    const auto first = in_.digits("C-P-B-T-N-F-S", 7), second = in_.digits("V-L-D-C-M-Z-E", 7),
               third = in_.digits("H-G-I-A-O-W-R", 7);
    // An unused eighth digit stands in front.
    d_ = {first[1],  first[2],  first[3],  first[4],  first[5],  first[6], first[7], second[1], second[2],
          second[3], second[4], second[5], second[6], second[7], third[0], third[1], third[2]};
    if (d_.debug > 0)
      in_.take("P-S-F-L-R-I-N", "i");
    if (d_.bound > 1)
      leave(fmt::format("B = {}: an approximate pressure; here the contact conditions are solved", d_.bound));
    if (d_.varfrc > 0)
      refuse(fmt::format("V = {}: friction that varies; write it as motion.friction_table", d_.varfrc));
    if (d_.stress >= 2)
      leave("S: points below the surface; give [stresses] with depths");
    if (d_.heat > 0 && d_.heat != 3)
      leave("H: give [temperature] with flash = true");
    read_solver();
  }

  void read_solver() {
    if (d_.solver == 1)
      return;
    in_.take("MAXGS, MAXIN, MAXNR, MAXOUT, EPS", "iiiidI");
    if (d_.solver == 2 || d_.solver == 3)
      in_.take("OMEGAH, OMEGAS, INISLP, OMGSLP", "ddid");
    if (d_.solver == 4)
      in_.take("INISLP, OMGSLP", "id");
    if (d_.solver == 5)
      in_.take("parameters of G = 5", out_.module == 1 ? "ddiddddd" : "dddddd");
  }

  void read_motion() {
    switch (d_.tang) {
    case 0:
      set("motion.frictionless", "true");
      set("motion.kind", toml_text_of("steady"));
      break;
    case 1:
      set("motion.kind", toml_text_of("shift"));
      break;
    case 2:
      set("motion.kind", toml_text_of("transient"));
      break;
    case 3:
      set("motion.kind", toml_text_of("steady"));
      break;
    default:
      refuse(fmt::format("T = {} is not known", d_.tang));
    }
    if (d_.tang != 0)
      out_.keys.erase("motion.frictionless");
  }

  void read_friction() {
    if (d_.law == 1)
      return;
    for (const char* key : {"motion.friction", "motion.falling_friction", "motion.half_slip_velocity"})
      out_.keys.erase(key);
    int sets = 1;
    if (d_.varfrc == 1 || d_.varfrc == 2)
      sets = static_cast<int>(in_.take("NVF", "i")[0]);
    else if (d_.varfrc == 3)
      sets = std::max(1, kept_.ms);
    const std::string before = d_.varfrc == 1 ? "a" : d_.varfrc == 2 ? "d" : "";
    for (int k = 0; k < sets; ++k)
      read_friction_law(before);
    if (d_.law >= 2 && in_.take("MEMDST, MEM_S0", "dd")[0] > 0)
      leave("MEMDST: friction that remembers; here it follows the slip at once");
  }

  void read_friction_law(const std::string& before) {
    const std::size_t at = before.size();
    if (d_.law == 0) {
      const auto v = in_.take("FSTAT, FKIN", before + "dd");
      kept_.friction = v[at];
    } else if (d_.law >= 2 && d_.law <= 4) {
      const auto v = in_.take("FKIN and what falls", before + "ddddd");
      kept_.friction = v[at] + v[at + 1] + v[at + 3];
      if (d_.law != 4 || v[at + 3] != 0)
        refuse(fmt::format(
            "L = {}: friction that falls by another law (here: L = 4 with FEXP2 = 0, or Polach's law)",
            d_.law));
      set("motion.falling_friction", v[at]);
      set("motion.half_slip_velocity", v[at + 2]);
    } else {
      in_.take("FREF, TREF, DFHEAT, DTHEAT", before + "dddd");
      refuse(fmt::format("L = {}: friction by temperature; write it as [temperature] falls_from, falls_to",
                         d_.law));
    }
    set("motion.friction", kept_.friction);
  }

  void read_material() {
    const auto m = in_.take("POISS 1,2, GG 1,2", "dddd");
    set("rail.material.poisson", m[0]);
    set("wheel.material.poisson", m[1]);
    set("rail.material.shear_modulus", m[2]);
    set("wheel.material.shear_modulus", m[3]);
    kept_.modulus = 1 / ((1 - m[0]) / (2 * m[2]) + (1 - m[1]) / (2 * m[3]));
    if (d_.bound == 1)
      set("layer.normal_compliance", in_.take("FLX_Z", "d")[0]);
    read_layer();
  }

  void read_layer() {
    if (d_.mater == 1) {
      in_.take("FG 1,2, TC 1,2", "dddd");
      refuse("M = 1: viscoelastic bodies");
    } else if (d_.mater == 2 || d_.mater == 3) {
      in_.take("parameters of the simplified theory", d_.mater == 2 ? "dddd" : "ddd");
      set("solver.model", toml_text_of("simplified"));
      leave(fmt::format(
          "M = {}: the simplified theory has flexibilities from Kalker's coefficients here, and no "
          "reduction of slopes",
          d_.mater));
    } else if (d_.mater == 4) {
      const auto l = in_.take("GG3, LAYTHK, TAU_C0, K_TAU", "dddd");
      set("layer.shear_modulus", l[0]);
      set("layer.thickness", l[1]);
      if (l[2] > 1e-10)
        refuse("M = 4 with TAU_C0: a layer that flows; here layers are elastic");
    }
  }

  void read_model() {
    if (d_.inflcf == 9)
      refuse("C = 9: influence numbers of a file; here solver.model = \"fem\" takes influence files of both "
             "bodies");
    if (d_.inflcf == 3)
      leave("C = 3: bilinear elements; here they are constant");
    set("solver.model", toml_text_of(d_.inflcf == 4 ? "tangent_plane" : "halfspace"));
  }

  void read_heat() {
    if (d_.heat != 3)
      return;
    set("temperature.flash", "true");
    for (const char* body : {"rail", "wheel"}) {
      const auto h = in_.take("BKTEMP, HEATCP, LAMBDA, DENS", "dddd");
      leave(fmt::format(
          "H = 3: the heat of the {} (temperature {}, capacity {}, conduction {}, density {} in CONTACT's "
          "units); give temperature.{}_* in those of the scene",
          body, h[0], h[1], h[2], h[3], body));
    }
    if (d_.mater == 4)
      in_.take("BETAPL", "d");
  }

  // Module 1

  void read_wheel_on_rail() {
    set("kind", toml_text_of("wheel_rail"));
    if (d_.config != 0 && d_.config != 1)
      refuse(fmt::format("C1 = {}: a roller rig; write it with rail.roller_radius", d_.config));
    set("position.side", toml_text_of(d_.config == 0 || d_.config == 4 ? "left" : "right"));
    set("solver.model", toml_text_of("halfspace"));
    read_motion();
    read_friction();
    if (d_.inflcf >= 2) {
      if (d_.inflcf == 4)
        in_.take("IF_METH, VARIANT", "ii");
      read_model();
      read_material();
    }
    read_heat();
    if (d_.grid >= 2)
      read_elements();
    read_track();
    read_wheelset();
    if (d_.previous < 2 && !(d_.tang == 0 || d_.tang == 3))
      refuse(fmt::format(
          "P = {}: it goes on from the tractions of the case before; of a wheel on a rail a scene has "
          "all steps at once (motion.steps)",
          d_.previous));
  }

  void read_elements() {
    const auto g = in_.take("DX, DS, DQREL, A_SEP, D_SEP, D_COMB", "dddaddD");
    set("grid.dx", g[0]);
    set("grid.ds", g[1]);
    const bool curved = d_.grid == 4;
    set("grid.planar", curved ? "false" : "true");
    if (d_.grid != 2 && d_.grid != 4 && d_.grid != 5)
      leave(fmt::format("D = {}: taken as contact in one plane (D = 2)", d_.grid));
    if (d_.rolls() && g[2] != 1)
      leave(fmt::format("DQREL = {}: one rolling step is dx here", g[2]));
  }

  void read_profile(const std::string& body) {
    const auto p = in_.take(fmt::format("profile of the {}", body), "siddII");
    set(body + ".profile", toml_text_of(p.text));
    if (p[0] == 1)
      leave(fmt::format("MIRRORY = 1 of the {}: mirror y in its file", body));
    if (p[1] != 1 && p[1] != 1000)
      leave(fmt::format("SCALE = {} of the {}: give {}.unit", p[1], body, body));
    if (p[1] == 1000)
      set(body + ".unit", toml_text_of("m"));
    if (p[2] != 0)
      leave(fmt::format(
          "the smoothing {} of the {}: {}.smoothing is the shortest wavelength that is kept, in mm", p[2],
          body, body));
    const int options = p.size() > 4 ? static_cast<int>(p[4]) : 0;
    if (options >= 1)
      in_.take("ISMOOTH, ZIGTHRS, KINKHIGH, KINKLOW, KINKWID", "iaaad");
    if (options >= 2)
      in_.take("ERRHND, MAXOMIT", "id");
  }

  void read_track() {
    if (d_.z == 1 || d_.z == 3) {
      const auto t = in_.take("GAUGHT, GAUGSQ, GAUGWD, CANT", "ddda");
      if (t[0] > 0) {
        set("position.gauge_height", t[0]);
        set("position.gauge", t[2]);
        if (t[1] > 1)
          leave(fmt::format("GAUGSQ = {}: the gauge point is the innermost one here", t[1]));
      } else {
        set("rail.place", toml_text_of("absolute"));
        set("rail.y", t[1]);
        set("rail.z", t[2]);
      }
      set("position.rail_inclination", t[3]);
    }
    if (d_.z == 3)
      read_profile("rail");
    if (d_.z >= 2) {
      const auto r = in_.take("DY, DZ, DROLL, VY, VZ, VROLL", "ddadda");
      set("position.rail_lateral", r[0]);
      set("position.rail_vertical", r[1]);
      set("position.rail_roll", r[2]);
      if (r[3] != 0 || r[4] != 0 || r[5] != 0)
        refuse("velocities of the rail: here it stands still");
      if (d_.force == 3) {
        in_.take("KYRAIL, FYRAIL, KZRAIL, FZRAIL", "dddd");
        refuse("F = 3: a rail on springs");
      }
    }
  }

  void read_wheelset() {
    if (d_.e == 3 || d_.e == 5) {
      const auto w = in_.take("FBDIST, FBPOS, NOMRAD", "ddd");
      set("position.back_to_back", w[0]);
      set("wheel.flange_back", w[1]);
      set("position.wheel_radius", w[2]);
      read_profile("wheel");
    }
    if (d_.e >= 1)
      read_pose();
    if (d_.e >= 2)
      read_velocity();
    if (d_.e == 4 || d_.e == 5)
      read_flexibility();
  }

  void read_pose() {
    const auto p = in_.take("S, Y, FZ or Z, ROLL, YAW, PITCH", "dddaaa");
    set("position.lateral", p[1]);
    set("position.roll", p[3]);
    set("position.yaw", p[4]);
    for (const char* key : {"load.force", "position.vertical"})
      out_.keys.erase(key);
    if (d_.norm == 1)
      set("load.force", p[2]);
    else
      set("position.vertical", p[2] + number("position.wheel_radius"));
  }

  void read_velocity() {
    const bool moment = d_.force == 1 || d_.force == 2;
    const auto v = in_.take("VS, VY, VZ, VROLL, VYAW, VPITCH", moment ? "dddaad" : "dddaaa");
    set("motion.speed", std::abs(v[0]));
    if (v[0] < 0)
      refuse("VS below 0: a wheelset that runs backwards");
    set("motion.lateral_velocity", v[1]);
    set("motion.vertical_velocity", v[2]);
    set("motion.roll_rate", v[3]);
    set("motion.yaw_rate", v[4]);
    out_.keys.erase("motion.pitch_rate");
    out_.keys.erase("load.force_x");
    if (!moment)
      set("motion.pitch_rate",
          -v[5]); // about y, to the right: a wheel that rolls forwards turns the other way
    else if (d_.force == 1)
      set_force_along(v[5]);
    else
      refuse("F = 2: a moment on the axle; [wheelset] torque is of both wheels");
    if (d_.tang == 1)
      for (const char* key : {"motion.speed", "motion.lateral_velocity", "motion.vertical_velocity",
                              "motion.roll_rate", "motion.yaw_rate", "motion.pitch_rate"})
        out_.keys.erase(key); // a shift has none
  }

  void set_force_along(double force) {
    set("load.force_x", force);
    if (const double yaw = number("position.yaw"); yaw != 0)
      leave(
          fmt::format("FX along the axis of a wheelset that is yawed by {:g} rad: load.force_x is along the "
                      "track, and differs by the yaw times the lateral force",
                      yaw));
  }

  void read_flexibility() {
    const auto x = in_.take("DX, DY, DZ, DROLL, DYAW, DPITCH", "dddaaa");
    const auto v = in_.take("VX, VY, VZ, VROLL, VYAW, VPITCH", "dddaaa");
    set("position.wheel_lateral", x[1]);
    set("position.wheel_vertical", x[2]);
    set("position.wheel_roll", x[3]);
    set("position.wheel_yaw", x[4]);
    const char* rates[] = {"forward_velocity", "lateral_velocity", "vertical_velocity", "roll_rate",
                           "yaw_rate"};
    for (std::size_t k = 0; k < 5; ++k)
      set(fmt::format("motion.wheel_{}", rates[k]), v[k]);
    set("motion.wheel_pitch_rate", -v[5]);
  }

  // Module 3

  void read_patch() {
    set("kind", toml_text_of("patch"));
    const auto k = in_.take("FN or PEN, CKSI or FX, CETA or FY, CPHI", "ddddDD");
    read_motion();
    if (d_.varfrc == 0)
      read_friction();
    if (d_.inflcf >= 2)
      read_bodies();
    read_heat();
    if (d_.grid == 2)
      read_potential(k[0]);
    else if (!kept_.potential)
      refuse(fmt::format("D = {}: there is no potential contact yet", d_.grid));
    if (d_.z == 2 && kept_.potential.value_or(0) > 0)
      read_distance();
    else if (d_.z == 9)
      refuse("Z = 9: a distance of an earlier form of the file");
    if (d_.varfrc == 2 || d_.varfrc == 3)
      read_friction();
    set_kinematics(k);
    if (d_.e == 9)
      read_slip();
  }

  void set_kinematics(const InpFile::Values& k) {
    for (const char* key :
         {"load.force", "load.approach", "load.force_x", "load.force_s", "motion.xi", "motion.eta"})
      out_.keys.erase(key);
    set(d_.norm == 1 ? "load.force" : "load.approach", k[0]);
    set("motion.phi", -k[3]);
    if (d_.force >= 1 && d_.norm == 0)
      refuse("F >= 1 with N = 0: FX is relative to a normal force that is not given");
    const double bound = kept_.friction * k[0];
    d_.force >= 1 ? set("load.force_x", k[1] * bound) : set("motion.xi", -k[1]);
    d_.force >= 2 ? set("load.force_s", k[2] * bound) : set("motion.eta", -k[2]);
    if (k.size() > 4 && (k[4] != 0 || k[5] != 0))
      refuse("SPINXO, SPINYO: a centre of spin off the origin; write the slip as motion.slip_table");
    if (d_.tang != 0)
      set("motion.friction", kept_.friction);
    else
      for (const char* key : {"motion.xi", "motion.eta", "motion.phi", "motion.friction"})
        out_.keys.erase(key);
  }

  void read_bodies() {
    if (d_.rolls()) {
      const auto r = in_.take("CHI, DQ, VELOC", "add");
      if (r[0] != 0)
        refuse(fmt::format("CHI = {}: rolling at an angle to x", r[0]));
      kept_.dq = r[1];
      set("motion.speed", r[2]);
    }
    if (d_.inflcf == 4) {
      const auto n = in_.take("IF_METH, VARIANT, NN", "iii");
      for (int k = 0; k < n[2]; ++k)
        in_.take("surface inclinations", "da");
      refuse("C = 4: surface inclinations of a patch; write them as strip.inclination (see "
             "data/tutorial/contact.md)");
    }
    if (d_.inflcf == 9)
      in_.take("CFNAME", "s");
    read_model();
    read_material();
  }

  void read_potential(double load) {
    kept_.potential = static_cast<int>(in_.take("IPOTCN", "i")[0]);
    const int kind = *kept_.potential;
    if (kind < 0)
      return read_hertzian(kind, load);
    const auto g = in_.take("MX, MY and the place of the elements", "iidddd");
    kept_.mx = static_cast<int>(g[0]), kept_.ms = static_cast<int>(g[1]);
    const double nx = g[0], ns = g[1];
    switch (kind) {
    case 1: // left and lower edge, size
      set_elements(g[4], g[5], g[2] + nx * g[4] / 2, g[3] + ns * g[5] / 2);
      break;
    case 2: // edges
      set_elements((g[4] - g[2]) / nx, (g[5] - g[3]) / ns, (g[2] + g[4]) / 2, (g[3] + g[5]) / 2);
      break;
    case 3: // first centre, size
      set_elements(g[4], g[5], g[2] + (nx - 1) * g[4] / 2, g[3] + (ns - 1) * g[5] / 2);
      break;
    case 4: // first and last centre
      set_elements((g[4] - g[2]) / std::max(1.0, nx - 1), (g[5] - g[3]) / std::max(1.0, ns - 1),
                   (g[2] + g[4]) / 2, (g[3] + g[5]) / 2);
      break;
    default:
      refuse(fmt::format("IPOTCN = {} is not known", kind));
    }
  }

  void set_elements(double dx, double ds, double x, double s) {
    kept_.dx = dx, kept_.ds = ds, kept_.shift_x = x, kept_.shift_s = s;
    set("grid.dx", dx);
    set("grid.ds", ds);
    set("grid.mx", kept_.mx);
    set("grid.ms", kept_.ms);
    if (d_.tang == 2 && kept_.dq > 0 && std::abs(kept_.dq / dx - 1) > 1e-6)
      refuse(fmt::format("DQ = {} mm: a rolling step is dx here", kept_.dq));
  }

  /// A contact as Hertz's: curvatures, or the ellipse itself under the load.
  void read_hertzian(int kind, double load) {
    const auto h = in_.take("MX, MY and the ellipse", kind == -6 ? "iidddd" : "iiddd");
    kept_.mx = static_cast<int>(h[0]), kept_.ms = static_cast<int>(h[1]);
    double a = 0, b = 0;
    if (kind == -1)
      a = h[2], b = h[3];
    else if (kind == -2)
      a = h[2], b = h[2] / reference::hertz_curvature_ratio(h[3]);
    else
      return refuse(fmt::format("IPOTCN = {}: an ellipse or half of one instead of curvatures", kind));
    set("gap.a", a);
    set("gap.b", b);
    if (kept_.modulus <= 0)
      return refuse("an ellipse without materials");
    const auto ellipse = d_.norm == 1 ? reference::hertz_by_force(a, b, kept_.modulus, load)
                                      : reference::hertz_by_approach(a, b, kept_.modulus, load);
    set_elements(2 * h[4] * ellipse.semi_axis_x / h[0], 2 * h[4] * ellipse.semi_axis_s / h[1], 0, 0);
  }

  void read_distance() {
    const auto base = in_.take("IBASE, IPLAN", "ii");
    for (const char* key : {"gap.a", "gap.b", "gap.c", "gap.table"})
      out_.keys.erase(key);
    if (base[0] == 1)
      read_quadratic();
    else if (base[0] == 9)
      read_elementwise();
    else {
      in_.take("parameters of the distance", base[0] == 2 ? "idddd" : "dddddddd");
      refuse(fmt::format("IBASE = {}: write the undeformed distance as gap.table", base[0]));
    }
    if (base[1] != 1) {
      in_.take("planform", base[1] == 2 ? "dddddd" : "dddddddd");
      leave("IPLAN: the planform is found here");
    }
  }

  /// B1 x^2 + B2 x y + B3 y^2 + B4 x + B5 y + B6.
  void read_quadratic() {
    const auto b = in_.take("B(1) to B(6)", "dddddd");
    const double x0 = kept_.shift_x, s0 = kept_.shift_s, rounding = 1e-12;
    const double by_x = 2 * b[0] * x0 + b[1] * s0 + b[3], by_s = 2 * b[2] * s0 + b[1] * x0 + b[4],
                 at = b[0] * x0 * x0 + b[1] * x0 * s0 + b[2] * s0 * s0 + b[3] * x0 + b[4] * s0 + b[5];
    if (std::abs(by_x) < rounding && std::abs(by_s) < rounding && std::abs(at) < rounding) {
      set("gap.a", b[0]);
      set("gap.b", b[2]);
      set("gap.c", b[1]);
      return;
    }
    write_distance([&](double x, double s) {
      return at + by_x * x + by_s * s + b[0] * x * x + b[1] * x * s + b[2] * s * s;
    });
  }

  void read_elementwise() {
    const std::size_t count = static_cast<std::size_t>(kept_.mx) * kept_.ms;
    const auto h = in_.take("the undeformed distance of each element", std::string(count, 'd'));
    std::size_t k = 0;
    write_distance([&](double, double) { return h[k++]; });
  }

  /// `h`: in rising order of s, and of x within it; x and s from the middle of the grid.
  void write_distance(const auto& h) {
    std::string text = "ix,is,h\n";
    for (int j = 0; j < kept_.ms; ++j)
      for (int i = 0; i < kept_.mx; ++i)
        text += fmt::format("{},{},{:.12g}\n", i, j,
                            h((i - 0.5 * (kept_.mx - 1)) * kept_.dx, (j - 0.5 * (kept_.ms - 1)) * kept_.ds));
    out_.tables.push_back({"gap.table", std::move(text)});
  }

  /// E = 9: more slip in each element, beside that of the creepages. The rigid slip here is that of the wheel
  /// over the rail, of CONTACT the other way round.
  void read_slip() {
    const std::size_t count = static_cast<std::size_t>(kept_.mx) * kept_.ms;
    const auto w = in_.take("EXRHS of each element", std::string(2 * count, 'd'));
    if (d_.force > 0)
      return refuse("E = 9 with F >= 1: a slip table leaves no creepage to be found");
    const double xi = number("motion.xi"), eta = number("motion.eta"), phi = number("motion.phi");
    std::string text = "ix,is,wx,ws\n";
    for (int j = 0; j < kept_.ms; ++j)
      for (int i = 0; i < kept_.mx; ++i) {
        const std::size_t k = 2 * (static_cast<std::size_t>(j) * kept_.mx + i);
        const double x = (i - 0.5 * (kept_.mx - 1)) * kept_.dx, s = (j - 0.5 * (kept_.ms - 1)) * kept_.ds;
        text += fmt::format("{},{},{:.12g},{:.12g}\n", i, j, xi - phi * s - w[k], eta + phi * x - w[k + 1]);
      }
    for (const char* key : {"motion.xi", "motion.eta", "motion.phi"})
      out_.keys.erase(key);
    out_.tables.push_back({"motion.slip_table", std::move(text)});
  }

  double number(const std::string& key) const {
    const auto found = out_.keys.find(key);
    return found == out_.keys.end() ? 0 : std::stod(found->second);
  }

  InpFile& in_;
  KeptData& kept_;
  Digits d_;
  ContactCase out_;
};

/// Steps of one history: the keys that change from step to step, as columns of motion.step_table.
constexpr std::pair<const char*, const char*> step_columns[] = {
    {"load.force", "load"}, {"load.approach", "load"},   {"motion.xi", "xi"},        {"motion.eta", "eta"},
    {"motion.phi", "phi"},  {"load.force_x", "force_x"}, {"load.force_s", "force_s"}};

/// Joins a case that goes on from the tractions of the one before (P = 0) with it. False where it cannot.
bool join(ContactCase& before, const ContactCase& next) {
  if (before.module != 3 || !before.refused.empty() || !next.refused.empty() || !next.tables.empty())
    return false;
  const auto fixed = [](std::map<std::string, std::string> keys) {
    for (const auto& [key, column] : step_columns)
      keys.erase(key);
    return keys;
  };
  if (fixed(before.keys) != fixed(next.keys) || before.keys.size() != next.keys.size())
    return false;
  const auto line = [&](bool names, const ContactCase& one) {
    std::string out;
    for (const auto& [key, column] : step_columns)
      if (before.keys.contains(key))
        out += fmt::format("{}{}", out.empty() ? "" : ",", names ? column : one.keys.at(key));
    return out + "\n";
  };
  auto table = std::ranges::find(before.tables, "motion.step_table", &SceneTableFile::key);
  if (table == before.tables.end()) {
    before.tables.push_back({"motion.step_table", line(true, before) + line(false, before)});
    table = before.tables.end() - 1;
  }
  table->text += line(false, next);
  before.last = next.last;
  return true;
}

} // namespace

std::vector<ContactCase> read_contact_cases(const std::filesystem::path& file) {
  InpFile in(file);
  std::vector<ContactCase> out;
  std::map<int, KeptData> kept;
  int number = 0;
  while (!in.ended()) {
    const std::string where = in.where();
    const int module = static_cast<int>(in.take("MODULE", "i")[0]);
    if (module == 0)
      break;
    if (module != 1 && module != 3)
      throw InputError(fmt::format("{}the module {} cannot be read", where, module),
                       "wheel on rail is module 1, a patch module 3, and 0 ends the file",
                       "Leave such cases out, and what comes behind them.");
    CaseReader reader(in, kept[module], module);
    ContactCase one = reader.read();
    one.first = one.last = ++number;
    const Digits& digits = reader.digits();
    const bool goes_on =
        module == 3 && digits.previous < 2 && (digits.tang == 1 || digits.tang == 2) && number > 1;
    if (goes_on && !out.empty() && join(out.back(), one))
      continue;
    if (goes_on)
      one.refused.push_back(
          fmt::format("P = {}: it goes on from the tractions of a case with another grid, material or "
                      "distance; write them as motion.start_table",
                      digits.previous));
    out.push_back(std::move(one));
  }
  if (out.empty())
    throw InputError(fmt::format("'{}' has no case", file.string()), "no line says 1 MODULE or 3 MODULE",
                     "Give an input file (.inp) of CONTACT.");
  return out;
}

} // namespace bem_contact::app
