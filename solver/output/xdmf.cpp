#include "output/xdmf.hpp"

#include <algorithm>
#include <cstdio>
#include <sstream>

#include "output/durable_file.hpp"

namespace dld {
namespace {

// Names of fixed grids, which are names of files too.
const std::vector<std::string> fixed_grids = {"flow", "pillars"};

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string number_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.12g", value);
  return text;
}

/// Elements of one file, whose data stand in one HDF5 file.
class Writer {
 public:
  explicit Writer(const std::filesystem::path& hdf5_path) : file_(escaped(hdf5_path.filename().string())) {
    out_ << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Xdmf Version=\"3.0\">\n<Domain>\n";
  }

  void grid(const XdmfGrid& g, const std::string& time = "") {
    out_ << "<Grid Name=\"" << escaped(g.name) << "\" GridType=\"Uniform\">\n" << time;
    out_ << "<Topology TopologyType=\"" << (g.corners == 3 ? "Triangle" : "Quadrilateral")
         << "\" NumberOfElements=\"" << g.n_cells << "\">\n";
    item({g.n_cells, static_cast<std::size_t>(g.corners)}, "NumberType=\"Int\" Precision=\"4\"", g.cells);
    out_ << "</Topology>\n<Geometry GeometryType=\"XYZ\">\n";
    item({g.n_points, 3}, float64, g.points);
    out_ << "</Geometry>\n";
    for (const XdmfField& f : g.fields) field(f, g);
    out_ << "</Grid>\n";
  }

  void begin(const std::string& name, const char* type) {
    out_ << "<Grid Name=\"" << name << "\" GridType=\"Collection\" CollectionType=\"" << type << "\">\n";
  }
  void end() { out_ << "</Grid>\n"; }

  std::string text() const { return out_.str() + "</Domain>\n</Xdmf>\n"; }

 private:
  static constexpr const char* float64 = "NumberType=\"Float\" Precision=\"8\"";

  static const char* number_type(XdmfField::Number number) {
    switch (number) {
      case XdmfField::Number::float32:
        return "NumberType=\"Float\" Precision=\"4\"";
      case XdmfField::Number::uint8:
        return "NumberType=\"UChar\" Precision=\"1\"";
      default:
        return float64;
    }
  }

  void field(const XdmfField& f, const XdmfGrid& g) {
    const bool node = f.centre == XdmfField::Centre::node, vector = f.components == 3;
    out_ << "<Attribute Name=\"" << escaped(f.name) << "\" AttributeType=\"" << (vector ? "Vector" : "Scalar")
         << "\" Center=\"" << (node ? "Node" : "Cell") << "\">\n";
    std::vector<std::size_t> shape = {node ? g.n_points : g.n_cells};
    if (vector) shape.push_back(3);
    item(shape, number_type(f.number), f.dataset);
    out_ << "</Attribute>\n";
  }

  void item(const std::vector<std::size_t>& shape, const char* number, const std::string& dataset) {
    out_ << "<DataItem Dimensions=\"";
    for (std::size_t k = 0; k < shape.size(); ++k) out_ << (k ? " " : "") << shape[k];
    out_ << "\" " << number << " Format=\"HDF\">" << file_ << ":" << escaped(dataset) << "</DataItem>\n";
  }

  std::string file_;
  std::ostringstream out_;
};

std::filesystem::path beside(const std::filesystem::path& hdf5_path, const std::string& extension) {
  return std::filesystem::path(hdf5_path).replace_extension(extension);
}

/// meshio takes the last collection of a file as the series and a grid outside of collections as its mesh:
/// so the fixed grids stand in a collection of their own before the series.
std::string everything(const std::filesystem::path& hdf5_path, const XdmfDescription& description) {
  Writer out(hdf5_path);
  if (!description.fixed.empty()) {
    out.begin("surroundings", "Spatial");
    for (const XdmfGrid& grid : description.fixed) out.grid(grid);
    out.end();
  }
  if (!description.series.empty()) {
    out.begin("membrane", "Temporal");
    const XdmfShape* last = nullptr;
    for (const XdmfShape& shape : description.series) {
      if (last && shape.time <= last->time) continue;
      out.grid(shape.grid, "<Time Value=\"" + number_text(shape.time) + "\"/>\n");
      last = &shape;
    }
    out.end();
  }
  return out.text();
}

}  // namespace

std::vector<std::filesystem::path> xdmf_files(const std::filesystem::path& hdf5_path) {
  std::vector<std::filesystem::path> files = {beside(hdf5_path, ".xdmf")};
  for (const auto& name : fixed_grids) files.push_back(beside(hdf5_path, "." + name + ".xdmf"));
  return files;
}

bool write_xdmf(const std::filesystem::path& hdf5_path, const XdmfDescription& description) {
  for (const auto& path : xdmf_files(hdf5_path)) {
    std::error_code none;
    std::filesystem::remove(path, none);
  }
  if (description.series.empty() && description.fixed.empty()) return true;
  if (hdf5_path.filename().string().find(':') != std::string::npos) return false;
  write_whole(beside(hdf5_path, ".xdmf"), everything(hdf5_path, description));
  for (const XdmfGrid& grid : description.fixed) {
    Writer out(hdf5_path);
    out.grid(grid);
    write_whole(beside(hdf5_path, "." + grid.name + ".xdmf"), out.text());
  }
  return true;
}

}  // namespace dld
