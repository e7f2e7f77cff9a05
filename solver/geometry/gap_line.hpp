#pragma once

namespace dld {

/// The line x = `x` (relative to the pillar's centre) on which the lane between pillar (0,0) and pillar (0,1)
/// is narrowest, from wall to wall. All lengths in the unit of whoever asks for it.
struct GapLine {
  double x = 0;
  double lower = 0;  ///< y of the surface of pillar (0,0), the one below
  double upper = 0;  ///< y of the surface of pillar (0,1), the one above

  double middle() const { return 0.5 * (lower + upper); }
  /// Middle of the part of pillar (0,0) that the line cuts: lanes are told apart there.
  double pillar_middle(double pitch_y) const { return 0.5 * (lower + upper - pitch_y); }
};

}  // namespace dld
