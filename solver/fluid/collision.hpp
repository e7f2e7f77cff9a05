#pragma once
/// Collision at one node: two relaxation times (Ginzburg, Verhaeghe and d'Humieres 2008) with Guo, Zheng and
/// Shi's forcing (2002). BGK is the case of equal rates. Populations are stored as f_i - w_i, which gains
/// about three digits in single precision.
#include <type_traits>

#include "fluid/d3q19.hpp"

namespace dld {

/// Element type of a vector register type, or the type itself: the functions below work on both.
template <class Value, class = void>
struct ScalarOf {
  using type = Value;
};
template <class Value>
struct ScalarOf<Value, std::void_t<typename Value::value_type>> {
  using type = typename Value::value_type;
};
template <class Value>
using Scalar = typename ScalarOf<Value>::type;

/// Relaxation rates of the even (viscous) and odd parts of the populations.
template <class Value>
struct Rates {
  Value even, odd;
};

/// TRT: tau_odd = 1/2 + Lambda / (tau - 1/2).
template <class Value>
inline Rates<Value> trt_rates(Value tau, Scalar<Value> magic_parameter) {
  using Real = Scalar<Value>;
  const Value t = tau - Real(0.5);
  return {Real(1) / tau, t / (Real(0.5) * t + magic_parameter)};
}

/// BGK: one rate.
template <class Value>
inline Rates<Value> bgk_rates(Value tau) {
  const Value rate = Scalar<Value>(1) / tau;
  return {rate, rate};
}

/// The rates of either collision operator.
template <class Value>
inline Rates<Value> relaxation_rates(bool bgk, Value tau, Scalar<Value> magic_parameter) {
  return bgk ? bgk_rates(tau) : trt_rates(tau, magic_parameter);
}

/// Density deviation and velocity of a node.
template <class Value>
struct Moments {
  Value density_deviation;  ///< rho - 1
  Value ux, uy, uz;         ///< u = (sum c f + F/2) / rho; Stokes: without the division
};

/// One node's collision. `f` holds 19 values and is overwritten; returns the moments that were used.
/// Stokes = true drops the terms of second order in u (equilibrium and source) and takes rho = 1 in the
/// momentum, so that the scheme is exactly linear.
template <bool Stokes, class Value>
[[gnu::always_inline]] inline Moments<Value> collide(Value (&f)[d3q19::directions], Value fx, Value fy,
                                                     Value fz, Rates<Value> rate) {
  using namespace d3q19;
  using Real = Scalar<Value>;
  constexpr Real half = Real(0.5);
  // Even and odd parts of the pairs take the place of the populations: f[2p+1] = f_a + f_b, f[2p+2] = f_a -
  // f_b. The sums over opposite pairs are written out by the compiler (c is constant).
  Value deviation = f[0], jx = Real(0), jy = Real(0), jz = Real(0);
#pragma GCC unroll 9
  for (int p = 0; p < pairs; ++p) {
    const Velocity v = c[static_cast<std::size_t>(2 * p + 1)];
    const Value sum = f[2 * p + 1] + f[2 * p + 2], difference = f[2 * p + 1] - f[2 * p + 2];
    f[2 * p + 1] = sum;
    f[2 * p + 2] = difference;
    deviation += sum;
    if (v.x != 0) jx += Real(v.x) * difference;
    if (v.y != 0) jy += Real(v.y) * difference;
    if (v.z != 0) jz += Real(v.z) * difference;
  }
  Value ux = jx + half * fx, uy = jy + half * fy, uz = jz + half * fz;
  Value rho = Real(1), u2 = Real(0), uf = Real(0);
  if constexpr (!Stokes) {
    rho += deviation;
    const Value inverse_rho = Real(1) / rho;
    ux *= inverse_rho;
    uy *= inverse_rho;
    uz *= inverse_rho;
    u2 = ux * ux + uy * uy + uz * uz;
    uf = ux * fx + uy * fy + uz * fz;
  }
  const Value even_source = Real(1) - half * rate.even, odd_source = Real(1) - half * rate.odd;
  const Value keep_even = half - half * rate.even, keep_odd = half - half * rate.odd;

  // What a pair gains: 3 w c.g in the odd part, g = rate rho u + source F, and w h in the even one.
  const Value momentum = Stokes ? rate.odd : rate.odd * rho;
  const Value gx = momentum * ux + odd_source * fx, gy = momentum * uy + odd_source * fy,
              gz = momentum * uz + odd_source * fz;
  Value h = rate.even * deviation;
  if constexpr (!Stokes) h -= Real(1.5) * rate.even * rho * u2 + Real(3) * even_source * uf;
  f[0] += Real(weight_rest) * h - rate.even * f[0];

#pragma GCC unroll 9
  for (int p = 0; p < pairs; ++p) {
    const Velocity v = c[static_cast<std::size_t>(2 * p + 1)];
    const Real w = Real(weight(2 * p + 1)), w3 = Real(3 * weight(2 * p + 1));
    Value cg = Real(0), cu = Real(0), cf = Real(0);
    if (v.x != 0) cg += Real(v.x) * (w3 * gx);
    if (v.y != 0) cg += Real(v.y) * (w3 * gy);
    if (v.z != 0) cg += Real(v.z) * (w3 * gz);
    Value gain = w * h;
    if constexpr (!Stokes) {
      if (v.x != 0) cu += Real(v.x) * ux, cf += Real(v.x) * fx;
      if (v.y != 0) cu += Real(v.y) * uy, cf += Real(v.y) * fy;
      if (v.z != 0) cu += Real(v.z) * uz, cf += Real(v.z) * fz;
      gain += w * cu * (Real(4.5) * rate.even * rho * cu + Real(9) * even_source * cf);
    }
    const Value even = keep_even * f[2 * p + 1] + gain, odd = keep_odd * f[2 * p + 2] + cg;
    f[2 * p + 1] = even + odd;
    f[2 * p + 2] = even - odd;
  }
  return {deviation, ux, uy, uz};
}

}  // namespace dld
