#pragma once
/// From a case to the objects of a scene: what most names in the case mean is decided here.
#include <memory>

#include "coupling/coupled_cell.hpp"
#include "fluid/lattice.hpp"
#include "geometry/device.hpp"
#include "geometry/unit_cell.hpp"
#include "membrane/membrane.hpp"
#include "parameters/cell_surface.hpp"
#include "parameters/units.hpp"

namespace dld {

/// The unit cell with its solid nodes. The device must outlive it.
UnitCell make_unit_cell(const Case& c, const Device& device);

FluidModel make_fluid_model(const Case& c);

/// Moduli of the scene's cell; no volume penalty where the volume is projected.
MembraneModuli make_moduli(const Case& c, const LatticeParameters& l);

/// Tangential velocity that the case's kernel gives back for the spread load (see CouplingModel), lu.
double kink_mobility(const Case& c);

CouplingModel make_coupling_model(const Case& c);

/// Calls run.template operator()<float>() or <double>(), as the case says.
template <class Function>
auto with_precision(const Case& c, Function&& run) {
  return c.fluid.precision == "double" ? run.template operator()<double>() : run.template operator()<float>();
}

}  // namespace dld
