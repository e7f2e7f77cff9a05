#include "coupling/coupled_cell.hpp"

#include <cmath>

#include "membrane/regularisation.hpp"

namespace dld {

template <class Real>
CoupledCell<Real>::CoupledCell(Lattice<Real>& lattice, Membrane& membrane, const PillarArray& pillars,
                               CouplingModel model, Eigen::MatrixX3d positions)
    : lattice_(lattice),
      membrane_(membrane),
      membrane_forces_(membrane.step_forces(lattice.cell().height == HeightBoundary::mirror_and_wall
                                                ? MirrorSymmetry::about_z
                                                : MirrorSymmetry::none)),
      pillars_(pillars),
      model_(model),
      boundary_(lattice, model.kernel,
                coupled_nodes(membrane.reference().vertices,
                              lattice.cell().height == HeightBoundary::mirror_and_wall)),
      viscosity_(lattice, membrane.reference().faces, model.tau_outside, model.tau_inside,
                 model.smoothed_viscosity),
      positions_(std::move(positions)),
      velocities_(Eigen::MatrixX3d::Zero(positions_.rows(), 3)),
      forces_(Eigen::MatrixX3d::Zero(positions_.rows(), 3)),
      gradient_(Eigen::MatrixX3d::Zero(positions_.rows(), 3)),
      load_(Eigen::MatrixX3d::Zero(positions_.rows(), 3)),
      near_solid_(static_cast<std::size_t>(positions_.rows()), 0) {
  // Both limits are those of one update.
  const double steps = model_.steps_per_update;
  model_.mobility = stable_mobility(membrane_, steps * model_.mobility) / steps;
  update_viscosity();
}

template <class Real>
void CoupledCell<Real>::restore(const State& state) {
  positions_ = state.marked;
  update_viscosity();
  positions_ = state.positions;
  steps_ = state.steps;
  odd_columns_before_ = state.odd_columns - viscosity_.odd_columns();
}

template <class Real>
void CoupledCell<Real>::update_viscosity() {
  viscosity_.update(positions_);
  marked_ = positions_;
}

template <class Real>
void CoupledCell<Real>::step() {
  if (failed_) return;
  const long step_of_update = steps_ % model_.steps_per_update;
  if (step_of_update == 0) load_fluid();
  lattice_.step(boundary_.active());
  ++steps_;
  if (step_of_update + 1 == model_.steps_per_update) move();
}

template <class Real>
void CoupledCell<Real>::load_fluid() {
  volume_ = membrane_forces_.forces(positions_, forces_, gradient_).volume;
  if (external_forces.rows() == forces_.rows()) forces_ += external_forces;
  add_repulsion();
  if (steps_ / model_.steps_per_update % model_.viscosity_update_interval == 0) update_viscosity();
  if (model_.retraction > 0.0 || model_.kink_mobility > 0.0) normals_ = gradient_.rowwise().normalized();
  if (model_.retraction > 0.0) {
    points_ = positions_ - model_.retraction * normals_;
    boundary_.locate(points_, near_solid_);
  } else {
    boundary_.locate(positions_, near_solid_);
  }
  spread_forces();
}

template <class Real>
void CoupledCell<Real>::spread_forces() {
  if (model_.kink_mobility == 0.0) {
    boundary_.spread(forces_);
    return;
  }
  const Eigen::MatrixX3d normal = normal_part(forces_, normals_);
  boundary_.spread(forces_ - normal);
  boundary_.interpolate_force(load_);
  boundary_.spread(normal);
}

template <class Real>
void CoupledCell<Real>::move() {
  boundary_.interpolate(velocities_);
  boundary_.clear_force();
  if (model_.kink_mobility > 0.0)
    velocities_ += model_.kink_mobility * (load_ - normal_part(load_, normals_));
  if (model_.mobility > 0.0) {
    tangential_relaxation(membrane_, forces_, gradient_, model_.mobility, velocities_);
  }
  if (model_.project_volume) project_volume();
  // A node that crosses a lattice spacing per step, or is nowhere, is left where it is: the monitors see the
  // speed.
  const auto v = velocities_.array();
  const double fastest =
      v.allFinite() ? std::sqrt((v.col(0).square() + v.col(1).square() + v.col(2).square()).maxCoeff())
                    : HUGE_VAL;
  failed_ = !(fastest < 1.0);
  max_speed_ = fastest;
  if (failed_) return;
  positions_ += static_cast<double>(model_.steps_per_update) * velocities_;
  hold_off_walls();
}

template <class Real>
void CoupledCell<Real>::hold_off_walls() {
  if (model_.wall_height <= 0.0) return;
  const double highest = model_.wall_height - closest_to_wall;
  for (double& z : positions_.col(2)) {
    if (std::abs(z) > highest) z = std::copysign(highest, z);
  }
}

template <class Real>
void CoupledCell<Real>::add_repulsion() {
  constexpr double kernel_reach = 3.5;  // lattice spacings: widest kernel across a cell diagonal
  film_ = 1e300;
  if (!pillars_.empty()) {
    for (const CoupledNode& node : boundary_.nodes()) {
      const double x = positions_(node.vertex, 0), y = positions_(node.vertex, 1);
      const double h = pillars_.signed_distance(x, y);
      film_ = std::min(film_, h);
      near_solid_[static_cast<std::size_t>(node.vertex)] = h < kernel_reach ? 1 : 0;
      const double f = model_.pillar_repulsion.force(h);
      if (f == 0.0) continue;
      const auto normal = pillars_.normal(x, y);
      forces_.row(node.vertex) += Eigen::RowVector3d(f * normal[0], f * normal[1], 0.0);
      if (node.mirror_vertex < 0 || node.mirror_vertex == node.vertex) continue;
      forces_.row(node.mirror_vertex) += Eigen::RowVector3d(f * normal[0], f * normal[1], 0.0);
    }
  }
  if (model_.wall_height > 0.0 && model_.wall_repulsion.strength > 0.0) {
    for (Eigen::Index i = 0; i < positions_.rows(); ++i) {
      const double z = positions_(i, 2);
      forces_(i, 2) -= std::copysign(model_.wall_repulsion.force(model_.wall_height - std::abs(z)), z);
    }
  }
}

template <class Real>
void CoupledCell<Real>::project_volume() {
  const double excess = volume_ - membrane_.reference_volume();
  const double rate = gradient_.cwiseProduct(velocities_).sum() + excess / model_.volume_relaxation_steps;
  velocities_ -= rate / gradient_.squaredNorm() * gradient_;
}

template class CoupledCell<float>;
template class CoupledCell<double>;

}  // namespace dld
