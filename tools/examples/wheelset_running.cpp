// The coned wheelset of wheelset_running.py in C++, through the installed package: one free wheelset on
// straight track, and every wheel-rail force a solution of bem_contact. README.md beside this file says what
// you should see.
//
//     cmake -S tools/examples -B build-examples -DCMAKE_PREFIX_PATH=PREFIX && cmake --build build-examples
//     build-examples/wheelset_running tools/examples/coned_wheelset.toml
//
// Units mm, N, s, rad. The exit code is 1 if a wave or a speed is not what the textbook says.

#include "coned_theory.hpp"

#include <bem_contact/base/error.hpp>
#include <bem_contact/scene/scene_reader.hpp>
#include <bem_contact/sequence/sequence.hpp>

#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <vector>

namespace {

using Clock = std::chrono::steady_clock;
using State = std::array<double, 4>; ///< y, psi, dy/dt, dpsi/dt

/// How far the wheelset's centre stands below its nominal height, mm, and roll, right side down.
struct Stand {
  double height = 0, roll = 0;
};

/// On the rail, track axes, about the wheelset's centre.
struct Forces {
  double fx = 0, fy = 0, fz = 0, mx = 0, mz = 0, approach = 0;
};

/// One of the two wheels: a scene read once, and a sequence whose cases start from the one before.
class Wheel {
public:
  Wheel(const std::filesystem::path& file, bool left, bool warm)
      : scene_(bem_contact::read_scene_text(file)), sequence_(options(warm)), sign_(left ? -1 : 1) {
    scene_.set({"position.side", std::string(left ? "left" : "right")});
  }

  /// `turning`: angular speed about the axle.
  Forces forces(const State& state, Stand stand, double roll_rate, double speed, double turning) {
    const std::pair<const char*, double> values[] = {
        {"position.lateral", state[0]}, {"position.yaw", state[1]},
        {"position.roll", stand.roll},  {"position.vertical", stand.height},
        {"motion.speed", speed},        {"motion.lateral_velocity", state[2]},
        {"motion.yaw_rate", state[3]},  {"motion.pitch_rate", turning},
        {"motion.roll_rate", roll_rate}};
    for (const auto& [key, value] : values)
      scene_.set_number(key, value);
    const Clock::time_point begin = Clock::now();
    const bem_contact::SceneResult solved = sequence_.solve(scene_.scene());
    microseconds += std::chrono::duration<double, std::micro>(Clock::now() - begin).count();
    ++solutions;
    if (!solved.result.trust.certificate.holds())
      throw bem_contact::ConvergenceError("A time step has no solution", "its certificate does not hold",
                                          "Coarsen the grid.");
    return sum(solved, sign_ * state[0], stand.height - radius);
  }

  double microseconds = 0;
  int solutions = 0;

private:
  static bem_contact::SequenceOptions options(bool warm) {
    bem_contact::SequenceOptions out;
    out.ablation.keep_start = out.ablation.keep_numbers = out.ablation.learn = warm;
    out.displacements = false;
    return out;
  }

  /// Sums of the tractions. The left wheel is a mirror image: what points along y changes sign, and so do
  /// moments about x and z.
  Forces sum(const bem_contact::SceneResult& solved, double y0, double z0) const {
    const auto& [mx, ms, dx, ds, x0] = solved.problem.grid;
    const auto& result = solved.result;
    Forces f{.approach = result.totals.approach};
    for (std::size_t i = 0; i < result.pn.size(); ++i) {
      const bem_contact::ContactRow& row = solved.problem.rows[i / mx];
      const double x = x0 + dx * static_cast<double>(i % mx);
      const double y = row.position.y - y0, z = row.position.z - z0;
      const double c = std::cos(row.delta), s = std::sin(row.delta), area = dx * ds;
      const double fx = area * result.px[i], fy = area * (c * result.ps[i] - s * result.pn[i]),
                   fz = area * (s * result.ps[i] + c * result.pn[i]);
      f.fx += fx;
      f.fy += sign_ * fy;
      f.fz += fz;
      f.mx += sign_ * (y * fz - z * fy);
      f.mz += sign_ * (x * fy - y * fx);
    }
    return f;
  }

  bem_contact::SceneReader scene_;
  bem_contact::Sequence sequence_;
  double sign_;
};

/// Wheelset, springs and rails. Its angular speed about the axle is that at which it rolls freely in the
/// middle: small motions do not change it.
class Track {
public:
  Track(const std::filesystem::path& scene, double speed, Springs springs, bool warm = true)
      : right(scene, false, warm), left(scene, true, warm), speed_(speed), springs_(springs) {
    turn_freely();
    equilibrium({1, 0, 0, 0});
    roll_slope_ = stand_.roll; // over y, 1/mm
    equilibrium({0, 0, 0, 0});
  }

  State operator()(const State& s) {
    const auto [r, l] = equilibrium(s);
    return {s[2], s[3], (-r.fy - l.fy - springs_.lateral * s[0]) / mass,
            (-r.mz - l.mz - springs_.yaw * s[1]) / yaw_inertia};
  }

  Wheel right, left;

private:
  /// Height and roll at which the contacts carry the weight: Newton's method with Hertz's stiffness 3/2 Fz /
  /// approach.
  std::pair<Forces, Forces> equilibrium(const State& s) {
    const double arm = ConedPair{}.half_distance();
    stand_.roll += roll_slope_ * (s[0] - lateral_);
    lateral_ = s[0];
    for (int i = 0; i < 30; ++i) {
      const Forces r = right.forces(s, stand_, roll_slope_ * s[2], speed_, turning_),
                   l = left.forces(s, stand_, roll_slope_ * s[2], speed_, turning_);
      const double force = weight - r.fz - l.fz, moment = -r.mx - l.mx;
      if (std::abs(force) + std::abs(moment) / arm < 1e-5 * weight)
        return {r, l};
      // How much more each wheel has to approach for its part of what is missing.
      const double at_right = 0.5 * (force + moment / arm) * r.approach / (1.5 * r.fz),
                   at_left = 0.5 * (force - moment / arm) * l.approach / (1.5 * l.fz);
      stand_.height += 0.5 * (at_right + at_left);
      stand_.roll += 0.5 * (at_right - at_left) / arm;
    }
    throw bem_contact::ConvergenceError("The wheelset does not stand", "no height and roll carry its weight",
                                        "Begin nearer to the middle of the track.");
  }

  double longitudinal(double turning) {
    turning_ = turning;
    const auto [r, l] = equilibrium({0, 0, 0, 0});
    return r.fx + l.fx;
  }
  void turn_freely() { // the method of secants
    double before = speed_ / radius, now = 0.9999 * before, force = longitudinal(before);
    for (int i = 0; i < 10 && std::abs(now - before) > 1e-8 * now; ++i) {
      const double last = force;
      force = longitudinal(now);
      const double next = now - force * (now - before) / (force - last);
      before = now, now = next;
    }
    turning_ = now;
  }

  double speed_, turning_ = 0, roll_slope_ = 0;
  Springs springs_;
  Stand stand_{-0.03, 0}; ///< the last one,
  double lateral_ = 0;    ///< and where that was, mm
};

struct Motion {
  std::vector<double> time, y;
  double microseconds = 0; ///< a time step
};

/// The classical method of Runge and Kutta.
Motion run(Track& track, State state, double duration, int steps) {
  Motion motion;
  const double h = duration / steps;
  const auto along = [](const State& from, double by, const State& slope) {
    State to = from;
    for (std::size_t i = 0; i < to.size(); ++i)
      to[i] += by * slope[i];
    return to;
  };
  const Clock::time_point begin = Clock::now();
  for (int i = 0; i <= steps; ++i) {
    motion.time.push_back(i * h);
    motion.y.push_back(state[0]);
    const State a = track(state), b = track(along(state, h / 2, a)), c = track(along(state, h / 2, b)),
                d = track(along(state, h, c));
    for (std::size_t j = 0; j < state.size(); ++j)
      state[j] += h / 6 * (a[j] + 2 * b[j] + 2 * c[j] + d[j]);
  }
  motion.microseconds = std::chrono::duration<double, std::micro>(Clock::now() - begin).count() /
                        static_cast<double>(steps + 1);
  return motion;
}

/// Growth rate and angular frequency of a motion, which is y'' - 2 growth y' + (growth^2 + frequency^2) y = 0
/// in the mean squares: equal samples of it obey y[i+1] + q y[i-1] = p y[i] with q = exp(2 growth h), p = 2
/// exp(growth h) cos(frequency h). The first half period is left out, `apart` samples lie between neighbours.
Oscillation oscillation_of(const Motion& motion, double period) {
  double aa = 0, ab = 0, bb = 0, ac = 0, bc = 0;
  const double h = motion.time[1];
  const auto apart = static_cast<std::size_t>(std::lround(period / 5 / h));
  for (std::size_t i = static_cast<std::size_t>(period / 2 / h) + apart; i + apart < motion.y.size(); ++i) {
    const double a = motion.y[i], b = -motion.y[i - apart], c = motion.y[i + apart];
    aa += a * a, ab += a * b, bb += b * b, ac += a * c, bc += b * c;
  }
  const double p = (ac * bb - bc * ab) / (aa * bb - ab * ab), q = (bc * aa - ac * ab) / (aa * bb - ab * ab);
  const double between = h * static_cast<double>(apart);
  return {std::log(q) / 2 / between, std::acos(p / 2 / std::sqrt(q)) / between};
}

bool within(const char* what, double found, double expected, double bar, const char* unit) {
  const double off = found / expected - 1;
  std::printf("%s: %.2f %s, %.2f %s by the textbook (%+.2f %%)\n", what, found / 1000, unit, expected / 1000,
              unit, 100 * off);
  return std::abs(off) < bar;
}

bool klingel(const std::filesystem::path& scene) {
  const double speed = 4e4;
  const Springs none{0, 0};
  const Oscillation expected = least_damped(speed, none);
  Track track(scene, speed, none);
  const double period = 2 * pi / expected.frequency;
  const Motion motion = run(track, expected.start(0.5), 1.5 * period, 180);
  return within("Klingel's wave", 2 * pi * speed / oscillation_of(motion, period).frequency,
                ConedPair{}.klingel(), 0.01, "m");
}

bool critical(const std::filesystem::path& scene) {
  const Springs springs;
  const double expected = critical_speed(springs);
  double speeds[] = {0.95 * expected, 1.05 * expected}, rates[2];
  for (int i = 0; i < 2; ++i) {
    const Oscillation mode = least_damped(speeds[i], springs);
    const double period = 2 * pi / mode.frequency;
    Track track(scene, speeds[i], springs);
    rates[i] = oscillation_of(run(track, mode.start(1.0), 2 * period, 120), period).growth;
  }
  const double found = speeds[0] - rates[0] * (speeds[1] - speeds[0]) / (rates[1] - rates[0]);
  return within("critical speed", found, expected, 0.02, "m/s");
}

void cost(const std::filesystem::path& scene) {
  for (const bool warm : {true, false}) {
    const Springs springs;
    Track track(scene, 6e4, springs, warm);
    track.right.microseconds = track.left.microseconds = 0;
    track.right.solutions = track.left.solutions = 0;
    const Motion motion = run(track, least_damped(6e4, springs).start(1.0), 0.1, 20);
    std::printf("cost, %s start: %.0f microseconds a solution, %.0f a time step\n", warm ? "warm" : "cold",
                (track.right.microseconds + track.left.microseconds) /
                    (track.right.solutions + track.left.solutions),
                motion.microseconds);
  }
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: wheelset_running coned_wheelset.toml\n");
    return 2;
  }
  try {
    const bool wave = klingel(argv[1]), speed = critical(argv[1]);
    cost(argv[1]);
    return wave && speed ? 0 : 1;
  } catch (const bem_contact::Error& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 2;
  }
}
