#pragma once
/// Shapes of the membrane in the output file, with what a viewer colours them by.
#include <string>
#include <vector>

#include "geometry/pillar_array.hpp"
#include "membrane/membrane.hpp"
#include "output/hdf5_file.hpp"
#include "output/xdmf.hpp"
#include "parameters/physical.hpp"

namespace dld {

class MembraneOutput {
 public:
  /// Writes /membrane/{faces, reference}. Scales of the membrane's units; pillars, in the same units, where
  /// there are any. All three must outlive this object.
  MembraneOutput(Hdf5File& out, const Membrane& membrane, PhysicalScales scales,
                 const PillarArray* pillars = nullptr);

  /// Writes /membrane/<name>/{vertices, area_strain, mean_tension_uN_per_m, shear_tension_uN_per_m,
  /// pillar_distance_um} of a shape (nv, 3) in the membrane's units and adds it to the series at `time`.
  /// Returns the group.
  std::string write(const std::string& name, const Eigen::MatrixX3d& shape, double time,
                    const std::string& description);

  /// The shapes in the order of time.
  std::vector<XdmfShape> series() const;

 private:
  void write_fields(const Eigen::MatrixX3d& shape, XdmfGrid& grid, const std::string& group);

  Hdf5File& out_;
  const Membrane& membrane_;
  PhysicalScales scales_;
  const PillarArray* pillars_;
  std::vector<XdmfShape> shapes_;
};

}  // namespace dld
