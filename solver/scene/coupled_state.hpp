#pragma once
/// Fluid and cell of a coupled run in a checkpoint. Nothing of it changes the run that goes on, so it may be
/// saved at any moment at which the fluid has made an even number of steps and the cell whole updates.
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "coupling/coupled_cell.hpp"
#include "fluid/lattice.hpp"
#include "output/checkpoint.hpp"
#include "output/interrupt.hpp"
#include "scene/scene.hpp"
#include "scene/setup.hpp"

namespace dld {

/// nv x 3 matrices as arrays of a checkpoint.
std::vector<double> to_values(const Eigen::MatrixX3d& matrix);
Eigen::MatrixX3d to_matrix(const std::vector<double>& values);

/// Steps after which fluid and cell are both whole.
inline int whole_steps(const CouplingModel& model) {
  return 2 * model.steps_per_update;
}

template <class Real>
void save_coupled(Checkpoint& checkpoint, const Lattice<Real>& lattice, const CoupledCell<Real>& cell) {
  const auto& populations = lattice.populations();
  checkpoint.set("populations", std::vector<Real>(populations.begin(), populations.end()));
  const auto force = lattice.uniform_force();
  checkpoint.set("uniform_force", std::vector<double>(force.begin(), force.end()));
  const auto state = cell.state();
  checkpoint.set("positions", to_values(state.positions));
  checkpoint.set("marked", to_values(state.marked));
  checkpoint.set("steps", static_cast<std::int64_t>(state.steps));
  checkpoint.set("odd_columns", static_cast<std::int64_t>(state.odd_columns));
}

/// Whether the arrays have the sizes of this lattice and mesh.
template <class Real>
bool coupled_fits(const Checkpoint& checkpoint, const Lattice<Real>& lattice, Eigen::Index vertices) {
  const auto of_mesh = [&](const char* name) {
    return static_cast<Eigen::Index>(checkpoint.get<std::vector<double>>(name).size()) == 3 * vertices;
  };
  return checkpoint.get<std::vector<Real>>("populations").size() == lattice.populations().size() &&
         checkpoint.get<std::vector<double>>("uniform_force").size() == 3 && of_mesh("positions") &&
         of_mesh("marked");
}

/// The way back; the sizes fit. Returns the steps that were made.
template <class Real>
long restore_coupled(const Checkpoint& checkpoint, Lattice<Real>& lattice, CoupledCell<Real>& cell) {
  const auto& populations = checkpoint.get<std::vector<Real>>("populations");
  lattice.populations().assign(populations.begin(), populations.end());
  const auto& force = checkpoint.get<std::vector<double>>("uniform_force");
  lattice.set_uniform_force(force[0], force[1], force[2]);
  const long steps = checkpoint.integer("steps");
  cell.restore({to_matrix(checkpoint.get<std::vector<double>>("positions")),
                to_matrix(checkpoint.get<std::vector<double>>("marked")), steps,
                checkpoint.integer("odd_columns")});
  return steps;
}

/// Case and build: another build may keep its populations in another order.
std::string checkpoint_identity(const Case& c);

/// Checkpoints of a scene whose state is a fluid, a cell and what the scene adds.
template <class Real>
class CoupledCheckpoint {
 public:
  /// The cell may come later: what an earlier run left is read before anything is simulated, so that a
  /// checkpoint that does not fit is known at once.
  CoupledCheckpoint(const Case& c, RunContext& context, Lattice<Real>& lattice, Eigen::Index vertices)
      : identity_(checkpoint_identity(c)),
        context_(context),
        lattice_(lattice),
        vertices_(vertices),
        unit_(whole_steps(make_coupling_model(c))) {}

  /// What an earlier run left; nothing without one, or if it is not to be resumed. Builds of the same commit
  /// can still differ in the layout of their arrays.
  std::optional<Checkpoint> load() {
    if (!context_.resume) return std::nullopt;
    auto saved = Checkpoint::load(context_.checkpoint, identity_, std::cerr);
    if (!saved) return saved;
    if (!coupled_fits(*saved, lattice_, vertices_)) throw CheckpointMismatch(context_.checkpoint);
    context_.owns_checkpoint = true;
    return saved;
  }

  /// Puts fluid and cell in the saved state; returns its step.
  long restore(const Checkpoint& saved, CoupledCell<Real>& cell) {
    return restore_coupled(saved, lattice_, cell);
  }

  /// Fluid and cell are both whole after this many steps: the state can be saved, and a run may stop.
  bool whole(long step) const { return step % unit_ == 0; }

  /// Saves fluid and cell, and what `add(Checkpoint&)` says of the scene; after a whole step.
  template <class Function>
  void save(const CoupledCell<Real>& cell, Function&& add) {
    Checkpoint checkpoint(identity_);
    save_coupled(checkpoint, lattice_, cell);
    add(checkpoint);
    checkpoint.save(context_.checkpoint);
    context_.owns_checkpoint = true;
    context_.save_timer.restart();
  }

  /// To be called after every step: true if the run is to stop, whose state is saved then, as it is now and
  /// then by the clock and where the scene asks for it (`wanted`).
  template <class Function>
  bool stop(long step, const CoupledCell<Real>& cell, Function&& add, bool wanted = false) {
    if (!whole(step)) return false;
    const bool asked = interrupted() != 0;
    if (asked || wanted || context_.save_timer.due()) save(cell, add);
    return asked;
  }

 private:
  std::string identity_;
  RunContext& context_;
  Lattice<Real>& lattice_;
  Eigen::Index vertices_;
  int unit_;
};

}  // namespace dld
