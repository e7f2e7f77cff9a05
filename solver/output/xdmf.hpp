#pragma once
/// XDMF descriptions beside the HDF5 file, for VTK, ParaView, VisIt and meshio: what they draw are data sets
/// of the HDF5 file, named here with the shape that the readers expect (one row per node or triangle).
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace dld {

/// Values on the nodes or on the cells of a grid: a data set (n) or, with three components, (n, 3).
struct XdmfField {
  enum class Centre { node, cell };
  enum class Number { float64, float32, uint8 };
  std::string name, dataset;
  Centre centre = Centre::node;
  int components = 1;  ///< 1 or 3: readers take no vectors of two
  Number number = Number::float64;
};

/// A surface of triangles or quadrilaterals.
struct XdmfGrid {
  std::string name;
  std::string points;  ///< data set (n_points, 3) of double, um
  std::string cells;   ///< data set (n_cells, corners) of int32
  std::size_t n_points = 0, n_cells = 0;
  int corners = 3;  ///< 3 or 4
  std::vector<XdmfField> fields;
};

/// One shape of the membrane.
struct XdmfShape {
  XdmfGrid grid;
  double time = 0;  ///< s, or what moves instead of it: steps without a time scale, pN of a stretched cell
};

struct XdmfDescription {
  std::vector<XdmfShape> series;  ///< ascending in time; shapes at a time that is there already are left out
  std::vector<XdmfGrid> fixed;    ///< do not move: pillars, flow
};

/// All files that write_xdmf can write beside an HDF5 file: run.xdmf, run.flow.xdmf, run.pillars.xdmf.
std::vector<std::filesystem::path> xdmf_files(const std::filesystem::path& hdf5_path);

/// Writes run.xdmf for run.h5 (which is named relative to it), with everything, and one file for each fixed
/// grid alone, since meshio reads one grid from a file. Files of an earlier run with nothing to show now are
/// removed. Returns false, and writes nothing, if the readers could not find the HDF5 file: they end its name
/// at a colon.
bool write_xdmf(const std::filesystem::path& hdf5_path, const XdmfDescription& description);

}  // namespace dld
