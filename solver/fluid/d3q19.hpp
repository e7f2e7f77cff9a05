#pragma once
/// The D3Q19 velocity set (Qian, d'Humieres and Lallemand 1992). Direction 0 rests; directions 2p + 1 and
/// 2p + 2 are opposite, so that the two-relaxation-time operator works on pairs.
#include <array>

namespace dld::d3q19 {

inline constexpr int directions = 19;
inline constexpr int pairs = 9;

struct Velocity {
  int x, y, z;
};

inline constexpr std::array<Velocity, directions> c{{{0, 0, 0},
                                                     {1, 0, 0},
                                                     {-1, 0, 0},
                                                     {0, 1, 0},
                                                     {0, -1, 0},
                                                     {0, 0, 1},
                                                     {0, 0, -1},
                                                     {1, 1, 0},
                                                     {-1, -1, 0},
                                                     {1, -1, 0},
                                                     {-1, 1, 0},
                                                     {1, 0, 1},
                                                     {-1, 0, -1},
                                                     {1, 0, -1},
                                                     {-1, 0, 1},
                                                     {0, 1, 1},
                                                     {0, -1, -1},
                                                     {0, 1, -1},
                                                     {0, -1, 1}}};

inline constexpr double weight_rest = 1.0 / 3.0;
inline constexpr double weight_axis = 1.0 / 18.0;
inline constexpr double weight_diagonal = 1.0 / 36.0;

constexpr double weight(int i) {
  return i == 0 ? weight_rest : i <= 6 ? weight_axis : weight_diagonal;
}
constexpr int opposite(int i) {
  return i == 0 ? 0 : (i % 2 == 1 ? i + 1 : i - 1);
}

/// Direction with the z-component reversed (mirror plane).
constexpr int mirrored(int i) {
  for (int k = 0; k < directions; ++k) {
    const auto a = c[static_cast<std::size_t>(i)], b = c[static_cast<std::size_t>(k)];
    if (a.x == b.x && a.y == b.y && a.z == -b.z) return k;
  }
  return -1;
}

}  // namespace dld::d3q19
