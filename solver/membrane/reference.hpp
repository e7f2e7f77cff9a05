#pragma once
/// What a membrane is made of: moduli, stress-free mesh, and the numbers that follow from them.
#include <Eigen/Core>
#include <vector>

#include "membrane/bending_law.hpp"
#include "membrane/mesh.hpp"

namespace dld {

/// Moduli in one consistent system of units (lattice units, or um and pN).
struct MembraneModuli {
  double shear = 0;                ///< kS, force / length
  double skalak_denominator = 12;  ///< k in W = (kS/k)(I1^2 + 2 I1 - 2 I2) + (kalpha/12) I2^2
  double local_area = 0;           ///< kalpha, force / length
  double global_area = 0;          ///< kA in (kA/2)(A - A0)^2 / A0, force / length
  double volume = 0;               ///< kV in (kV/2)(V - V0)^2 / V0, force / length^2; 0 when projected
  double bending = 0;              ///< kB, energy
  BendingLaw bending_law = BendingLaw::hinge_half;  ///< what kB stands for
};

/// Stress-free state of a membrane.
struct MembraneReference {
  TriangleMesh mesh;
  MembraneModuli moduli;
  std::vector<Edge> edges;
  double area = 0, volume = 0;  ///< A0, V0
  Eigen::ArrayXXd metric;       ///< nf x 4: inverse reference metric h11, h12, h22 and area A0 of a face
  Eigen::ArrayX2d angle;        ///< ne x 2: sine and cosine of the stress-free angle
  Eigen::ArrayX2d curvature;    ///< nv x 2: twice the stress-free mean curvature, and area, of a node
};

/// Area and volume of a closed surface.
struct AreaAndVolume {
  double area = 0, volume = 0;
};

}  // namespace dld
