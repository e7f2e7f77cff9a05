#pragma once
/// Immersed boundary (Peskin 2002): spreads nodal forces to the lattice and interpolates its velocity back.
/// With the mirror plane one node of each mirror pair stands for both.
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "coupling/coupled_nodes.hpp"
#include "coupling/kernel.hpp"
#include "fluid/lattice.hpp"

namespace dld {

template <class Real>
class ImmersedBoundary {
 public:
  ImmersedBoundary(Lattice<Real>& lattice, Kernel kernel, std::vector<CoupledNode> nodes);

  /// Stencils for the positions x (nv x 3, physical lattice coordinates of the unit cell). Nodes with
  /// near_solid set have their weights restricted to fluid nodes.
  void locate(const Eigen::MatrixX3d& x, const std::vector<std::uint8_t>& near_solid);
  /// Adds the forces f (nv x 3) to lattice.force; the total over fluid nodes equals the total over nodes
  /// (but for those with no fluid node in their stencil, deep inside a pillar, whose force is lost).
  void spread(const Eigen::MatrixX3d& f);
  /// v (nv x 3) = lattice.velocity at the nodes, zero inside solids.
  void interpolate(Eigen::MatrixX3d& v);
  /// f (nv x 3) = lattice.force at the nodes, interpolated like a velocity: between spread() and
  /// clear_force().
  void interpolate_force(Eigen::MatrixX3d& f);
  /// Sets lattice.force back to zero where spread() has written.
  void clear_force();

  const std::vector<ActiveRange>& active() const { return active_; }
  const std::vector<CoupledNode>& nodes() const { return nodes_; }

 private:
  struct Stencil {
    std::array<Real, 4> wx, wy, wz;
    std::array<Real, 4> sign;            ///< -1 where the layer is a mirror image
    std::array<std::uint32_t, 4> plane;  ///< index of (x, first y, layer 0)
    std::array<std::uint32_t, 4> layer;  ///< offset of the layer
    Real scale;                          ///< 1 / sum of the weights on fluid nodes
    bool masked;
  };

  template <class Phi>
  void locate_with(const Eigen::MatrixX3d& x, const std::vector<std::uint8_t>& near_solid);
  template <class Phi>
  Stencil stencil(double x, double y, double z, bool near_solid) const;
  void mark_active(const Eigen::MatrixX3d& x);
  /// Is it worth calling other threads for work of about 20 ns a node?
  bool shared() const { return lattice_.threads() > 1 && nodes_.size() > 1000; }
  /// Rows continue periodically into their padding, so that a stencil never wraps within a row.
  void fold_force();
  using Field = std::array<LatticeArray<Real>, 3>;
  void extend(Field& field);
  void gather(const Field& field, Eigen::MatrixX3d& v) const;
  template <class Function>
  void for_wrapped_rows(Function&& row);

  /// Where a raw layer z stands: offset of its row, sign of z-components, 0 if beyond a wall.
  struct Layer {
    std::uint32_t offset = 0;
    double sign = 1, inside = 1;
  };
  const Layer& layer(int raw) const { return layers_[static_cast<std::size_t>(raw + layer_margin)]; }
  static constexpr int layer_margin = 64;

  Lattice<Real>& lattice_;
  Kernel kernel_;
  std::vector<Layer> layers_;
  std::vector<CoupledNode> nodes_;
  std::vector<Stencil> stencils_;
  std::vector<ActiveRange> active_;
  int width_;
};

extern template class ImmersedBoundary<float>;
extern template class ImmersedBoundary<double>;

}  // namespace dld
