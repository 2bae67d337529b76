#include "fem_influence/commands.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/profile/bodies/body_file.hpp"
#include "bem_contact/profile/standard_profiles.hpp"
#include "fem_influence/harmonic/stresses_inside.hpp"
#include "fem_influence/progress_bar.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <array>
#include <cmath>
#include <ostream>

namespace bem_contact::fem {

namespace {

EllipticalLoad load_of(const std::vector<double>& ellipse) {
  const EllipticalLoad load{ellipse.at(0), ellipse.at(1), ellipse.at(2), ellipse.at(3), ellipse.at(4)};
  const bool positive = load.a > 0 && load.b > 0 && load.pressure > 0 && load.friction >= 0;
  if (!positive || !std::isfinite(load.s + load.a + load.b + load.pressure + load.friction))
    throw InputError("This ellipse is no load",
                     "it needs semi-axes and a pressure above 0, and friction of 0 or more",
                     "Give --ellipse S A B P0 MU.");
  return load;
}

/// The largest value of one kind, and where it is.
struct Peak {
  double value = 0, depth = 0;
};

template <class Measure>
Peak peak_of(const StressesInside& inside, std::vector<halfspace::Stress> StressesAtPoint::*which,
             Measure measure) {
  Peak out;
  for (const StressesAtPoint& p : inside.points)
    for (const halfspace::Stress& t : p.*which)
      if (const double value = measure(t); value > out.value)
        out = {value, p.depth};
  return out;
}

void print(const StressesInside& inside) {
  fmt::print(stderr, "{} unknowns, {} wavenumbers, {} points\n", inside.unknowns, inside.wavenumbers,
             inside.points.size());
  using Kind = std::pair<const char*, double (*)(const halfspace::Stress&)>;
  for (const auto& [name, measure] :
       {Kind{"largest shear", halfspace::largest_shear}, Kind{"von Mises", halfspace::von_mises}}) {
    const Peak body = peak_of(inside, &StressesAtPoint::body, measure),
               flat = peak_of(inside, &StressesAtPoint::flat, measure);
    fmt::print(stderr,
               "  {}: {:.1f} MPa {:.2f} mm deep in the body, {:.1f} MPa {:.2f} mm deep in a half-space "
               "({:+.1f} %)\n",
               name, body.value, body.depth, flat.value, flat.depth, 100 * (body.value / flat.value - 1));
  }
}

void write(std::ostream& out, const StressesInside& inside) {
  fmt::print(out, "s,depth,x,xx,ss,nn,xs,xn,sn,flat_xx,flat_ss,flat_nn,flat_xs,flat_xn,flat_sn\n");
  for (const StressesAtPoint& p : inside.points)
    for (std::size_t j = 0; j < inside.x.size(); ++j) {
      fmt::print(out, "{:.6g},{:.6g},{:.6g}", p.s, p.depth, inside.x[j]);
      for (const halfspace::Stress& t : {p.body[j], p.flat[j]})
        fmt::print(out, ",{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}", t.xx, t.ss, t.nn, t.xs, t.xn, t.sn);
      fmt::print(out, "\n");
    }
}

} // namespace

void stress_command(const std::string& body_file, const std::string& mesh, const std::string& output,
                    const std::vector<double>& ellipse) {
  const BodyFile body = read_body_file(body_file);
  require_outputs({body_file, profile_file_of(body), mesh}, {{"--stresses", output, OutputForm::text}});
  const ProfileCurve curve = body_profile(body);
  ProgressBar bar("wavenumbers");
  const StressesInside inside = stresses_inside(
      body, curve, mesh, load_of(ellipse), [&](std::size_t done, std::size_t all) { bar.show(done, all); });
  print(inside);
  write_text(output, [&](std::ostream& out) { write(out, inside); });
}

} // namespace bem_contact::fem
