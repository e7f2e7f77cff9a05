#pragma once
/// What a passage knows besides fluid and cell. All of it goes into a checkpoint, so that a run that goes on
/// misses nothing.
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "geometry/device.hpp"
#include "measure/cross_section.hpp"
#include "measure/return_map.hpp"
#include "output/checkpoint.hpp"
#include "parameters/case.hpp"
#include "scene/passage_record.hpp"
#include "scene/separations.hpp"

namespace dld {

/// The flow without the cell.
struct CellFreeFlow {
  long steps = 0;                          ///< until it was steady
  double along = 0, across = 0;            ///< mean velocity (lu) along the driving force and to its left
  std::optional<Separations> separations;  ///< none before the flow, and where there is no lane to leave
};

/// Where the cell is on its way and what was measured of it. Lattice units; row n has the pillar line
/// x = n lambda.
class PassageState {
 public:
  PassageState(const Case& c, const Device& device);

  CellFreeFlow flow;
  long steps = 0;  ///< with the cell

  int row = 0;                  ///< of the pillar line that the cell comes to or is passing
  PassageExtent extent;         ///< of the cell on that line: D_perp
  bool crossing_added = false;  ///< its centre is past that line
  bool decided = false;         ///< the class is known; the last passage may still go on

  PassageRecord record;
  Eigen::Vector3d last_recorded = Eigen::Vector3d::Zero();  ///< centre at the trajectory's last sample
  long last_snapshot = -1000000;                            ///< the stretch of a row that it was taken in
  MembraneSnapshot last_good;  ///< shape at the last sample that passed all checks

  /// The cell's class is defined by lanes, which neither an empty slit nor rows without a shift have.
  bool has_separations() const { return has_separations_; }

  /// The return map of the crossings so far.
  const ReturnMap& map() const { return map_; }
  /// The centre at height y on the pillar line after those that it has crossed; returns the class as it now
  /// stands.
  TrajectoryClass add_crossing(double y);

  /// x of the pillar line of `row`.
  double line_of_row() const;

  void save(Checkpoint& checkpoint) const;
  /// Of a checkpoint of the same case; `steps` is the one of fluid and cell, which the caller restores.
  void load(const Checkpoint& checkpoint);

 private:
  GapLine gap_;                        ///< of row 0
  int pitch_x_, pitch_y_, row_shift_;  ///< of the unit cell
  bool has_separations_;
  ReturnMap map_;
  std::vector<double> heights_;  ///< y of the centre at the crossings of map_
};

}  // namespace dld
