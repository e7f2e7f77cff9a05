#pragma once
/// Cure for mesh motions that are shorter than the coupling kernel and therefore unseen by the fluid.
#include "membrane/membrane.hpp"

namespace dld {

/// Parts of the vectors v (nv x 3) along the normals of length one (nv x 3).
inline Eigen::MatrixX3d normal_part(const Eigen::MatrixX3d& v, const Eigen::MatrixX3d& normals) {
  return v.cwiseProduct(normals).rowwise().sum().asDiagonal() * normals;
}

/// Adds to v_add (nv x 3) the velocity by which each node relaxes within the surface, along the difference
/// between its own tangential force and its neighbours',
///   v_i = (mobility / 6) P_i sum_j (P_i f_i - P_j f_j) - mean,   P = 1 - n n
/// over the neighbours j of i (mobility in velocity / force; 6 is the valence of a regular node). n is the
/// direction of volume_gradient (nv x 3). The weight 1/6 is the same for both ends of an edge, hence
///   sum_i v_i = 0: the cell's centroid of nodes does not move,
///   sum_i f_i . v_i = (mobility / 6) sum over edges |P_i f_i - P_j f_j|^2 >= 0 for forces that add up to
///   zero: the elastic energy only falls, n_i . v_i = 0 but for the mean: nodes slide on the shape and do not
///   change it, nor the volume, in first order, and a force that varies over the length L gives a velocity of
///   order (edge / L)^2.
void tangential_relaxation(const Membrane& membrane, const Eigen::MatrixX3d& f,
                           const Eigen::MatrixX3d& volume_gradient, double mobility, Eigen::MatrixX3d& v_add);

/// Largest eigenvalue of the stiffness -df/dx at the reference shape for displacements within the surface
/// (force / length), by power iteration on differences of forces.
double largest_tangential_stiffness(Membrane& membrane);

/// The mobility that is used for a wanted one: explicit relaxation of a mode of stiffness k by the velocity
/// above is stable while (3/2) mobility k < 2 (3/2: largest eigenvalue of the neighbour difference on a
/// triangular mesh). A share of 0.6 of that leaves room for the stiffening of the deformed shape.
double stable_mobility(Membrane& membrane, double wanted);

}  // namespace dld
