#include "scene/membrane_output.hpp"

#include <algorithm>

namespace dld {
namespace {

// Single precision is enough to look at.
std::vector<float> scaled(const Eigen::ArrayXd& values, double factor) {
  const Eigen::ArrayXf out = (values * factor).cast<float>();
  return {out.data(), out.data() + out.size()};
}

}  // namespace

MembraneOutput::MembraneOutput(Hdf5File& out, const Membrane& membrane, PhysicalScales scales,
                               const PillarArray* pillars)
    : out_(out), membrane_(membrane), scales_(std::move(scales)), pillars_(pillars) {
  out.write_matrix("/membrane/faces", membrane.reference().faces, "none", "vertices of each triangle");
  const Eigen::MatrixX3d rest = membrane.reference().vertices * scales_.um;
  out.write_matrix("/membrane/reference", rest, "um", "stress-free shape");
}

std::string MembraneOutput::write(const std::string& name, const Eigen::MatrixX3d& shape, double time,
                                  const std::string& description) {
  const std::string group = "/membrane/" + name;
  const Eigen::MatrixX3d vertices = shape * scales_.um;
  out_.write_matrix(group + "/vertices", vertices, "um", description);
  XdmfGrid grid{.name = name,
                .points = group + "/vertices",
                .cells = "/membrane/faces",
                .n_points = static_cast<std::size_t>(membrane_.vertex_count()),
                .n_cells = static_cast<std::size_t>(membrane_.face_count()),
                .fields = {{.name = "position_um", .dataset = group + "/vertices", .components = 3}}};
  write_fields(shape, grid, group);
  shapes_.push_back({std::move(grid), time});
  return group;
}

void MembraneOutput::write_fields(const Eigen::MatrixX3d& shape, XdmfGrid& grid, const std::string& group) {
  const auto add = [&](const char* name, const std::vector<float>& values, const char* unit,
                       XdmfField::Centre centre, const char* description) {
    const std::string dataset = group + "/" + name;
    out_.write(dataset, values, unit, description);
    grid.fields.push_back(
        {.name = name, .dataset = dataset, .centre = centre, .number = XdmfField::Number::float32});
  };
  using enum XdmfField::Centre;
  const FaceFields faces = membrane_.face_fields(shape);
  add("area_strain", scaled(faces.area_strain, 1), "none", cell, "A / A0 - 1 of each face");
  if (scales_.tension_uN_m > 0) {
    add("mean_tension_uN_per_m", scaled(faces.mean_tension, scales_.tension_uN_m), "uN/m", cell,
        "mean of the two principal in-plane tensions of each face");
    add("shear_tension_uN_per_m", scaled(faces.shear_tension, scales_.tension_uN_m), "uN/m", cell,
        "half the difference of the two principal in-plane tensions of each face");
  }
  if (!pillars_ || pillars_->empty()) return;
  Eigen::ArrayXd distance(shape.rows());
  for (Eigen::Index i = 0; i < shape.rows(); ++i)
    distance(i) = pillars_->signed_distance(shape(i, 0), shape(i, 1));
  add("pillar_distance_um", scaled(distance, scales_.um), "um", node,
      "distance of each vertex from the nearest pillar, negative inside");
}

std::vector<XdmfShape> MembraneOutput::series() const {
  std::vector<XdmfShape> shapes = shapes_;
  std::ranges::stable_sort(shapes, {}, &XdmfShape::time);
  return shapes;
}

}  // namespace dld
