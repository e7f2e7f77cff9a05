#include "membrane/stretching.hpp"

#include <lbfgs.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <span>
#include <stdexcept>

namespace dld {
namespace {

/// What the minimiser sees: lengths in mean edge lengths (its first step moves the nodes by about one
/// unit in all) and energies in kS times that squared, so that gradients are of order one.
struct Problem {
  Membrane& membrane;
  const ContactPatches& patches;
  double pull;  ///< force on each end
  double length_unit;
  double energy_unit;
  double tolerance;  ///< on the largest nodal force
  Eigen::MatrixX3d x, f;
  double residual = 0;
  int iterations = 0;
  const std::function<bool()>& stop;
  bool stopped = false;

  Problem(Membrane& m, const ContactPatches& p, double force, const Eigen::MatrixX3d& start,
          const MinimiserOptions& options)
      : membrane(m), patches(p), pull(force), x(start), f(start.rows(), 3), stop(options.stop) {
    const double shear = m.moduli().shear, area = m.reference_area();
    length_unit = std::sqrt(area / static_cast<double>(m.face_count()));
    energy_unit = shear * length_unit * length_unit;
    tolerance = options.force_tolerance * shear * std::sqrt(area / (4 * std::numbers::pi));
    update();
  }

  int size() const { return static_cast<int>(x.size()); }

  /// Nodal forces and their largest one at x.
  void update() {
    membrane.forces(x, f);
    patches.add_pull(pull, f);
    residual = std::sqrt(f.rowwise().squaredNorm().maxCoeff());
  }

  /// Potential energy at u (positions over the length unit) and its gradient g, both scaled.
  /// Infinite, and without computing anything, once the search is to stop: its line search then gives up.
  double evaluate(std::span<const double> u, std::span<double> g) {
    stopped = stopped || (stop && stop());
    if (stopped) return HUGE_VAL;
    x = length_unit * Eigen::Map<const Eigen::MatrixX3d>(u.data(), x.rows(), 3);
    update();
    Eigen::Map<Eigen::MatrixX3d>(g.data(), x.rows(), 3) = (-length_unit / energy_unit) * f;
    return (membrane.energy(x) - pull * patches.separation(x)) / energy_unit;
  }
};

double evaluate(void* problem, const double* u, double* g, int n, double) {
  const auto count = static_cast<std::size_t>(n);
  return static_cast<Problem*>(problem)->evaluate({u, count}, {g, count});
}

/// Called after each line search; a value other than zero stops the minimiser.
int progress(void* problem, const double*, const double*, double, double, double, double, int, int k, int) {
  auto& p = *static_cast<Problem*>(problem);
  p.iterations = k;
  return p.stopped || p.residual < p.tolerance ? 1 : 0;
}

/// One run of L-BFGS from problem.x.
void minimise(Problem& problem, int max_iterations) {
  const int n = problem.size();
  const std::unique_ptr<double, decltype(&lbfgs_free)> u(lbfgs_malloc(n), lbfgs_free);
  if (!u) throw std::bad_alloc();
  Eigen::Map<Eigen::MatrixX3d>(u.get(), problem.x.rows(), 3) = problem.x / problem.length_unit;
  lbfgs_parameter_t parameters;
  lbfgs_parameter_init(&parameters);
  parameters.m = 20;
  parameters.epsilon = 0;  // the residual decides, in progress()
  parameters.max_iterations = max_iterations;
  parameters.max_linesearch = 60;
  lbfgs(n, u.get(), nullptr, evaluate, progress, &problem, &parameters);
  problem.x = problem.length_unit * Eigen::Map<const Eigen::MatrixX3d>(u.get(), problem.x.rows(), 3);
  problem.update();
}

/// Mean of the vertices at this very x.
Eigen::RowVector3d tip(const Eigen::MatrixX3d& shape, double x) {
  Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
  int count = 0;
  for (const auto& vertex : shape.rowwise()) {
    if (vertex(0) != x) continue;
    sum += vertex;
    ++count;
  }
  return {x, sum.y() / count, sum.z() / count};
}

}  // namespace

ContactPatches::ContactPatches(const Eigen::MatrixX3d& shape, double contact_radius) {
  const Eigen::RowVector3d left_tip = tip(shape, shape.col(0).minCoeff()),
                           right_tip = tip(shape, shape.col(0).maxCoeff());
  for (int v = 0; v < shape.rows(); ++v) {
    if ((shape.row(v) - left_tip).norm() < contact_radius) left.push_back(v);
    if ((shape.row(v) - right_tip).norm() < contact_radius) right.push_back(v);
  }
  if (left.empty() || right.empty()) {
    throw std::invalid_argument("contact radius is smaller than the mesh edge: no vertex to pull at");
  }
}

void ContactPatches::add_pull(double force, Eigen::MatrixX3d& f) const {
  for (int v : right) f(v, 0) += force / static_cast<double>(right.size());
  for (int v : left) f(v, 0) -= force / static_cast<double>(left.size());
}

double ContactPatches::separation(const Eigen::MatrixX3d& x) const {
  double right_sum = 0, left_sum = 0;
  for (int v : right) right_sum += x(v, 0);
  for (int v : left) left_sum += x(v, 0);
  return right_sum / static_cast<double>(right.size()) - left_sum / static_cast<double>(left.size());
}

StretchedShape stretch(Membrane& membrane, const ContactPatches& patches, double force,
                       const Eigen::MatrixX3d& start, const MinimiserOptions& options) {
  Problem problem(membrane, patches, force, start, options);
  // A line search can give up where the curvature jumps; a fresh start without memory goes on from there.
  int iterations = 0;
  constexpr int max_restarts = 5;
  for (int run = 0; run <= max_restarts && problem.residual >= problem.tolerance; ++run) {
    if (iterations >= options.max_iterations || problem.stopped) break;
    problem.iterations = 0;
    minimise(problem, options.max_iterations - iterations);
    iterations += problem.iterations;
  }
  StretchedShape shape;
  shape.vertices = problem.x;
  const Eigen::RowVector3d extent = problem.x.colwise().maxCoeff() - problem.x.colwise().minCoeff();
  shape.axial = extent(0);
  shape.transverse = extent(1);
  shape.energy = membrane.energy(problem.x);
  shape.iterations = iterations;
  shape.residual = problem.residual;
  shape.stopped = problem.stopped;
  shape.converged = !problem.stopped && problem.residual < problem.tolerance;
  return shape;
}

std::vector<StretchedShape> stretch_ladder(Membrane& membrane, const ContactPatches& patches,
                                           const std::vector<double>& forces,
                                           const MinimiserOptions& options) {
  std::vector<StretchedShape> shapes;
  for (double force : forces) {
    const Eigen::MatrixX3d& start = shapes.empty() ? membrane.reference().vertices : shapes.back().vertices;
    shapes.push_back(stretch(membrane, patches, force, start, options));
  }
  return shapes;
}

}  // namespace dld
