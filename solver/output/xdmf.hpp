#pragma once
/// XDMF description beside the HDF5 file, for ParaView and VisIt.
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace dld {

class Hdf5File;

/// One membrane shape of the series; `vertices` is the path of a dataset (nv, 3) of double.
struct XdmfSnapshot {
  std::string vertices;
  double time = 0;  ///< step, or any other ascending number (force in pN)
};

/// A triangle mesh whose vertices move.
struct XdmfMesh {
  std::string name = "membrane";
  std::string faces = "/membrane/faces";  ///< (nf, 3) of int32
  std::size_t n_faces = 0, n_vertices = 0;
  std::vector<XdmfSnapshot> snapshots;
};

/// The mid-plane flow: /flow/velocity (nx, ny, 2) of double and /flow/solid (nx, ny) of uint8.
struct XdmfFlow {
  std::size_t nx = 0, ny = 0;
  double x0_um = 0, y0_um = 0;  ///< position of node (0, 0) relative to the pillar centre
  double spacing_um = 0;
  int velocity_bytes = 8;  ///< 8 if velocity was written as double, 4 if as float
};

struct XdmfDescription {
  std::optional<XdmfMesh> mesh;
  std::optional<XdmfFlow> flow;
};

/// The node positions (nx, ny, 3) as /flow/points_um: XDMF wants y to run slower than x, our arrays run
/// the other way round, so that the plane is described as a curvilinear mesh with explicit points.
void write_flow_points(Hdf5File& file, const XdmfFlow& flow);

/// Writes e.g. run.xdmf for run.h5 (which is named relative to it); nothing if there is nothing to show.
void write_xdmf(const std::filesystem::path& hdf5_path, const XdmfDescription& description);

}  // namespace dld
