#pragma once
/// The control of the mean flow across the driving force.
#include <array>

#include "fluid/lattice.hpp"
#include "parameters/units.hpp"

namespace dld {

/// Free: only the driving force. Blocked: a force across it that brings the mean velocity across it to zero,
/// as the side walls of a device do. Integral control, tuned to be critically damped for the friction (1 /
/// steps) that slows a lateral flow down.
class LateralFlow {
 public:
  static constexpr int interval = 20;  ///< steps between updates

  LateralFlow(bool blocked, const LatticeParameters& l, double friction)
      : drive_(l.drive), blocked_(blocked) {
    gain_ = 0.25 * interval * friction * friction;
  }
  bool blocked() const { return blocked_; }

  /// Components of a vector along the driving force and across it, to its left.
  double along(const std::array<double, 3>& v) const { return drive_[0] * v[0] + drive_[1] * v[1]; }
  double across(const std::array<double, 3>& v) const { return drive_[0] * v[1] - drive_[1] * v[0]; }

  /// To be called every `interval` steps with the mean velocity of the fluid.
  template <class Real>
  void update(Lattice<Real>& lattice, const std::array<double, 3>& mean_velocity) const {
    if (!blocked_) return;
    const auto f = lattice.uniform_force();
    const double v = across(mean_velocity);
    lattice.set_uniform_force(f[0] + gain_ * (v * drive_[1]), f[1] - gain_ * (v * drive_[0]), f[2]);
  }

  /// The same by the number of steps that were made: to be called after each of them.
  template <class Real>
  void after_step(Lattice<Real>& lattice, long steps) const {
    if (blocked_ && steps % interval == 0) update(lattice, lattice.statistics().velocity);
  }

 private:
  std::array<double, 2> drive_;
  bool blocked_;
  double gain_ = 0.0;
};

}  // namespace dld
