#pragma once
/// Closed triangle meshes of cells: the subdivided icosahedron and the shapes made from it.
#include <Eigen/Core>
#include <string>
#include <vector>

namespace dld {

/// Closed, outward-oriented surface of triangles.
struct TriangleMesh {
  Eigen::MatrixX3d vertices;  ///< nv x 3, in any one length unit
  Eigen::MatrixX3i faces;     ///< nf x 3 vertex indices, counter-clockwise seen from outside
};

/// Interior edge v1 -> v2 of face (v1, v2, v3); on its other side lies the face (v2, v1, v4).
struct Edge {
  int v1, v2, v3, v4;
  int face, opposite_face;  ///< index of (v1, v2, v3) and of (v2, v1, v4)
};

/// All edges of a closed mesh, each once, in the order in which the faces first meet them.
/// Throws std::invalid_argument when the mesh is not closed or not consistently oriented.
std::vector<Edge> edges_of(const TriangleMesh& mesh);

/// Number of the vertex at (x, y, -z) for every vertex (x, y, z); a vertex on z = 0 is its own image.
/// Throws std::invalid_argument when a vertex has no image, to the last bit.
Eigen::VectorXi mirror_images(const Eigen::MatrixX3d& vertices);

/// Vertices and faces as a short text: other meshes give another one.
std::string fingerprint(const TriangleMesh& mesh);

/// Unit sphere: every face of the icosahedron with its 2-fold axes along x, y, z divided into
/// frequency^2 triangles and projected; 20 n^2 faces, 10 n^2 + 2 vertices. The vertex set is exactly
/// (bit by bit) symmetric about x = 0, y = 0 and z = 0.
TriangleMesh icosphere(int frequency);

/// Sphere of the given radius.
TriangleMesh sphere(int frequency, double radius);

/// Biconcave red blood cell at rest in the plane z = 0, radius r (Evans and Fung, Microvasc. Res. 4,
/// 1972): z = +-(r/2) sqrt(1 - q^2) (C0 + C2 q^2 + C4 q^4), q = rho / r.
TriangleMesh red_blood_cell(int frequency, double radius);

/// Ellipsoid with its semi-axes along x, y and z.
TriangleMesh ellipsoid(int frequency, const Eigen::RowVector3d& semi_axes);

/// Vertices (nv x 3) turned about the y axis: the +x end goes down by a positive angle, z' = z cos - x sin.
Eigen::MatrixX3d tilted(const Eigen::MatrixX3d& vertices, double tilt_deg);

/// Half the thickness of the Evans-Fung shape of unit radius divided by sqrt(1 - q^2), at q^2.
double evans_fung_profile(double q2);

/// Cell shape that a radius describes, by its name in the registry; throws std::invalid_argument naming the
/// known shapes.
TriangleMesh make_cell(const std::string& name, int frequency, double radius);

/// Names that make_cell knows.
std::vector<std::string> cell_shape_names();

}  // namespace dld
