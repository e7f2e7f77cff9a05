#pragma once
/// A cell on its way from pillar line to pillar line.
#include <Eigen/Core>
#include <string>

#include "parameters/case.hpp"
#include "parameters/units.hpp"
#include "scene/monitor.hpp"
#include "scene/passage_state.hpp"

namespace dld {

/// Measures the trajectory and, on each line, D_perp and the return map, until that proves the class. What it
/// finds goes into the state.
class RowFollower {
 public:
  /// Goes on from the state, which must outlive it, as must the case.
  RowFollower(const Case& c, PassageState& state) : case_(c), l_(to_lattice(c)), state_(state) {}

  /// A cell that passed all checks, with its centroid (lu); in the order of time.
  void sample(const CellView& cell, const Eigen::Vector3d& centre);

  /// The cell has passed a pillar line since this was asked last, and there is another one to come.
  bool row_passed();
  /// The class is known, and the cell is past the line at which it was found.
  bool finished() const { return finished_; }

  /// Rows at the most, 0 while they are not known.
  double total_rows() const;
  /// Where the cell is, for the progress of the run.
  std::string place_text() const;

 private:
  void record_trajectory(const CellView& cell, const Eigen::Vector3d& centre);
  void cross_line();
  void finish_row(const MembraneState& membrane);

  const Case& case_;
  LatticeParameters l_;
  PassageState& state_;
  bool row_passed_ = false, finished_ = false;
};

}  // namespace dld
