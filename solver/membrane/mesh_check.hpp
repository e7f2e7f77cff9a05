#pragma once
/// What a mesh from a file must be to be the surface of a cell, and how large it is.
#include <string>
#include <vector>

#include "membrane/mesh.hpp"

namespace dld {

/// One thing that is wrong with a mesh.
struct MeshFault {
  std::string found;    ///< "3 edges belong to one face only (the first: vertices 4 and 7)"
  std::string allowed;  ///< what a cell needs
  std::string advice;   ///< what to change
};

/// All that keeps a mesh from being a cell: numbers that are none, vertices that no face has or that stand
/// twice, faces without an area or that stand twice, holes, faces turned against their neighbours, more than
/// one piece, handles, the inside turned out. Whether the surface cuts itself is not looked at.
std::vector<MeshFault> mesh_faults(const TriangleMesh& mesh);

/// Gives every vertex the exact mirror image about z = 0 that it has to within `tolerance`; false, and the
/// mesh as it was, if it has none or if the image of some face is no face.
bool make_mirror_symmetric(TriangleMesh& mesh, double tolerance);

/// Moves the mean of the vertices to the origin: the centre of a cell is the mean of its nodes.
void centre_mesh(TriangleMesh& mesh);

/// Lengths of edges, in the unit of the mesh.
struct EdgeLengths {
  double mean = 0, longest = 0;
};
EdgeLengths edge_lengths(const TriangleMesh& mesh);

/// Largest distance of a vertex to the z axis.
double radius_in_plane(const TriangleMesh& mesh);

}  // namespace dld
