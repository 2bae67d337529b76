#pragma once

#include "bem_contact/sequence/scene_result.hpp"
#include "bem_contact/sequence/sequence.hpp"

#include <atomic>
#include <optional>
#include <string>

namespace bem_contact {

/// A force on the rail and its moment about a point. Components along x (forward), y (to the right) and z
/// (down) of the track frame, unless a function says another frame.
struct Wrench {
  Vector3 force{};  ///< N
  Vector3 moment{}; ///< N mm

  /// Adds one about the same point, in the same frame.
  Wrench& operator+=(const Wrench& other);
};
/// The sum of two about the same point, in the same frame.
Wrench operator+(Wrench a, const Wrench& b);
/// Force and moment, both times the factor.
Wrench operator*(double factor, Wrench w);

/// The wrench of a force (N) about a point. `arm`: from that point to the point where the force acts, mm. The
/// result has the frame of both.
Wrench wrench_at(const Vector3& force, const Vector3& arm);

/// The mirror image by the plane through the middle of the track (y = 0): y of the force changes sign, and x
/// and z of the moment.
Wrench mirrored(Wrench w);

/// Sums of all tractions of a result in the track frame of its side (of a left wheel: y to the left), about
/// `centre` (y, z in that frame; x = 0), mm. `roller`: on which it is solved, unrolled; the sums are those in
/// space.
Wrench wrench_of(const SceneResult& result, Point2 centre, const std::optional<Roller>& roller = {});

/// Where a wheelset stands, in the track frame. Its mirror image has lateral, roll and yaw of other sign.
struct WheelsetPose {
  double lateral = 0;  ///< of its centre, mm, to the right
  double vertical = 0; ///< of its centre plus wheel_radius, mm, down
  double roll = 0;     ///< rad, right side down
  /// Forward speed divided by the angular speed of the axle, mm; empty: as the scene gives it (or without
  /// friction).
  std::optional<double> rolling_radius;
};

/// Both wheels of a wheelset at one pose. The left wheel is solved as a right one in the mirrored track frame
/// (geometry/placement.hpp); its SceneResult stays in that frame, all wrenches are turned back.
struct WheelsetState {
  WheelsetPose pose;                    ///< at which both were solved
  double yaw = 0;                       ///< rad, as position.yaw
  double wheel_radius = 0;              ///< at the tape circle, of the right wheel, mm
  double left_wheel_radius = 0;         ///< of the left one, mm
  SceneResult right, left;              ///< SceneResult::left says which
  Wrench right_wrench{}, left_wrench{}; ///< on the rails, track frame, about the wheelset's centre

  /// The result of one wheel, in the track frame of its side.
  const SceneResult& solved(WheelSide side) const { return side == WheelSide::right ? right : left; }
  /// The radius of one wheel at its tape circle, mm.
  double radius(WheelSide side) const { return side == WheelSide::right ? wheel_radius : left_wheel_radius; }
  /// What one wheel does to its rail: track frame, about the wheelset's centre.
  const Wrench& wrench(WheelSide side) const { return side == WheelSide::right ? right_wrench : left_wrench; }
  /// On both rails: track frame, about the wheelset's centre.
  Wrench sum() const { return right_wrench + left_wrench; }
  /// About the forward axis through the wheelset's centre, N mm: what does work as the wheelset rolls.
  double roll_moment(const Wrench& w) const;
  /// Torque that must drive the axle against these forces on the rails, N mm.
  double torque(const Wrench& w) const;
};

/// Whether both wheels are certified.
inline bool certified(const WheelsetState& state) {
  return certified(state.right) && certified(state.left);
}

/// Solves both wheels, each with a sequence of its own, so that a wheel starts from its own last solution.
/// The scene is one with [wheelset].
class WheelPair {
public:
  /// `stop`: another thread sets it to end a solution (Stopped); null: nobody does. `files`: shared with
  /// other sequences of this thread; null: the pair's own.
  explicit WheelPair(const SceneFile& scene, const std::atomic<bool>* stop = nullptr,
                     std::shared_ptr<SequenceFiles> files = nullptr);

  /// Solves both wheels at this pose. Throws what Sequence::solve() throws. `derivatives`: both results have
  /// those with respect to the pose ("load" is its height); throws InputError where there are none.
  WheelsetState at(const WheelsetPose& pose, bool derivatives = false);
  /// What would be solved of one wheel. Throws what Sequence::check() throws.
  SceneDescription check(WheelSide side, const WheelsetPose& pose);
  /// As at(), with the elements and models that the scene asks for. From here on the models found here are
  /// kept, and the elements, `factor` times as long and wide. Both wheels get the same elements if those of
  /// one would nearly do for the other: in the mirror nothing then distinguishes the sides.
  WheelsetState choose_elements(const WheelsetPose& pose, double factor = 1);
  /// How far the wheelset is lowered from vertical = 0 until that wheel touches its rail, mm, at a lateral
  /// displacement (mm) and a roll (rad). Throws InputError where it does not touch.
  double lowered(WheelSide side, double lateral, double roll);

  /// The same, with the model that the scene asks for and the elements that `like` has.
  WheelsetState choose_model(const WheelsetPose& pose, const WheelPair& like);

  const SceneFile& scene() const { return scene_; } ///< as given
  int contact_problems() const;                     ///< solved so far, of both wheels

private:
  void free_elements(); ///< elements and models are those that the scene asks for
  const SceneFile& scene_of(WheelSide side) const {
    return side == WheelSide::right ? right_scene_ : left_scene_;
  }
  /// How much larger a wheel is than position.wheel_radius, mm.
  double larger(WheelSide side) const {
    return scene_of(side).position.wheel_radius - scene_.position.wheel_radius;
  }
  SceneFile wheel_scene(WheelSide side, const WheelsetPose& pose, bool derivatives = false) const;

  void keep_models(const WheelsetState& s);

  SceneFile scene_;
  SceneFile right_scene_, left_scene_;                    ///< perhaps with elements and model fixed
  std::optional<ModelChoice> right_choice_, left_choice_; ///< where the scene left it open and it is fixed
  const std::atomic<bool>* stop_;
  std::shared_ptr<SequenceFiles> files_;
  Sequence right_, left_;
};

} // namespace bem_contact
