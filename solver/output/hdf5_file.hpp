#pragma once
/// One HDF5 file: a thin owner of the C library's handles. Identical calls make identical bytes: object
/// times are switched off and nothing about host, user or path is stored.
#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "output/durable_file.hpp"

namespace dld {

using Shape = std::vector<std::size_t>;

/// Attribute of the root of a file that is closed with a seal: without one it has been cut off.
inline const std::string seal_attribute = "sealed";

/// Writer. Everything goes to "<path>.part"; close() renames it, so that a file with the final name is
/// always complete. A file that is destroyed before close() leaves nothing behind.
class Hdf5File {
 public:
  explicit Hdf5File(std::filesystem::path path);
  ~Hdf5File();
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;

  /// Writes a row-major array of double, float, int32_t, int64_t or uint8_t. Groups on the way to `name`
  /// ("/flow/velocity") are made on demand. `unit` is "none" for numbers without one, "lu" for
  /// lattice units. Arrays above 64 KiB are compressed.
  template <class T>
  void write(const std::string& name, std::span<const T> values, const Shape& shape, const std::string& unit,
             const std::string& description);

  /// A one-dimensional array.
  template <class T>
  void write(const std::string& name, const std::vector<T>& values, const std::string& unit,
             const std::string& description) {
    write(name, std::span<const T>(values), {values.size()}, unit, description);
  }

  /// A matrix (rows, columns), whatever its storage order: vertices (nv, 3), faces (nf, 3).
  template <class Derived>
  void write_matrix(const std::string& name, const Eigen::MatrixBase<Derived>& matrix,
                    const std::string& unit, const std::string& description) {
    using T = typename Derived::Scalar;
    const Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows = matrix;
    write(name, std::span<const T>(rows.data(), static_cast<std::size_t>(rows.size())),
          {static_cast<std::size_t>(rows.rows()), static_cast<std::size_t>(rows.cols())}, unit, description);
  }

  /// A single number.
  template <class T>
  void write_scalar(const std::string& name, T value, const std::string& unit,
                    const std::string& description) {
    write(name, std::span<const T>(&value, 1), {}, unit, description);
  }

  /// Attributes of a dataset or group ("/" is the root); a group that does not exist is made.
  void attribute(const std::string& object, const std::string& name, const std::string& value);
  void attribute(const std::string& object, const std::string& name, const char* value) {
    attribute(object, name, std::string(value));
  }
  void attribute(const std::string& object, const std::string& name, double value);
  void attribute(const std::string& object, const std::string& name, std::int64_t value);
  void attribute(const std::string& object, const std::string& name, int value) {
    attribute(object, name, static_cast<std::int64_t>(value));
  }

  /// Says what values in lattice units are in others: value * factor is in `unit`, kept as the attributes
  /// physical_unit and physical_per_unit. Without a scale (factor 0) there is nothing to say.
  void physical(const std::string& dataset, const std::string& unit, double factor);

  /// Compression costs more than it saves for files that live for minutes (checkpoints).
  void set_compression(bool on) { compress_ = on; }

  /// Completes the file and gives it its final name.
  void close() { close(Ending::plain); }
  /// The same with a seal behind the HDF5 data, which readers of HDF5 pass over: see seal_holds.
  void close_sealed() { close(Ending::sealed); }
  /// Whether a file was closed with a seal and has every byte that it had then.
  static bool seal_holds(const std::filesystem::path& path);
  /// Whether a file ends with a seal that says otherwise than its bytes: it should not even be opened.
  static bool seal_broken(const std::filesystem::path& path);

  const std::filesystem::path& path() const { return path_; }

 private:
  enum class Ending { plain, sealed };
  void close(Ending ending);
  void write_raw(const std::string& name, const void* data, std::int64_t memory_type,
                 std::size_t bytes_per_value, std::size_t count, const Shape& shape);

  std::filesystem::path path_, part_;
  std::int64_t file_ = -1;  ///< hid_t, kept out of the header with the library's macros
  bool compress_ = true;
};

/// Reader of what the writer above wrote, as far as the checkpoint and the tests need it.
class Hdf5Reader {
 public:
  explicit Hdf5Reader(const std::filesystem::path& path);
  ~Hdf5Reader();
  Hdf5Reader(const Hdf5Reader&) = delete;
  Hdf5Reader& operator=(const Hdf5Reader&) = delete;

  enum class Type { float64, float32, int64, int32, uint8 };

  bool exists(const std::string& name) const;
  /// Names of the members of a group, sorted.
  std::vector<std::string> members(const std::string& group) const;
  Shape shape(const std::string& dataset) const;
  Type type(const std::string& dataset) const;
  /// All values in row-major order, converted to T.
  template <class T>
  std::vector<T> read(const std::string& dataset) const;
  std::string text_attribute(const std::string& object, const std::string& name) const;
  /// Names of all attributes of an object, sorted.
  std::vector<std::string> text_attributes(const std::string& object) const;

 private:
  std::int64_t file_ = -1;
  std::filesystem::path path_;
};

}  // namespace dld
