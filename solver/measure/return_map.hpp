#pragma once
/// The return map of a cell at the pillar lines and the trajectory class that it proves. The state at the
/// pillar line of row n is the gap position c_n: the centre's distance above the surface of the pillar below.
/// A bump keeps the lane (c_n -> c_n+1), a zig falls back one lane. Lattice units.
#include <string>
#include <vector>

#include "geometry/gap_line.hpp"

namespace dld {

/// Lane m of a point at height y on the gap line of row n: pillar (n,m) stands at m ny + n d, and the line
/// cuts it about pillar_middle above its centre (0 for a symmetric pillar).
int lane_of(double y, int row, double pitch_y, double row_shift, double pillar_middle = 0);

/// One passage of a pillar line.
struct Crossing {
  int row = 0;              ///< n
  int lane = 0;             ///< m of the pillar below
  double gap_position = 0;  ///< c: centre above the surface of the pillar below (lu)
  bool bump = true;         ///< lane kept since the previous crossing; set by ReturnMap, true for the first
};

/// Crossing of a cell whose centre is at y (lu, unwrapped) on the gap line of row n; gap: that line of row 0.
Crossing crossing_at(double y, int row, double pitch_y, double row_shift, const GapLine& gap);

enum class TrajectoryClass { running, displaced, zigzag, undecided };
std::string to_string(TrajectoryClass c);

struct ReturnMapOptions {
  double epsilon = 0;            ///< row shift / pitch; 0: no row limit of its own
  double tolerance = 0.05;       ///< extrapolated distance to the fixed point (lu)
  double noise = 1e-4;           ///< steps of the map smaller than this mean nothing (lu)
  double largest_ratio = 0.9;    ///< of successive steps; a saddle-node tends to 1
  double ratio_agreement = 0.1;  ///< allowed difference between two successive ratios
  int max_rows = 0;              ///< rows after the first crossing; 0: start transient + ceil(1/eps) + 2
};

/// What the map says about a run that is not decided (and, for the record, about any other).
struct MapBracket {
  double step = 0;         ///< last c_n - c_n-1 within a lane (lu)
  double ratio = 1;        ///< last measurable ratio of two steps, 1 when there is none
  double limit = 0;        ///< extrapolated fixed point (lu), the last c when the map gives none
  double lowest_bump = 0;  ///< smallest c from which the cell bumped (lu); NaN when it never did
  double highest_zig = 0;  ///< largest c from which it zigged (lu); NaN when it never did
  int zigs = 0;
};

/// Decides from the crossings, in the order of rows:
/// - zigzag: two zigs; or one zig, after which the cell is back at or below a gap position that it held on
/// the
///   way to it. Streamlines keep their order, so the map is monotonic, and what led to a zig once leads there
///   again. One zig alone proves nothing, since the start position decides the first.
/// - displaced: the map has reached its fixed point. The quadratic map through the last four crossings must
///   have a fixed point ahead with a multiplier below largest_ratio, the two ratios of steps must agree and
///   be below it, and the distance left to the fixed point, by the geometric series as by the quadratic map,
///   must be below the tolerance. A small step alone never counts: in the bottleneck of a saddle-node the
///   ratios tend to 1 and the quadratic has no root. (Noise hides the curvature of the map over the last few
///   hundredths of a lattice spacing; a map that bends by more than about 0.3 per lu there could deceive it.)
///   Or it rests: its last four steps stay within twice the tolerance and go both ways (a creep keeps its
///   direction), or are all below the noise, unless the last measurable ratio was that of a creep.
/// - undecided: neither within the row limit. The start transient is the row of the first zig, or half a
///   cycle, ceil(1/(2 eps)) rows, when there was none.
class ReturnMap {
 public:
  explicit ReturnMap(const ReturnMapOptions& options) : options_(options) {}

  /// Adds the next crossing and returns the class as it now stands.
  TrajectoryClass add(Crossing crossing);

  TrajectoryClass trajectory_class() const { return class_; }
  const std::vector<Crossing>& crossings() const { return crossings_; }
  int zigs() const { return static_cast<int>(zig_indices_.size()); }
  /// Last row to which an undecided run goes.
  int last_row() const;
  MapBracket bracket() const;

  /// Index of the crossing that defines D_perp. zigzag: the crossing at which the cell touches the pillar it
  /// is about to fall behind, i.e. the smallest gap position between the first zig and the second (the cycle
  /// before the first zig is left out because the start shapes it); with one zig and a return, the crossing
  /// before that zig. Otherwise the last crossing; -1: none.
  int defining_crossing() const;

 private:
  struct FixedPoint {
    bool proven = false;
    double limit = 0;
  };
  /// The last count steps c_n - c_n-1 (oldest first), empty when they are not all bumps.
  std::vector<double> last_steps(int count) const;
  FixedPoint fixed_point() const;
  bool rests() const;
  bool returns_to_zig() const;
  /// Latest ratio of steps of which the earlier stands clear of the noise; 0 when there is none.
  double last_measurable_ratio() const;
  TrajectoryClass classify() const;

  ReturnMapOptions options_;
  std::vector<Crossing> crossings_;
  std::vector<int> zig_indices_;
  TrajectoryClass class_ = TrajectoryClass::running;
};

}  // namespace dld
