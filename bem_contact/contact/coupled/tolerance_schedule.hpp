#pragma once

namespace bem_contact::contact {

/// How precisely the normal and the tangential problem of each outer iteration are solved. Each is only as
/// precise as the other one is known so far: more would be wasted work.
class ToleranceSchedule {
public:
  /// `asked`: SolverOptions::tolerance. `loose`: the first iterations are; else it is asked for at once, as
  /// in problems that are not coupled and solved once.
  ToleranceSchedule(double asked, bool loose);

  /// Tolerance of the next outer iteration.
  double now() const { return now_; }
  /// Says whether an outer iteration that changes so little (relative) may be the last.
  bool is_close(double change) const;
  /// Says whether the outer iteration is the last one: it is close, and was solved precisely too.
  bool is_settled(double change) const { return is_close(change) && now_ <= asked_; }
  /// Sets the tolerance after an outer iteration with this change. `remaining_change`: the share of it that
  /// is expected of the next one; if that will be close, it may be the last and is solved precisely. `share`:
  /// prescribed force over force of the pressure; if it is small, the force is a small difference of large
  /// ones and needs a tighter tolerance.
  void tighten(double change, double remaining_change, double share);

private:
  double asked_, now_;
};

} // namespace bem_contact::contact
