#pragma once
/// Cure for mesh motions that are shorter than the coupling kernel and therefore unseen by the fluid.
#include "membrane/membrane.hpp"

namespace dld {

/// Adds to v_add (nv x 3) the velocity by which each node relaxes along the difference between its own
/// force f and its neighbours',
///   v_i = (mobility / 6) sum_j (f_i - f_j)  over the neighbours j of i
/// (mobility in velocity / force; 6 is the valence of a regular node, where this is f_i minus the mean
/// of the neighbours). The weight 1/6 is the same for both ends of an edge, also at the 12 nodes of
/// valence 5, hence
///   sum_i v_i = 0: the cell's centroid of nodes does not move,
///   sum_i f_i . v_i = (mobility / 6) sum over edges |f_i - f_j|^2 >= 0: elastic energy only falls,
///   and a force that varies over the length L gives a velocity of order (edge / L)^2: the resolved
///   shape is left alone in second order.
/// The volume is not conserved by it; apply it before the volume projection.
void force_difference_velocity(const Membrane& membrane, const Eigen::MatrixX3d& f, double mobility,
                               Eigen::MatrixX3d& v_add);

/// Largest eigenvalue of the stiffness -df/dx at the reference shape (force / length), by power iteration on
/// differences of forces. It limits every explicit update of the nodes.
double largest_stiffness(Membrane& membrane);

/// The mobility that is used for a wanted one: explicit relaxation of a mode of stiffness k by the velocity
/// above is stable while (3/2) mobility k < 2 (3/2: largest eigenvalue of the neighbour difference on a
/// triangular mesh). A share of 1/4 of that leaves room for the stiffening of the deformed shape and for the
/// fluid's own explicit response.
double stable_mobility(Membrane& membrane, double wanted);

}  // namespace dld
