#include "parameters/consistency.hpp"

#include <cmath>

#include "parameters/cell_check.hpp"
#include "parameters/cell_surface.hpp"
#include "parameters/device_check.hpp"
#include "parameters/scene_rules.hpp"
#include "parameters/start_check.hpp"
#include "parameters/text.hpp"

namespace dld {
namespace {

// A force that the minimiser cannot tell from none, or that no membrane bears: F over the tension kS r.
void check_forces(const Case& c, std::vector<Problem>& problems) {
  constexpr double weakest = 1e-3, strongest = 2e3;
  const double tension_pN = c.stretching.shear_modulus_uN_per_m * c.cell.radius_um;  // 1 uN/m um = 1 pN
  for (const double force : c.stretching.forces_pN) {
    const double share = force / tension_pN;
    if (force == 0.0 || (share >= weakest && share <= strongest)) continue;
    problems.push_back({"/stretching/forces_pN", number_text(force),
                        "0, or between " + number_text(weakest * tension_pN) + " and " +
                            number_text(strongest * tension_pN) + " pN (" + number_text(weakest) + " to " +
                            number_text(strongest) + " times shear modulus times radius)",
                        "change the force or /stretching/shear_modulus_uN_per_m"});
  }
  constexpr std::size_t most = 1000;
  if (c.stretching.forces_pN.size() > most)
    problems.push_back({"/stretching/forces_pN",
                        number_text(static_cast<double>(c.stretching.forces_pN.size())),
                        "a list of at most " + number_text(most) + " forces", "split it into several cases"});
}

// Neither a duration of a few steps nor one that can never be reached.
void check_duration(const Case& c, std::vector<Problem>& problems) {
  constexpr double fewest = 20;
  const double radius = c.cell.radius_um / c.fluid.lattice_spacing_um;
  const double per_time = radius * radius / (c.shear.reynolds_number * (c.fluid.relaxation_time - 0.5) / 3);
  const double steps = c.shear.duration * per_time;
  if (steps < fewest) {
    problems.push_back({"/shear/duration", number_text(c.shear.duration),
                        "at least " + number_text(fewest) + " time steps",
                        "use at least " + number_text(fewest / per_time)});
  } else if (steps > static_cast<double>(c.stop.max_steps)) {
    problems.push_back({"/shear/duration", number_text(c.shear.duration),
                        "at most the " + number_text(static_cast<double>(c.stop.max_steps)) +
                            " steps of /stop/max_steps; these are " + number_text(std::ceil(steps)),
                        "use at most " + number_text(static_cast<double>(c.stop.max_steps) / per_time) +
                            ", or raise /stop/max_steps or /shear/reynolds_number"});
  }
}

}  // namespace

void check_passage(const Case& c, std::vector<Problem>& problems) {
  check_array(c, problems);
  check_depth(c, problems);
  check_box(c, problems);
  check_start(c, problems);
  check_width(c, problems);
  check_mirror(c, c.geometry.height == "half", problems);
  check_edges(c, problems);
  if (c.geometry.row_shift_um == 0 && c.stop.max_rows == 0) {
    problems.push_back({"/stop/max_rows", "0", "a number of rows when the rows are not shifted",
                        "use e.g. 10, or a row shift above 0"});
  }
  if (c.stop.when == "rows" && c.stop.max_rows == 0) {
    problems.push_back({"/stop/max_rows", "0", "a number of rows when /stop/when is rows",
                        "use e.g. 50, or \"decided\" for /stop/when"});
  }
}

void check_streamlines(const Case& c, std::vector<Problem>& problems) {
  check_array(c, problems);
  check_depth(c, problems);
  check_box(c, problems);
}

// Some vertex has to lie within the patch that is pulled at. Meshes of an even frequency have one at the tip.
void check_stretching(const Case& c, std::vector<Problem>& problems) {
  check_forces(c, problems);
  check_box(c, problems);
  const bool coupled = c.stretching.method == "coupled";
  check_mirror(c, coupled, problems);
  if (coupled) check_edges(c, problems);
  if (!sized_by_radius(c.cell)) return check_patches(c, problems);
  // The icosahedral mesh has n edges along an arc of 63 degrees.
  const double half_edge_um = 0.55 * c.cell.radius_um / c.cell.mesh_frequency;
  const bool reaches = c.cell.mesh_frequency % 2 == 0 || c.stretching.contact_radius_um >= half_edge_um;
  if (reaches && c.stretching.contact_radius_um < c.cell.radius_um) return;
  problems.push_back({"/stretching/contact_radius_um", number_text(c.stretching.contact_radius_um),
                      "at least half an edge of the mesh, " +
                          number_text(std::ceil(100 * half_edge_um) / 100) +
                          " um, where its frequency is odd, and less than the radius of the cell",
                      "use 1, or take an even /cell/mesh_frequency"});
}

void check_channel(const Case& c, std::vector<Problem>& problems) {
  check_depth(c, problems);
  check_multiple(c, "/channel/width_um", c.channel.width_um, c.fluid.lattice_spacing_um,
                 "the lattice spacing", true, problems);
  check_box(c, problems);
}

void check_shear(const Case& c, std::vector<Problem>& problems) {
  check_duration(c, problems);
  check_box(c, problems);
  check_multiple(c, "/shear/box_um", c.shear.box_um, c.fluid.lattice_spacing_um, "the lattice spacing", false,
                 problems);
  check_edges(c, problems);
  if (2 * reach_um(c.cell) >= c.shear.box_um) {
    problems.push_back(
        {size_pointer(c.cell), size_text(c.cell),
         "a reach from the centre of less than half the box of " + number_text(c.shear.box_um) + " um",
         "use at most " + number_text(c.shear.box_um / 4) + " for a quarter of the box"});
  }
}

std::vector<Problem> inconsistencies(const Case& c) {
  std::vector<Problem> problems;
  rules_of(c.scene).check(c, problems);
  return problems;
}

}  // namespace dld
