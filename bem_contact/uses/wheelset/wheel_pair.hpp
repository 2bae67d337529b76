#pragma once

#include "bem_contact/sequence/scene_result.hpp"
#include "bem_contact/sequence/sequence.hpp"

#include <atomic>

namespace bem_contact {

/// Forces and moments on the rail: N, N mm; components along x, y, z.
struct Wrench {
  Vector3 force{}, moment{};

  Wrench& operator+=(const Wrench& other);
};
/// Sum, about the same point.
Wrench operator+(Wrench a, const Wrench& b);
/// Multiple.
Wrench operator*(double factor, Wrench w);

/// Of a force at a point, components along x, y, z. `arm`: from the point that the moment is about to the
/// point of the force.
Wrench wrench_at(const Vector3& force, const Vector3& arm);

/// What the plane through the middle of the track mirrors: y of vectors changes sign, and x and z of moments.
Wrench mirrored(Wrench w);

/// Sums of all tractions of a result in the track frame of its side (of a left wheel: y to the left), about
/// `centre` (y, z in that frame; x = 0), mm.
Wrench wrench_of(const SceneResult& result, Point2 centre);

/// Where a wheelset stands and how it turns. Mirror images of it have lateral, roll and yaw of other sign.
struct WheelsetPose {
  double lateral = 0;  ///< of its centre, mm, to the right
  double vertical = 0; ///< of its centre plus wheel_radius, mm, down
  double roll = 0;     ///< rad, right side down
  /// V over the angular speed of the axle, mm; empty: as the scene gives it (or without friction).
  std::optional<double> rolling_radius;
};

/// Both wheels of a wheelset at one pose. The left wheel is solved as a right one in the mirrored track frame
/// (geometry/placement.hpp); its SceneResult stays in that frame, all wrenches are turned back.
struct WheelsetState {
  WheelsetPose pose;
  double yaw = 0, wheel_radius = 0;     ///< rad, mm
  SceneResult right, left;              ///< SceneResult::left says which
  Wrench right_wrench{}, left_wrench{}; ///< on the rails, track frame, about the wheelset's centre

  const SceneResult& solved(WheelSide side) const { return side == WheelSide::right ? right : left; }
  const Wrench& wrench(WheelSide side) const { return side == WheelSide::right ? right_wrench : left_wrench; }
  Wrench sum() const { return right_wrench + left_wrench; }
  /// About the forward axis through the wheelset's centre, N mm: what does work as the wheelset rolls.
  double roll_moment(const Wrench& w) const;
  /// Torque that must drive the axle against these forces on the rails, N mm.
  double torque(const Wrench& w) const;
  bool certified() const { return right.result.converged && left.result.converged; }
};

/// Solves both wheels, each with a sequence of its own, so that a wheel starts from its own last solution.
/// Both share files; null: files of their own. The scene is one with [wheelset].
class WheelPair {
public:
  explicit WheelPair(const SceneFile& scene, const std::atomic<bool>* stop = nullptr,
                     std::shared_ptr<SequenceFiles> files = nullptr);

  /// Throws what Sequence::solve() throws.
  WheelsetState at(const WheelsetPose& pose);
  /// What would be solved of one wheel. Throws what Sequence::check() throws.
  SceneDescription check(WheelSide side, const WheelsetPose& pose);
  /// As at(), with the elements and models that the scene asks for. From here on the models found here are
  /// kept, and the elements, `factor` times as long and wide.
  WheelsetState choose_elements(const WheelsetPose& pose, double factor = 1);
  /// By how much the wheelset is lowered until that wheel touches its rail, from where vertical is 0, mm.
  /// Throws InputError where it does not.
  double lowered(WheelSide side, double lateral, double roll);

  const SceneFile& scene() const { return scene_; }
  int contact_problems() const; ///< solutions so far

private:
  void free_elements(); ///< elements and models are those that the scene asks for
  SceneFile wheel_scene(WheelSide side, const WheelsetPose& pose) const;

  SceneFile scene_;
  SceneFile right_scene_, left_scene_; ///< perhaps with elements and model fixed
  const std::atomic<bool>* stop_;
  std::shared_ptr<SequenceFiles> files_;
  Sequence right_, left_;
};

} // namespace bem_contact
