#include "parameters/memory.hpp"

#include <algorithm>
#include <cmath>

#include "parameters/scene_rules.hpp"

namespace dld {
namespace {

constexpr double bytes_per_MiB = 1024.0 * 1024.0;
constexpr double program_bytes = 20e6;  // measured: program and libraries
// Measured at mesh frequencies 100 and 200 (static stretching): reference, forces, 20 pairs of the minimiser.
constexpr double bytes_per_vertex = 2400;
constexpr double bytes_per_shape_vertex = 3 * sizeof(double);

bool has_cell(const Case& c) {
  return c.scene == "passage" || c.scene == "shear" || c.scene == "stretching";
}

/// Places of one field with the margins that the lattice keeps around it.
double places(const LatticeBox& box) {
  const double row = 16 * std::ceil(box.ny / 16) + 16;
  return box.nodes() > 0 ? (box.nx + 2) * (row * box.nz + 16) : 0.0;
}

/// Shapes of the membrane that are kept until the end of the run.
double kept_shapes(const Case& c) {
  if (c.scene == "stretching") return static_cast<double>(c.stretching.forces_pN.size());
  if (c.scene != "passage") return 0.0;
  constexpr double typical_rows = 20;
  const double rows = c.stop.when == "rows" ? c.stop.max_rows : typical_rows;
  return rows * (1.0 + c.output.snapshots_per_row);
}

}  // namespace

double memory_MiB(const Case& c) {
  const LatticeBox box = rules_of(c.scene).box(c);
  const double real = c.fluid.precision == "single" ? 4 : 8;
  // 19 populations (streamed in place), velocity, force, relaxation time and fluid mask.
  constexpr double populations = 19, fields = 8;
  double bytes = program_bytes + places(box) * (populations + fields) * real + 2.0 * box.nodes();
  // The mid plane: velocity, solid flags and their copies for the output.
  bytes += 100.0 * box.nx * box.ny;
  if (has_cell(c)) {
    const double frequency = c.cell.mesh_frequency, vertices = 10.0 * frequency * frequency + 2.0;
    bytes += vertices * (bytes_per_vertex + kept_shapes(c) * bytes_per_shape_vertex);
    // Populations once more as an array, and as the bytes of the file whose seal is computed.
    bytes += 2.0 * populations * places(box) * real;
  }
  return bytes / bytes_per_MiB;
}

std::string memory_advice(const Case& c) {
  const LatticeBox box = rules_of(c.scene).box(c);
  const double frequency = c.cell.mesh_frequency;
  const double membrane = has_cell(c) ? 10.0 * frequency * frequency * bytes_per_vertex : 0.0;
  if (box.nodes() * 27.0 * 4.0 > membrane) return "raise /fluid/lattice_spacing_um";
  return kept_shapes(c) * bytes_per_shape_vertex > bytes_per_vertex
             ? "keep fewer shapes (/stretching/forces_pN, /output/snapshots_per_row, /stop/max_rows)"
             : "lower /cell/mesh_frequency";
}

}  // namespace dld
