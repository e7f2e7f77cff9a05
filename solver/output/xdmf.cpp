#include "output/xdmf.hpp"

#include <cstdio>
#include <span>
#include <sstream>

#include "output/hdf5_file.hpp"

namespace dld {
namespace {

std::string item(const std::string& dimensions, const std::string& number, const std::string& dataset) {
  return "<DataItem Dimensions=\"" + dimensions + "\" " + number + " Format=\"HDF\">" + dataset +
         "</DataItem>\n";
}

std::string real(int bytes) {
  return "NumberType=\"Float\" Precision=\"" + std::to_string(bytes) + "\"";
}

std::string number_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.12g", value);
  return text;
}

void write_mesh(std::ostream& out, const std::string& file, const XdmfMesh& mesh) {
  const std::string faces = std::to_string(mesh.n_faces) + " 3";
  const std::string vertices = std::to_string(mesh.n_vertices) + " 3";
  out << "<Grid Name=\"" << mesh.name << "\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
  for (const auto& snapshot : mesh.snapshots) {
    out << "<Grid Name=\"" << mesh.name << "\">\n<Time Value=\"" << number_text(snapshot.time) << "\"/>\n"
        << "<Topology TopologyType=\"Triangle\" NumberOfElements=\"" << mesh.n_faces << "\">\n"
        << item(faces, "NumberType=\"Int\" Precision=\"4\"", file + mesh.faces)
        << "</Topology>\n<Geometry GeometryType=\"XYZ\">\n"
        << item(vertices, real(8), file + snapshot.vertices) << "</Geometry>\n</Grid>\n";
  }
  out << "</Grid>\n";
}

// One component of the 2-vectors of /flow/velocity.
std::string velocity_component(const std::string& file, const XdmfFlow& flow, int component) {
  const std::string n = std::to_string(flow.nx) + " " + std::to_string(flow.ny);
  return "<DataItem ItemType=\"HyperSlab\" Dimensions=\"" + n + " 1\">\n" +
         "<DataItem Dimensions=\"3 3\" NumberType=\"Int\" Format=\"XML\">0 0 " + std::to_string(component) +
         " 1 1 1 " + n + " 1</DataItem>\n" +
         item(n + " 2", real(flow.velocity_bytes), file + "/flow/velocity") + "</DataItem>\n";
}

void write_flow(std::ostream& out, const std::string& file, const XdmfFlow& flow) {
  const std::string n = std::to_string(flow.nx) + " " + std::to_string(flow.ny);
  out << "<Grid Name=\"mid plane\">\n<Topology TopologyType=\"2DSMesh\" Dimensions=\"" << n << "\"/>\n"
      << "<Geometry GeometryType=\"XYZ\">\n"
      << item(n + " 3", real(8), file + "/flow/points_um") << "</Geometry>\n";
  // ParaView takes vectors of three components only.
  out << "<Attribute Name=\"velocity\" AttributeType=\"Vector\" Center=\"Node\">\n"
      << "<DataItem ItemType=\"Function\" Function=\"JOIN($0, $1, 0 * $0)\" Dimensions=\"" << n << " 3\">\n"
      << velocity_component(file, flow, 0) << velocity_component(file, flow, 1)
      << "</DataItem>\n</Attribute>\n"
      << "<Attribute Name=\"solid\" AttributeType=\"Scalar\" Center=\"Node\">\n"
      << item(n, "NumberType=\"UChar\" Precision=\"1\"", file + "/flow/solid") << "</Attribute>\n</Grid>\n";
}

}  // namespace

void write_flow_points(Hdf5File& file, const XdmfFlow& flow) {
  std::vector<double> points;
  points.reserve(flow.nx * flow.ny * 3);
  for (std::size_t i = 0; i < flow.nx; ++i) {
    for (std::size_t j = 0; j < flow.ny; ++j) {
      points.insert(points.end(), {flow.x0_um + static_cast<double>(i) * flow.spacing_um,
                                   flow.y0_um + static_cast<double>(j) * flow.spacing_um, 0.0});
    }
  }
  file.write("/flow/points_um", std::span<const double>(points), {flow.nx, flow.ny, 3}, "um",
             "node positions (x, y, 0) relative to the pillar centre");
}

void write_xdmf(const std::filesystem::path& hdf5_path, const XdmfDescription& description) {
  if (!description.mesh && !description.flow) return;
  std::filesystem::path path = hdf5_path;
  path.replace_extension(".xdmf");
  const std::string file = hdf5_path.filename().string() + ":";
  std::ostringstream out;
  out << "<?xml version=\"1.0\"?>\n<Xdmf Version=\"2.0\">\n<Domain>\n";
  if (description.mesh) write_mesh(out, file, *description.mesh);
  if (description.flow) write_flow(out, file, *description.flow);
  out << "</Domain>\n</Xdmf>\n";
  const std::filesystem::path part = path.string() + ".part";
  write_durably(part, out.str());
  rename_durably(part, path);
}

}  // namespace dld
