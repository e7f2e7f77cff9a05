#pragma once
/// Rules that join the cell's surface with what surrounds it.
#include <vector>

#include "parameters/case.hpp"
#include "parameters/reader.hpp"

namespace dld {

/// Heights of the surface about its centre at the start, tilt included, um.
struct HeightRange {
  double lowest = 0, highest = 0;
};
HeightRange height_range_um(const CellParameters& cell);

/// Largest distance of the surface to its centre, um.
double reach_um(const CellParameters& cell);

/// A cell with a size of its own has to be narrower than the gap, along the flow or across it.
void check_width(const Case& c, std::vector<Problem>& problems);

/// Where half the height is simulated, the cell has to be its own mirror image about z = 0.
void check_mirror(const Case& c, bool half_height, std::vector<Problem>& problems);

/// Edges of a mesh from a file against the lattice spacing: its user cannot choose a frequency instead.
void check_edges(const Case& c, std::vector<Problem>& problems);

/// The patches that are pulled at have to hold a vertex each, and not the whole cell.
void check_patches(const Case& c, std::vector<Problem>& problems);

}  // namespace dld
