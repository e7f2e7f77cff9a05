#pragma once
/// What a passage leaves behind: the sampled trajectory and one row per pillar line.
#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "membrane/membrane.hpp"
#include "output/checkpoint.hpp"
#include "output/hdf5_file.hpp"
#include "parameters/physical.hpp"
#include "scene/membrane_output.hpp"
#include "scene/monitor.hpp"

namespace dld {

/// A table of named columns of doubles, kept in the order of declaration.
class ColumnTable {
 public:
  struct Column {
    std::string name, unit, description;
    std::vector<double> values;
  };

  explicit ColumnTable(std::vector<Column> columns) : columns_(std::move(columns)) {}
  /// One value per column, in the order of the columns.
  void append(const std::vector<double>& row);
  std::size_t size() const { return columns_.front().values.size(); }
  const std::vector<double>& column(const std::string& name) const;
  /// Writes the columns as data sets of the group; those in steps say what they are in seconds.
  void write(Hdf5File& out, const std::string& group, const PhysicalScales& scales) const;
  void save(Checkpoint& checkpoint, const std::string& prefix) const;
  void load(const Checkpoint& checkpoint, const std::string& prefix);

 private:
  std::vector<Column> columns_;
};

/// A membrane shape worth keeping, lattice units.
struct MembraneSnapshot {
  std::string name;  ///< group below /membrane
  int row = 0;
  long step = 0;
  Eigen::MatrixX3d vertices;
};

/// Distances from here on (lu) mean that there is no pillar or no wall.
constexpr double no_distance = 1e300;

/// Largest excursions over a whole run.
struct Extremes {
  double area_change = 0, volume_change = 0, local_area_strain = 0, min_face_ratio = 1;
  double film = no_distance;  ///< smallest distance to a pillar, lattice units
  double speed = 0;           ///< of a membrane node, lattice units
  double density_variation = 0;
  double wall_gap = no_distance;  ///< smallest distance to the bottom or top wall, lattice units

  /// node_wall_gap: smallest distance between a node and a wall (lu).
  void update(const CellView& cell, double node_wall_gap);
};

/// Everything measured on the way; the part of a checkpoint that is not fluid or cell.
class PassageRecord {
 public:
  PassageRecord();

  ColumnTable trajectory, crossings;
  Extremes extremes;

  /// Keeps a shape as <kind>_000, <kind>_001 and so on.
  void keep_snapshot(const std::string& kind, int row, long step, const Eigen::MatrixX3d& vertices);

  /// Keeps a shape under its own name.
  void keep(MembraneSnapshot snapshot) { snapshots_.push_back(std::move(snapshot)); }

  /// Writes /trajectory, /crossings and /membrane; returns the membrane's series for XDMF, in seconds.
  std::vector<XdmfShape> write(Hdf5File& out, const Membrane& membrane, const PillarArray& pillars,
                               const PhysicalScales& scales) const;

  void save(Checkpoint& checkpoint) const;
  void load(const Checkpoint& checkpoint);

 private:
  std::vector<MembraneSnapshot> snapshots_;
};

}  // namespace dld
