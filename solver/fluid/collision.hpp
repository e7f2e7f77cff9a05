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
  // Moments. The sums over opposite pairs are written out by the compiler (c is constant).
  Value deviation = f[0], jx = Real(0), jy = Real(0), jz = Real(0);
#pragma GCC unroll 9
  for (int p = 0; p < pairs; ++p) {
    const Velocity v = c[static_cast<std::size_t>(2 * p + 1)];
    const Value difference = f[2 * p + 1] - f[2 * p + 2];
    deviation += f[2 * p + 1] + f[2 * p + 2];
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
  const Value even_source = Real(1) - half * rate.even;
  const Value odd_source = Real(1) - half * rate.odd;

  constexpr Real w0 = Real(weight_rest);
  Value rest_equilibrium = w0 * deviation;
  if constexpr (!Stokes) rest_equilibrium -= w0 * Real(1.5) * rho * u2;
  f[0] += rate.even * (rest_equilibrium - f[0]);
  if constexpr (!Stokes) f[0] -= even_source * w0 * Real(3) * uf;

#pragma GCC unroll 9
  for (int p = 0; p < pairs; ++p) {
    const Velocity v = c[static_cast<std::size_t>(2 * p + 1)];
    const Real w = Real(weight(2 * p + 1));
    Value cu = Real(0), cf = Real(0);
    if (v.x != 0) cu += Real(v.x) * ux, cf += Real(v.x) * fx;
    if (v.y != 0) cu += Real(v.y) * uy, cf += Real(v.y) * fy;
    if (v.z != 0) cu += Real(v.z) * uz, cf += Real(v.z) * fz;
    const Value even = half * (f[2 * p + 1] + f[2 * p + 2]);
    const Value odd = half * (f[2 * p + 1] - f[2 * p + 2]);
    Value even_equilibrium = w * deviation;
    if constexpr (!Stokes) even_equilibrium += w * rho * (Real(4.5) * cu * cu - Real(1.5) * u2);
    Value odd_equilibrium = Real(3) * w * cu;
    if constexpr (!Stokes) odd_equilibrium *= rho;
    Value even_new = even + rate.even * (even_equilibrium - even);
    if constexpr (!Stokes) even_new += even_source * w * (Real(9) * cu * cf - Real(3) * uf);
    const Value odd_new = odd + rate.odd * (odd_equilibrium - odd) + odd_source * w * Real(3) * cf;
    f[2 * p + 1] = even_new + odd_new;
    f[2 * p + 2] = even_new - odd_new;
  }
  return {deviation, ux, uy, uz};
}

}  // namespace dld
