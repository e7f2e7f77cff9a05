#pragma once
/// Owner of one handle of the HDF5 C library, and the names of its types. Used inside output/ alone.
#include <hdf5.h>

#include <cstdint>
#include <string>
#include <utility>

#include "output/hdf5_file.hpp"

namespace dld {

/// Closes the handle at the end of its life; a handle that the library refused becomes an IoError.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle(hid_t id, Close close, const std::string& what) : id_(id), close_(close) {
    if (id < 0) throw IoError(what);
  }
  ~Handle() { close_(id_); }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  Close close_;
};

/// The library reports failures by negative numbers.
inline void require(herr_t result, const std::string& what) {
  if (result < 0) throw IoError(what);
}

/// The type of T in memory.
template <class T>
hid_t native_type();
template <>
inline hid_t native_type<double>() {
  return H5T_NATIVE_DOUBLE;
}
template <>
inline hid_t native_type<float>() {
  return H5T_NATIVE_FLOAT;
}
template <>
inline hid_t native_type<std::int32_t>() {
  return H5T_NATIVE_INT32;
}
template <>
inline hid_t native_type<std::int64_t>() {
  return H5T_NATIVE_INT64;
}
template <>
inline hid_t native_type<std::uint8_t>() {
  return H5T_NATIVE_UINT8;
}

/// The library prints its own error stack by default; our exceptions say what failed.
inline void silence_hdf5() {
  H5dont_atexit();  // HDF5 (1.10) crashes at exit after a write that failed; every file is closed before
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

}  // namespace dld
