#pragma once
/// Streamlines of the mid plane and the separation distance s: the distance between a pillar and the
/// streamline that ends in the stagnation point of the next pillar downstream (Dcr = 2 s). Lattice units;
/// pillar (n,m) stands at (n nx, m ny + n d), the flow runs along +x.
#include <Eigen/Core>

#include "measure/plane_field.hpp"

namespace dld {

struct StreamlineOptions {
  double step = 0.25;            ///< arc length of a Runge-Kutta step away from walls (lu)
  double wall_step_ratio = 0.2;  ///< the step never exceeds this share of the wall distance
  double wall_distance = 1e-3;   ///< a streamline this close to a wall has ended there (lu)
  double max_length_rows = 6;    ///< longest streamline, in pitches
  double seed_tolerance = 1e-6;  ///< bisection tolerance of the seed (lu)
};

enum class StreamlineEnd { line, wall, stagnation, too_long };

struct Streamline {
  Eigen::MatrixX2d points;  ///< (n, 2) positions (lu), in the order of tracing
  StreamlineEnd end = StreamlineEnd::too_long;
};

/// Traces from seed along (direction = +1) or against (-1) the flow until x reaches x_end, a wall or a
/// stagnation point. Fourth-order Runge-Kutta in arc length, i.e. on the unit vectors of the velocity.
Streamline trace_streamline(const PlaneFlow& flow, const Eigen::Vector2d& seed, int direction, double x_end,
                            const StreamlineOptions& options = {});

struct Separation {
  bool found = false;           ///< false: no dividing streamline crosses the gap (row shift 0); then s = 0
  double seed_distance = 0;     ///< s on the gap line (lu)
  double minimum_distance = 0;  ///< shortest distance between the streamline and the pillar (lu)
  Eigen::Vector2d seed = Eigen::Vector2d::Zero();  ///< where the streamline crosses the gap line (lu)
  Eigen::MatrixX2d streamline;  ///< (n, 2) dividing streamline (lu), ordered along the flow
};

/// The streamline that ends in the front stagnation point of pillar (1,0); distances from pillar (0,0).
Separation separation_downstream(const PlaneFlow& flow, const StreamlineOptions& options = {});

/// The streamline that leaves the rear stagnation point of pillar (-1,1); distances from pillar (0,1), the
/// upper one of the gap. Equal to the downstream one when the flow is reversible (no inertia) and the
/// pillar is point-symmetric.
Separation separation_upstream(const PlaneFlow& flow, const StreamlineOptions& options = {});

}  // namespace dld
