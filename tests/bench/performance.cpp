/// How fast the solver is, and against what: prints a table (CSV) of
///   quantity, precision, height, threads, value, unit, share_of_roofline
/// The share of a row "scaling" is its parallel efficiency. Medians of several repetitions; the peaks of the
/// machine are measured in the same run. Not a test.
///
///   cmake --build build --target performance && build/performance > performance.csv
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <experimental/simd>
#include <fstream>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "fluid/collision.hpp"
#include "membrane/regularisation.hpp"
#include "scene/setup.hpp"

namespace {

using namespace dld;
namespace stdx = std::experimental;

constexpr int repetitions = 7;

/// The processor's name; "unknown" where the system does not tell.
std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

/// Median seconds of one call.
double seconds(const std::function<void()>& work) {
  std::vector<double> times;
  work();
  for (int k = 0; k < repetitions; ++k) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    times.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  std::nth_element(times.begin(), times.begin() + repetitions / 2, times.end());
  return times[repetitions / 2];
}

template <class Real>
const char* precision() {
  return sizeof(Real) == 4 ? "single" : "double";
}

void row(const std::string& quantity, const char* precision_name, const char* height, double value,
         const char* unit, double share = -1, int threads = 1) {
  std::printf("%s,%s,%s,%d,%.5g,%s,", quantity.c_str(), precision_name, height, threads, value, unit);
  if (share >= 0) std::printf("%.3f", share);
  std::printf("\n");
  std::fflush(stdout);
}

/// Fused multiply-adds per second on independent registers, in flop/s.
template <class Real>
double peak_flops() {
  using V = stdx::native_simd<Real>;
  constexpr int chains = 12, rounds = 2000000;
  V a[chains];
  for (int k = 0; k < chains; ++k) a[k] = V([&](auto lane) { return Real(0.1) * Real(int(lane) + k); });
  const V factor = Real(0.9999), addend = Real(1e-4);
  const double time = seconds([&] {
    V b[chains];  // registers
    for (int k = 0; k < chains; ++k) b[k] = a[k];
    for (int r = 0; r < rounds; ++r) {
#pragma GCC unroll 12
      for (int k = 0; k < chains; ++k) b[k] = b[k] * factor + addend;
    }
    for (int k = 0; k < chains; ++k) a[k] = b[k];
  });
  Real sum = 0;
  for (const V& v : a) sum += stdx::reduce(v);
  if (sum == Real(12345)) std::printf("#\n");  // the result is used
  return 2.0 * chains * rounds * static_cast<double>(V::size()) / time;
}

/// Bytes per second of y += a x over arrays of 1 MiB in all (second-level cache).
template <class Real>
double cache_bandwidth() {
  constexpr std::size_t n = (1u << 19) / sizeof(Real);
  std::vector<Real> x(n, Real(1)), y(n, Real(2));
  constexpr int rounds = 400;
  const double time = seconds([&] {
    for (int r = 0; r < rounds; ++r) {
      const Real a = Real(1e-3) * Real(r);
#pragma omp simd
      for (std::size_t i = 0; i < n; ++i) y[i] += a * x[i];
    }
  });
  return 3.0 * static_cast<double>(n * sizeof(Real)) * rounds / time;
}

/// Nodes per second of the collision alone: 19 contiguous arrays, in place, no streaming.
template <class Real>
double bare_collision(std::size_t nodes) {
  using V = stdx::native_simd<Real>;
  const std::size_t n = nodes / V::size() * V::size(), stride = n + 16;
  std::vector<Real> f(19 * stride, Real(1e-3));
  constexpr int rounds = 50;
  const double time = seconds([&] {
    for (int r = 0; r < rounds; ++r) {
      for (std::size_t k = 0; k < n; k += V::size()) {
        V p[19];
        for (std::size_t i = 0; i < 19; ++i) p[i].copy_from(&f[i * stride + k], stdx::element_aligned);
        const V fx = Real(1e-5), zero = Real(0);
        collide<true>(p, fx, zero, zero, trt_rates(V(Real(1)), Real(0.1875)));
        for (std::size_t i = 0; i < 19; ++i) p[i].copy_to(&f[i * stride + k], stdx::element_aligned);
      }
    }
  });
  return static_cast<double>(n) * rounds / time;
}

Case scene(int refinement, bool half) {
  Case c;
  c.geometry.height = half ? "half" : "full";
  c.fluid.lattice_spacing_um = 0.4 / refinement;
  c.fluid.force_density = 9.36e-5 / (refinement * refinement * refinement);
  c.cell.mesh_frequency = 10 * refinement;
  return c;
}

template <class Real>
void fluid(int refinement, bool half, double peak) {
  const Case c = scene(refinement, half);
  const Device device = device_lu(c);
  Lattice<Real> lattice(make_unit_cell(c, device), make_fluid_model(c));
  lattice.set_uniform_force(c.fluid.force_density, 0, 0);
  const int steps = 200 / (refinement * refinement * refinement) / (half ? 1 : 2) + 4;
  const double time = seconds([&] {
    for (int k = 0; k < 2 * (steps / 2); ++k) lattice.step();
  });
  const double rate = static_cast<double>(lattice.fluid_nodes()) * 2 * (steps / 2) / time;
  const std::string size = std::to_string(80 * refinement) + "^2";
  row("fluid nodes " + size, precision<Real>(), half ? "half" : "full",
      static_cast<double>(lattice.fluid_nodes()), "1");
  row("fluid step " + size, precision<Real>(), half ? "half" : "full", rate * 1e-6, "MLUPS", rate / peak);
  row("memory " + size, precision<Real>(), half ? "half" : "full",
      static_cast<double>(lattice.memory_bytes()) / (1024 * 1024), "MiB");
}

template <class Real>
void whole_step(int refinement, bool half, int threads = 1, const CouplingParameters& coupling = {},
                const std::string& label = "") {
  Case c = scene(refinement, half);
  c.coupling = coupling;
  const LatticeParameters l = to_lattice(c);
  const Device device = device_lu(c);
  Lattice<Real> lattice(make_unit_cell(c, device), make_fluid_model(c));
  lattice.set_uniform_force(l.force_density, 0, 0);
  lattice.set_threads(threads);
  Membrane membrane(make_cell("red_blood_cell", c.cell.mesh_frequency, l.cell_radius),
                    make_moduli(c, to_lattice(c)));
  Eigen::MatrixX3d x = membrane.reference().vertices;
  x.col(1).array() += device.gap_line().middle();
  CoupledCell<Real> cell(lattice, membrane, device.pillars(), make_coupling_model(c), x);
  const int steps = refinement == 1 ? 200 : 20;
  const double time = seconds([&] {
    for (int k = 0; k < steps; ++k) cell.step();
  });
  const std::string size = std::to_string(80 * refinement) + "^2";
  const char* height = half ? "half" : "full";
  row("whole step " + size + label, precision<Real>(), height, 1e3 * time / steps, "ms", -1, threads);
  if (sizeof(Real) == 8 || refinement > 1 || !half || threads > 1 || !label.empty()) return;
  Eigen::MatrixX3d f = x, v = x;
  MembraneForces step_forces = membrane.step_forces(half ? MirrorSymmetry::about_z : MirrorSymmetry::none);
  Eigen::MatrixX3d g = x;
  row("membrane forces", "double", height, 1e3 * seconds([&] { step_forces.forces(cell.positions(), f, g); }),
      "ms");
  row("regularisation", "double", "-", 1e3 * seconds([&] { tangential_relaxation(membrane, f, g, 0.01, v); }),
      "ms");
  ImmersedBoundary<Real> boundary(lattice, Kernel::phi4, coupled_nodes(membrane.reference().vertices, half));
  const std::vector<std::uint8_t> near(static_cast<std::size_t>(x.rows()), 0);
  row("stencils", "single", height, 1e3 * seconds([&] { boundary.locate(cell.positions(), near); }), "ms");
  row("spreading", "single", height, 1e3 * seconds([&] { boundary.spread(f); }), "ms");
  row("interpolation", "single", height, 1e3 * seconds([&] { boundary.interpolate(v); }), "ms");
  ViscosityField<Real> viscosity(lattice, membrane.reference().faces, 1.0, 3.0, false);
  row("inside/outside field", "single", height, 1e3 * seconds([&] { viscosity.update(cell.positions()); }),
      "ms");
}

/// The same work on 1, 2, 4 ... threads, as many as there are cores: fluid in full height, and the whole step
/// of a passage.
void strong_scaling() {
  const int cores = static_cast<int>(std::thread::hardware_concurrency());
  for (const int refinement : {1, 2, 4}) {
    const Case c = scene(refinement, false);
    const Device device = device_lu(c);
    Lattice<float> lattice(make_unit_cell(c, device), make_fluid_model(c));
    lattice.set_uniform_force(c.fluid.force_density, 0, 0);
    const int steps = 2 * (100 / (refinement * refinement * refinement) + 1);
    const std::string size = std::to_string(lattice.cell().nx) + "^2 x " + std::to_string(lattice.cell().nz);
    double alone = 0;
    for (int threads = 1; threads <= cores; threads *= 2) {
      lattice.set_threads(threads);
      const double time = seconds([&] {
        for (int k = 0; k < steps; ++k) lattice.step();
      });
      if (threads == 1) alone = time;
      row("scaling " + size, "single", "full", 1e3 * time / steps, "ms", alone / time / threads, threads);
    }
  }
  for (int threads = 2; threads <= cores; threads *= 2) {
    for (const int refinement : {1, 2}) whole_step<float>(refinement, true, threads);
  }
}

/// Cost of the cell's forces for finer meshes.
void mesh_growth() {
  for (const int frequency : {5, 10, 20, 40}) {
    Case c;
    c.cell.mesh_frequency = frequency;
    const Membrane membrane(make_cell("red_blood_cell", frequency, to_lattice(c).cell_radius),
                            make_moduli(c, to_lattice(c)));
    MembraneForces step_forces = membrane.step_forces(MirrorSymmetry::about_z);
    Eigen::MatrixX3d f = membrane.reference().vertices, g = f;
    const double time = seconds([&] { step_forces.forces(membrane.reference().vertices, f, g); });
    row("membrane forces " + std::to_string(membrane.reference().faces.rows()) + " faces", "double", "half",
        1e3 * time, "ms");
  }
}

template <class Real>
void all() {
  const double flops = peak_flops<Real>(), bandwidth = cache_bandwidth<Real>();
  row("peak fused multiply-add", precision<Real>(), "-", flops * 1e-9, "Gflop/s");
  row("cache bandwidth", precision<Real>(), "-", bandwidth * 1e-9, "GB/s");
  const double bare = bare_collision<Real>(26634);
  // Roofline of the collision: 19 values read and written per node, about 250 flops.
  const double roof = std::min(bandwidth / (38.0 * sizeof(Real)), flops / 250.0);
  row("bare collision", precision<Real>(), "-", bare * 1e-6, "MLUPS", bare / roof);
  for (const bool half : {true, false}) {
    for (const int refinement : {1, 2, 4}) {
      if (refinement == 4 && !half) continue;
      fluid<Real>(refinement, half, bare);
    }
    whole_step<Real>(1, half);
    whole_step<Real>(2, half);
  }
  for (const std::string kernel : {"phi4", "phi4_corrected"}) {
    CouplingParameters coupling;
    coupling.kernel = kernel;
    coupling.steps_per_update = 1;
    whole_step<Real>(1, true, 1, coupling, " with " + kernel + " in each step");
  }
}

}  // namespace

int main() {
  std::printf("quantity,precision,height,threads,value,unit,share_of_roofline\n");
  row("processor", "-", "-", 1, processor().c_str());
  row("fluid steps per update", "-", "-", Case{}.coupling.steps_per_update, "1");
  row("updates per inside/outside field", "-", "-", Case{}.cell.viscosity_update_interval, "1");
  all<float>();
  all<double>();
  strong_scaling();
  mesh_growth();
  return 0;
}
