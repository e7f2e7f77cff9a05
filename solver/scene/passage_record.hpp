#pragma once
/// What a passage leaves behind: the sampled trajectory and one row per pillar line.
#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "measure/return_map.hpp"
#include "output/checkpoint.hpp"
#include "output/hdf5_file.hpp"

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
  void write(Hdf5File& out, const std::string& group) const;
  void save(Checkpoint& checkpoint, const std::string& prefix) const;
  void load(const Checkpoint& checkpoint, const std::string& prefix);

 private:
  std::vector<Column> columns_;
};

/// The columns of /trajectory and /crossings.
ColumnTable trajectory_table();
ColumnTable crossings_table();

/// A membrane shape worth keeping, lattice units.
struct MembraneSnapshot {
  std::string name;  ///< dataset group below /membrane
  int row = 0;
  long step = 0;
  Eigen::MatrixX3d vertices;
};

}  // namespace dld
