#pragma once
/// Vectors stored as rows of four doubles (the last one unused), so that one vector is one load.
///
/// Loops over a mesh read vectors by index: a row is copied whole, and a run of copied rows is worked on by
/// the vectorised loop that follows.
#include <Eigen/Core>

#include "membrane/vec3.hpp"

namespace dld {

using Rows = Eigen::Matrix4Xd;

/// Rows that are copied before a vectorised loop runs over them: few enough to stay in the first-level cache.
constexpr int chunk_size = 64;
using RowChunk = Eigen::Matrix<double, 4, chunk_size>;

/// Vector i of an array of rows.
struct ConstRows {
  const double* data;
  template <class Array>
  explicit ConstRows(const Array& rows) : data(rows.data()) {}
  Vec3 operator[](long i) const { return {data[4 * i], data[4 * i + 1], data[4 * i + 2]}; }
};

/// The same for writing.
struct RowsOut {
  double* data;
  template <class Array>
  explicit RowsOut(Array& rows) : data(rows.data()) {}
  void set(long i, Vec3 v) const {
    data[4 * i] = v.x, data[4 * i + 1] = v.y, data[4 * i + 2] = v.z, data[4 * i + 3] = 0;
  }
};

/// chunk[i] = rows[index[i]] for the first n places.
inline void fetch_rows(const Rows& rows, const int* index, int n, RowChunk& chunk) {
  for (int i = 0; i < n; ++i) chunk.col(i) = rows.col(index[i]);
}

/// chunk[i] = rows[to[i]] - rows[from[i]].
inline void fetch_differences(const Rows& rows, const int* from, const int* to, int n, RowChunk& chunk) {
  for (int i = 0; i < n; ++i) chunk.col(i) = rows.col(to[i]) - rows.col(from[i]);
}

}  // namespace dld
