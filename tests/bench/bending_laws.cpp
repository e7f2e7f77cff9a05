/// What each bending law costs: prints a table (CSV) of
///   law, prefactor, fold_modulus_ratio, sphere_ratio, squeeze_anisotropy, mesh_frequency
/// The ratios are measured: the modulus over kB that a sheet feels on a cylinder of a radius of
/// mesh_frequency edges (about that of the cell in its own edges), mean of three directions of the lattice;
/// the energy of a sphere from flat over 8 pi kB; and (largest - smallest) / mean energy of the resting cell
/// against the direction of a squeeze by 1.3. The mean-curvature law has no prefactor. Not a test.
///
///   cmake --build build --target bending_laws && build/bending_laws > bending_laws.csv
#include <cstdio>
#include <numbers>
#include <string>

#include "support/bending_cases.hpp"

int main() {
  using namespace dld;
  std::printf("law,prefactor,fold_modulus_ratio,sphere_ratio,squeeze_anisotropy,mesh_frequency\n");
  for (const auto& known : bending_laws) {
    for (const int frequency : {8, 20, 40}) {
      double fold = 0;
      for (const int turn : {0, 15, 30})
        fold += test::fold_ratio(known.law, frequency, turn * std::numbers::pi / 180) / 3;
      std::printf("%s,", std::string(known.name).c_str());
      if (known.hinge_prefactor > 0) std::printf("%.10g", known.hinge_prefactor);
      std::printf(",%.10g,%.10g,%.10g,%d\n", fold, test::sphere_ratio(known.law, sphere(frequency, 1.0)),
                  test::squeeze_anisotropy(known.law, frequency), frequency);
    }
  }
  return 0;
}
