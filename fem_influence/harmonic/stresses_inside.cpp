#include "fem_influence/harmonic/stresses_inside.hpp"

#include "bem_contact/base/error.hpp"
#include "fem_influence/harmonic/harmonic_solver.hpp"
#include "fem_influence/harmonic/meshed_system.hpp"
#include "fem_influence/shared/body_description.hpp"
#include "fem_influence/shared/mumps_solver.hpp"
#include "fem_influence/shared/settings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace bem_contact::fem {

namespace {

/// 1 (over the smaller semi-axis). The largest wavenumber: at a depth of 0.15 semi-axes what is above it has
/// decayed to 1 % of an amplitude that is itself small.
constexpr double largest_wavenumber = 18;
/// 1 (over the longer semi-axis). Panels of the integral over wavenumbers are as wide; four Gauss points
/// each.
constexpr double panel_width = 0.9;
/// 1. Points at most, and places along x.
constexpr std::size_t most_points = 1500;
constexpr int places = 21;
/// 1 (semi-axis a). The places reach so far ahead and behind.
constexpr double reach = 1.5;
/// 1 (smaller semi-axis; b along s). Where points lie.
constexpr double least_depth = 0.15, most_depth = 2.5, most_aside = 1.0;
/// 1. Elements of the half-space along the longest row.
constexpr int flat_elements = 24;

struct Wavenumber {
  double k = 0, weight = 0;
};

/// The series f(x) = 1/(2L) F(0) + 1/L sum F(n pi/L) cos(n pi x/L): its lowest terms as they are, and the
/// others as an integral.
std::vector<Wavenumber> wavenumbers(double half_period, const EllipticalLoad& load) {
  const double unit = std::numbers::pi / half_period;
  std::vector<Wavenumber> out{{0, 0.5 / half_period}};
  for (int n = 1; n <= settings::exact_harmonics; ++n)
    out.push_back({n * unit, 1 / half_period});
  constexpr std::array<double, 4> point{-0.8611363115940526, -0.3399810435848563, 0.3399810435848563,
                                        0.8611363115940526},
      weight{0.3478548451374538, 0.6521451548625461, 0.6521451548625461, 0.3478548451374538};
  const double last = largest_wavenumber / std::min(load.a, load.b),
               widest = panel_width / std::max(load.a, load.b);
  for (double from = (settings::exact_harmonics + 0.5) * unit; from < last;) {
    const double width = std::min(from, widest);
    for (std::size_t i = 0; i < point.size(); ++i)
      out.push_back({from + 0.5 * width * (1 + point[i]), 0.5 * width * weight[i] / std::numbers::pi});
    from += width;
  }
  return out;
}

/// Half length of the load on a row, mm, and its pressure in the middle, MPa; 0 beside the load.
struct LoadedRow {
  double half = 0, pressure = 0;

  LoadedRow(const EllipticalLoad& load, double s) {
    const double share = 1 - std::pow((s - load.s) / load.b, 2);
    if (share > 0) {
      half = load.a * std::sqrt(share);
      pressure = load.pressure * std::sqrt(share);
    }
  }
  /// Integral of the pressure times cos kx.
  double transform(double k) const {
    const double z = k * half;
    return std::numbers::pi * pressure * half * (z < 1e-6 ? 0.5 : std::cyl_bessel_j(1, z) / z);
  }
  double at(double x) const {
    return half > 0 ? pressure * std::sqrt(std::max(0.0, 1 - x * x / (half * half))) : 0;
  }
};

/// A quadrature point with the shapes of its cell.
struct Probe {
  std::vector<int> nodes;
  std::vector<double> value, d_dy, d_dz;
  Point2 position;
  double delta = 0; ///< of the nearest point of the surface
};

class Inside {
public:
  Inside(const BodyFile& given, const ProfileCurve& curve, const std::filesystem::path& mesh,
         const EllipticalLoad& load)
      : body_(without_levels(given)), curve_(curve), load_(load),
        stations_(make_stations(body_.strip, curve)), radius_(reference_radius_of(body_)) {
    require_within_strip();
    require_mesh_of(given, curve, mesh);
    Timing timing;
    MeshedSystem meshed(body_, curve, mesh, {}, timing);
    find_probes(*meshed.section);
    AssembledSystem assembled = add_matrices(std::move(meshed), timing);
    system_ = std::move(assembled.system);
    renumber(system_, assembled.order);
    const double edge = reach * load.a;
    for (int i = 0; i < places; ++i)
      out_.x.push_back(-edge + 2 * edge * i / (places - 1));
    for (StressesAtPoint& p : out_.points)
      p.body.resize(out_.x.size());
    out_.unknowns = system_.unknowns();
  }

  StressesInside compute(const std::function<void(std::size_t, std::size_t)>& progress) {
    const std::vector<Wavenumber> all = wavenumbers(half_period_of(body_), load_);
    MumpsSolver solver(static_cast<int>(system_.unknowns()), unknowns_of_cells(system_));
    std::vector<double> matrix;
    for (const Wavenumber& one : all) {
      evaluate(system_, one.k, matrix);
      solver.factorize(matrix);
      solver.solve(loads(one.k), [&](std::size_t column, std::span<const double> solution) {
        add(one, column == 1, solution);
      });
      progress(static_cast<std::size_t>(&one - all.data()) + 1, all.size());
    }
    out_.wavenumbers = all.size();
    add_flat();
    return std::move(out_);
  }

private:
  static BodyFile without_levels(BodyFile body) {
    body.harmonic.border_levels = 0; // the load has no jumps worth them
    return body;
  }
  void require_within_strip() const {
    if (load_.s - load_.b < body_.strip.from || load_.s + load_.b > body_.strip.to)
      throw InputError("The load leaves the strip", "its rows need stations",
                       "Move it, or give the body a longer strip.");
  }
  double rho(double z) const { return radius_ == 0 ? 1 : (radius_ + z) / radius_; }

  void find_probes(const Section& section) {
    const double size = std::min(load_.a, load_.b);
    std::vector<Probe> found;
    std::vector<StressesAtPoint> places_found;
    section.for_each_cell([&](const CellView& cell) {
      const Point2 middle = curve_.at(load_.s).position;
      if (std::hypot(cell.centre.y - middle.y, cell.centre.z - middle.z) > 4 * std::max(load_.a, load_.b))
        return;
      const std::size_t n = cell.nodes.size();
      for (std::size_t q = 0; q < cell.points.size(); ++q) {
        const Point2 p = cell.points[q].position;
        const CurvePoint above = curve_.nearest(p);
        const double depth = std::hypot(p.y - above.position.y, p.z - above.position.z);
        if (std::abs(above.s - load_.s) > most_aside * load_.b || depth < least_depth * size ||
            depth > most_depth * size)
          continue;
        const auto part = [&](std::span<const double> all) {
          return std::vector<double>(all.begin() + static_cast<std::ptrdiff_t>(q * n),
                                     all.begin() + static_cast<std::ptrdiff_t>((q + 1) * n));
        };
        found.push_back({{cell.nodes.begin(), cell.nodes.end()},
                         part(cell.value),
                         part(cell.d_dy),
                         part(cell.d_dz),
                         p,
                         above.delta});
        places_found.push_back({above.s, depth, {}, {}});
      }
    });
    const std::size_t every = found.size() / most_points + 1;
    for (std::size_t i = 0; i < found.size(); i += every) {
      probes_.push_back(std::move(found[i]));
      out_.points.push_back(std::move(places_found[i]));
    }
    if (probes_.empty())
      throw InputError("There is nothing below the load", "no point of the mesh lies within its reach",
                       "Give another place, or a finer mesh.");
  }

  /// Two columns: the pressure, and the traction along x.
  SparseColumns loads(double k) const {
    SparseColumns out;
    for (const int component : {int(component_n), int(component_x)}) {
      std::vector<double> sum(system_.unknowns(), 0);
      for (std::size_t J = 0; J < stations_.size(); ++J) {
        const double share = rho(stations_[J].position.z);
        const double amount = LoadedRow(load_, stations_[J].s).transform(k / share) *
                              (component == component_x ? load_.friction : 1.0);
        if (amount != 0)
          system_.functionals.for_each_entry(
              3 * J + static_cast<std::size_t>(component),
              [&](int row, double value) { sum[static_cast<std::size_t>(row)] += amount * value; });
      }
      for (std::size_t row = 0; row < sum.size(); ++row)
        if (sum[row] != 0)
          out.add(static_cast<int>(row), sum[row]);
      if (component == component_n || load_.friction != 0)
        out.end_column();
    }
    return out;
  }

  /// Adds what a wavenumber gives. `along`: the traction along x, whose displacement is the same a quarter of
  /// a wave ahead (THEORY.md, section 2).
  void add(const Wavenumber& one, bool along, std::span<const double> solution) {
    const double k = one.k, mu = system_.op.mu, lambda = system_.op.lambda;
    const double place = rho(curve_.at(load_.s).position.z);
    for (std::size_t i = 0; i < probes_.size(); ++i) {
      const Probe& probe = probes_[i];
      std::array<double, 3> u{}, uy{}, uz{};
      for (std::size_t a = 0; a < probe.nodes.size(); ++a)
        for (std::size_t c = 0; c < 3; ++c)
          if (const int row = system_.unknown[3 * static_cast<std::size_t>(probe.nodes[a]) + c]; row >= 0) {
            const double v = solution[static_cast<std::size_t>(row)];
            u[c] += probe.value[a] * v;
            uy[c] += probe.d_dy[a] * v;
            uz[c] += probe.d_dz[a] * v;
          }
      const double r = rho(probe.position.z), over_r = radius_ == 0 ? 0 : 1 / (radius_ + probe.position.z);
      const double e_xx = k / r * u[0] + over_r * u[2], e_yy = uy[1], e_zz = uz[2];
      const double trace = lambda * (e_xx + e_yy + e_zz);
      const double xx = trace + 2 * mu * e_xx, yy = trace + 2 * mu * e_yy, zz = trace + 2 * mu * e_zz,
                   yz = mu * (uz[1] + uy[2]), xy = mu * (uy[0] - k / r * u[1]),
                   xz = mu * (uz[0] - over_r * u[0] - k / r * u[2]);
      const double c = std::cos(probe.delta), s = std::sin(probe.delta);
      const halfspace::Stress even{
          xx, yy * c * c + zz * s * s + 2 * yz * c * s, yy * s * s + zz * c * c - 2 * yz * c * s, 0,
          0,  (zz - yy) * c * s + yz * (c * c - s * s)},
          odd{0, 0, 0, xy * c + xz * s, xz * c - xy * s, 0};
      for (std::size_t j = 0; j < out_.x.size(); ++j) {
        const double phase = k * out_.x[j] / place + (along ? std::numbers::pi / 2 : 0);
        out_.points[i].body[j].add(one.weight * std::cos(phase), even).add(one.weight * std::sin(phase), odd);
      }
    }
  }

  /// The half-space's stresses at the same points, by elements as long as a station is wide or so.
  void add_flat() {
    const double dx = 2 * load_.a / flat_elements, ds = body_.strip.station_width;
    const double poisson = body_.material.poisson;
    for (StressesAtPoint& p : out_.points) {
      p.flat.resize(out_.x.size());
      for (const Station& station : stations_) {
        const LoadedRow row(load_, station.s);
        if (row.half == 0)
          continue;
        for (int e = 0; e < flat_elements; ++e) {
          const double middle = -load_.a + (e + 0.5) * dx;
          double pressure = 0;
          for (int i = 0; i < 8; ++i)
            pressure += row.at(middle + dx * ((i + 0.5) / 8 - 0.5)) / 8;
          if (pressure == 0)
            continue;
          for (std::size_t j = 0; j < out_.x.size(); ++j) {
            const auto unit = halfspace::rectangle_stress(poisson, out_.x[j] - middle, p.s - station.s,
                                                          p.depth, 0.5 * dx, 0.5 * ds);
            p.flat[j].add(pressure, unit[component_n]).add(load_.friction * pressure, unit[component_x]);
          }
        }
      }
    }
  }

  BodyFile body_;
  const ProfileCurve& curve_;
  EllipticalLoad load_;
  std::vector<Station> stations_;
  double radius_;
  std::vector<Probe> probes_;
  HarmonicSystem system_;
  StressesInside out_;
};

} // namespace

StressesInside stresses_inside(const BodyFile& body, const ProfileCurve& curve,
                               const std::filesystem::path& mesh, const EllipticalLoad& load,
                               const std::function<void(std::size_t, std::size_t)>& progress) {
  return Inside(body, curve, mesh, load).compute(progress);
}

} // namespace bem_contact::fem
