#pragma once
/// Three numbers as plain values, so that loops over them vectorise.
namespace dld {

struct Vec3 {
  double x, y, z;
};

inline Vec3 operator+(Vec3 a, Vec3 b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vec3 operator-(Vec3 a, Vec3 b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec3 operator*(double s, Vec3 a) {
  return {s * a.x, s * a.y, s * a.z};
}
inline double dot(Vec3 a, Vec3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Row i of an nv x 3 column-major array whose columns start at x, y, z.
struct ConstColumns3 {
  const double *x, *y, *z;
  template <class Array>
  explicit ConstColumns3(const Array& a) : x(a.data()), y(a.data() + a.rows()), z(a.data() + 2 * a.rows()) {}
  Vec3 operator[](long i) const { return {x[i], y[i], z[i]}; }
};

/// The same for writing.
struct Columns3 {
  double *x, *y, *z;
  template <class Array>
  explicit Columns3(Array& a) : x(a.data()), y(a.data() + a.rows()), z(a.data() + 2 * a.rows()) {}
  void set(long i, Vec3 v) const { x[i] = v.x, y[i] = v.y, z[i] = v.z; }
};

}  // namespace dld
