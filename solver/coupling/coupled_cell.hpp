#pragma once
/// One deformable cell in the fluid: membrane forces, spreading, fluid step, interpolation, motion.
///
///   F(x)    = sum_i f_i(X) delta(x - X_i)          spread the nodal forces
///   dX_i/dt = sum_x u(x) delta(x - X_i) + v_i      move with the fluid; v_i cures sub-grid mesh modes and,
///                                                  on request, what the kernel takes from u at the membrane
///   g . dX/dt = -(V - V0) / T                      volume held by projection (g = dV/dX), or by a penalty
///
/// Explicit; one update of the cell for one or more fluid steps, during which the forces stay as they are.
#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <vector>

#include "coupling/immersed_boundary.hpp"
#include "coupling/repulsion.hpp"
#include "coupling/viscosity_field.hpp"
#include "fluid/lattice.hpp"
#include "geometry/pillar_array.hpp"
#include "membrane/membrane.hpp"

namespace dld {

struct CouplingModel {
  Kernel kernel = Kernel::phi4;
  double mobility =
      0.0;  ///< wanted for the sub-grid regularisation, velocity / force (see stable_mobility); 0: off
  /// Tangential velocity that is given back for the spread force density at a node, dx^2 / eta (see
  /// kernel_correction); 0: off. Only tangential loads make the velocity kink, so only these are counted:
  /// with the spreading S and the projections P onto the membrane v = mobility P S^T S P f, which does the
  /// work mobility |S P f|^2 >= 0. The whole load of a fold narrower than the kernel would count the pressure
  /// of one side as a shear of the other, feed energy in, and collapse its faces.
  double kink_mobility = 0.0;
  int steps_per_update = 1;  ///< fluid steps for one update of the membrane
  /// Distance (lattice spacings) by which the points of spreading and interpolation lie inside the membrane.
  /// A kernel makes a surface act as if it stood further out by a fixed share of a spacing, an error of first
  /// order; moving the points in by that share is the remedy for rigid particles (Breugem 2012). For the cell
  /// next to a pillar it takes away a part of the error of the centre and none of that of D_perp.
  double retraction = 0.0;
  bool project_volume = true;
  double volume_relaxation_steps = 50.0;  ///< T
  Repulsion pillar_repulsion, wall_repulsion;
  double wall_height = 0.0;  ///< walls at z = +- wall_height; 0: no repulsion from walls
  double tau_outside = 1.0, tau_inside = 1.0;
  bool smoothed_viscosity = false;
  int viscosity_update_interval = 1;
};

template <class Real>
class CoupledCell {
 public:
  /// positions (nv x 3): physical lattice coordinates; may leave the unit cell (they are never wrapped).
  CoupledCell(Lattice<Real>& lattice, Membrane& membrane, const PillarArray& pillars, CouplingModel model,
              Eigen::MatrixX3d positions);

  /// One time step of cell and fluid.
  void step();

  const Eigen::MatrixX3d& positions() const { return positions_; }
  const Eigen::MatrixX3d& velocities() const { return velocities_; }
  const Eigen::MatrixX3d& forces() const { return forces_; }
  /// Speed of the fastest node in the last update, infinite if a velocity was not finite. From 1 on the cell
  /// stays where it is and further steps do nothing: the run has diverged.
  double max_speed() const { return max_speed_; }
  /// Smallest distance of a node to a pillar in the last step.
  double film() const { return film_; }
  /// Mean of the node positions.
  Eigen::RowVector3d centre() const { return positions_.colwise().mean(); }
  /// Extra force on every node (nv x 3), e.g. of an optical tweezer; empty for none.
  Eigen::MatrixX3d external_forces;

  /// Everything that a step depends on besides the fluid, between two updates of the membrane.
  struct State {
    Eigen::MatrixX3d positions;
    Eigen::MatrixX3d marked;  ///< positions at the last update of the inside/outside field
    long steps = 0, odd_columns = 0;
  };
  State state() const { return {positions_, marked_, steps_, odd_columns()}; }
  void restore(const State& state);
  void restore(const Eigen::MatrixX3d& positions, long step) {
    restore({positions, positions, step, odd_columns()});
  }
  /// Brings the inside/outside field up to date between its regular updates.
  void refresh_viscosity() { update_viscosity(); }
  /// Mobility of the sub-grid regularisation that is in use.
  double mobility() const { return model_.mobility; }
  long odd_columns() const { return odd_columns_before_ + viscosity_.odd_columns(); }

 private:
  /// Forces of the membrane at its place, spread to the fluid.
  void load_fluid();
  /// Spreads the forces: all at once, or the tangential part first where the kink is corrected.
  void spread_forces();
  /// Moves the membrane with the fluid over the steps since the last update.
  void move();
  void add_repulsion();
  /// A film between cell and bottom or top wall that the lattice does not resolve lets nodes step through the
  /// wall. They are kept this far away from it; a cell that never comes so near is left alone to the last
  /// bit.
  static constexpr double closest_to_wall = 0.05;
  void hold_off_walls();
  void project_volume();
  void update_viscosity();

  Lattice<Real>& lattice_;
  Membrane& membrane_;
  MembraneForces membrane_forces_;
  const PillarArray& pillars_;
  CouplingModel model_;
  ImmersedBoundary<Real> boundary_;
  ViscosityField<Real> viscosity_;
  Eigen::MatrixX3d positions_, velocities_, forces_;
  Eigen::MatrixX3d marked_;    ///< positions_ when the inside/outside field was made
  Eigen::MatrixX3d gradient_;  ///< of volume_
  Eigen::MatrixX3d normals_;   ///< outward, of length one
  Eigen::MatrixX3d points_;    ///< of the coupling, where they are not the nodes
  Eigen::MatrixX3d load_;      ///< spread tangential force density at the nodes
  std::vector<std::uint8_t> near_solid_;
  double volume_ = 0.0;  ///< of the cell at positions_, before they move
  double film_ = 0.0, max_speed_ = 0.0;
  bool failed_ = false;
  long steps_ = 0;
  long odd_columns_before_ = 0;  ///< counted by the run that this one goes on from
};

extern template class CoupledCell<float>;
extern template class CoupledCell<double>;

}  // namespace dld
