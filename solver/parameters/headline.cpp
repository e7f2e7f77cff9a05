#include "parameters/headline.hpp"

#include "parameters/cell_surface.hpp"
#include "parameters/pillar_json.hpp"
#include "parameters/text.hpp"

namespace dld {
namespace {

std::string device_text(const GeometryParameters& g) {
  const std::string pillar =
      g.pillar_values().shape == "none" ? "no pillars" : pillar_words(g.pillar_values(), number_text);
  return pillar + ", pitch " + number_text(g.pitch_um) + " um, d = " + number_text(g.row_shift_um) +
         " um (epsilon " + number_text(g.epsilon()) + "), depth " + number_text(g.depth_um) + " um";
}

std::string cell_text(const CellParameters& cell) {
  const std::string size = sized_by_radius(cell) ? "" : " " + size_text(cell) + ",";
  return cell.shape + size + " r = " + number_text(cell.radius_um) + " um";
}

std::string capillary_text(double capillary_number) {
  return "Ca = " + number_text(capillary_number);
}

}  // namespace

std::string headline(const Case& c) {
  const std::string lattice =
      "; dx = " + number_text(c.fluid.lattice_spacing_um) + " um (" + c.accuracy + ")";
  const std::string scene = c.scene + ": ";
  if (c.scene == "streamlines") return scene + device_text(c.geometry) + lattice;
  if (c.scene == "channel") {
    const std::string width =
        c.channel.width_um > 0 ? "width " + number_text(c.channel.width_um) + " um, " : "";
    return scene + width + "depth " + number_text(c.geometry.depth_um) + " um" + lattice;
  }
  if (c.scene == "stretching") {
    return scene + c.stretching.method + ", " + cell_text(c.cell) +
           ", kS = " + number_text(c.stretching.shear_modulus_uN_per_m) + " uN/m" +
           (c.stretching.method == "coupled" ? lattice : "");
  }
  if (c.scene == "shear") {
    return scene + cell_text(c.cell) + ", " + capillary_text(c.shear.capillary_number) + ", box " +
           number_text(c.shear.box_um) + " um" + lattice;
  }
  return scene + device_text(c.geometry) + "; " + cell_text(c.cell) + ", " +
         capillary_text(c.cell.capillary_number) + lattice;
}

}  // namespace dld
