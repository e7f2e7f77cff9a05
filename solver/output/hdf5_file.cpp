#include "output/hdf5_file.hpp"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <numeric>
#include <string_view>

#include "output/hdf5_handle.hpp"

namespace dld {
namespace {

constexpr std::size_t compression_threshold = 64 * 1024;  // bytes
constexpr std::size_t chunk_bytes = 1024 * 1024;
constexpr unsigned gzip_level = 4;

// Chunks of whole rows (of the slowest index) of about one MiB.
std::vector<hsize_t> chunk_shape(const std::vector<hsize_t>& dims, std::size_t bytes_total) {
  std::vector<hsize_t> chunk = dims;
  const std::size_t row_bytes = std::max<std::size_t>(1, bytes_total / dims[0]);
  chunk[0] = std::clamp<hsize_t>(chunk_bytes / row_bytes, 1, dims[0]);
  return chunk;
}

/// Version, length and checksum of the data before it, always of one length.
constexpr std::size_t seal_length = 44;
constexpr std::string_view seal_begin = "\ndld seal ";
std::string seal_of(std::span<const char> data) {
  char text[seal_length + 1];
  std::snprintf(text, sizeof text, "\ndld seal %016zx %016zx\n", data.size(), std::size_t{checksum(data)});
  return text;
}

enum class SealState { none, holds, broken };
SealState state_of_seal(const std::filesystem::path& path) {
  const std::vector<char> bytes = read_bytes(path);
  if (bytes.size() < seal_length) return SealState::none;
  const std::span<const char> data(bytes.data(), bytes.size() - seal_length);
  const std::string_view found(bytes.data() + data.size(), seal_length);
  if (!found.starts_with(seal_begin)) return SealState::none;
  return found == seal_of(data) ? SealState::holds : SealState::broken;
}

void write_attribute(hid_t file, const std::string& object, const std::string& name, hid_t type,
                     const void* data) {
  const std::string what = "cannot write attribute '" + name + "' of " + object;
  const Handle target(H5Oopen(file, object.c_str(), H5P_DEFAULT), H5Oclose, what);
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, what);
  if (H5Aexists(target, name.c_str()) > 0) require(H5Adelete(target, name.c_str()), what);
  const Handle attribute(H5Acreate2(target, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                         what);
  require(H5Awrite(attribute, type, data), what);
}

// Makes the object a group unless something of that name is there, with its parents.
void ensure_object(hid_t file, const std::string& object) {
  for (std::size_t end = object.find('/', 1); !object.empty(); end = object.find('/', end + 1)) {
    const std::string part = object.substr(0, end);
    if (part != "/" && H5Lexists(file, part.c_str(), H5P_DEFAULT) <= 0) {
      const std::string what = "cannot make HDF5 group " + part;
      const Handle properties(H5Pcreate(H5P_GROUP_CREATE), H5Pclose, what);
      require(H5Pset_obj_track_times(properties, false), what);
      const Handle group(H5Gcreate2(file, part.c_str(), H5P_DEFAULT, properties, H5P_DEFAULT), H5Gclose,
                         what);
    }
    if (end == std::string::npos) break;
  }
}

}  // namespace

Hdf5File::Hdf5File(std::filesystem::path path) : path_(std::move(path)), part_(part_of(path_)) {
  silence_hdf5();
  const std::string what = "cannot create " + part_.string() + " (does the folder exist, is it writable?)";
  const Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose, what);
  require(H5Pset_obj_track_times(creation, false), what);
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, what);
  require(H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_LATEST), what);
  file_ = H5Fcreate(part_.c_str(), H5F_ACC_TRUNC, creation, access);
  if (file_ < 0) throw IoError(what);
}

Hdf5File::~Hdf5File() {
  if (file_ < 0) return;
  H5Fclose(file_);
  std::error_code ignored;
  std::filesystem::remove(part_, ignored);
}

bool Hdf5File::seal_holds(const std::filesystem::path& path) {
  return state_of_seal(path) == SealState::holds;
}

bool Hdf5File::seal_broken(const std::filesystem::path& path) {
  return state_of_seal(path) == SealState::broken;
}

void Hdf5File::close(Ending ending) {
  if (file_ < 0) return;
  const bool flushed = H5Fflush(file_, H5F_SCOPE_GLOBAL) >= 0;
  const bool closed = H5Fclose(file_) >= 0;
  file_ = -1;
  if (!flushed || !closed) {
    std::error_code ignored;
    std::filesystem::remove(part_, ignored);
    throw IoError("cannot complete " + part_.string() + " (is the disk full?)");
  }
  append_durably(part_, ending == Ending::sealed ? seal_of(read_bytes(part_)) : "");
  rename_durably(part_, path_);
}

void Hdf5File::write_raw(const std::string& name, const void* data, std::int64_t memory_type,
                         std::size_t bytes_per_value, std::size_t count, const Shape& shape) {
  const std::string what = "cannot write HDF5 dataset " + name + " of " + part_.string();
  if (name.size() < 2 || name[0] != '/') throw IoError(what + ": the name must begin with '/'");
  const std::vector<hsize_t> dims(shape.begin(), shape.end());
  if (std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>()) != count) {
    throw IoError(what + ": the shape does not fit the number of values");
  }
  ensure_object(file_, name.substr(0, std::max<std::size_t>(1, name.rfind('/'))));
  const Handle space(dims.empty() ? H5Screate(H5S_SCALAR)
                                  : H5Screate_simple(static_cast<int>(dims.size()), dims.data(), nullptr),
                     H5Sclose, what);
  const Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, what);
  require(H5Pset_obj_track_times(properties, false), what);
  if (compress_ && !dims.empty() && count * bytes_per_value > compression_threshold) {
    const auto chunk = chunk_shape(dims, count * bytes_per_value);
    require(H5Pset_chunk(properties, static_cast<int>(chunk.size()), chunk.data()), what);
    require(H5Pset_shuffle(properties), what);
    require(H5Pset_deflate(properties, gzip_level), what);
  }
  const Handle dataset(
      H5Dcreate2(file_, name.c_str(), memory_type, space, H5P_DEFAULT, properties, H5P_DEFAULT), H5Dclose,
      what);
  if (count > 0) require(H5Dwrite(dataset, memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data), what);
}

template <class T>
void Hdf5File::write(const std::string& name, std::span<const T> values, const Shape& shape,
                     const std::string& unit, const std::string& description) {
  write_raw(name, values.data(), native_type<T>(), sizeof(T), values.size(), shape);
  attribute(name, "unit", unit);
  attribute(name, "description", description);
}

template void Hdf5File::write(const std::string&, std::span<const double>, const Shape&, const std::string&,
                              const std::string&);
template void Hdf5File::write(const std::string&, std::span<const float>, const Shape&, const std::string&,
                              const std::string&);
template void Hdf5File::write(const std::string&, std::span<const std::int32_t>, const Shape&,
                              const std::string&, const std::string&);
template void Hdf5File::write(const std::string&, std::span<const std::int64_t>, const Shape&,
                              const std::string&, const std::string&);
template void Hdf5File::write(const std::string&, std::span<const std::uint8_t>, const Shape&,
                              const std::string&, const std::string&);

void Hdf5File::attribute(const std::string& object, const std::string& name, const std::string& value) {
  ensure_object(file_, object);
  // Variable-length UTF-8, which h5py reads as str.
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "HDF5 has no text type");
  require(H5Tset_size(type, H5T_VARIABLE), "HDF5 has no text type");
  require(H5Tset_cset(type, H5T_CSET_UTF8), "HDF5 has no text type");
  const char* text = value.c_str();
  write_attribute(file_, object, name, type, &text);
}

void Hdf5File::physical(const std::string& dataset, const std::string& unit, double factor) {
  if (!(factor > 0)) return;
  attribute(dataset, "physical_unit", unit);
  attribute(dataset, "physical_per_unit", factor);
}

void Hdf5File::attribute(const std::string& object, const std::string& name, double value) {
  ensure_object(file_, object);
  write_attribute(file_, object, name, H5T_NATIVE_DOUBLE, &value);
}

void Hdf5File::attribute(const std::string& object, const std::string& name, std::int64_t value) {
  ensure_object(file_, object);
  write_attribute(file_, object, name, H5T_NATIVE_INT64, &value);
}

}  // namespace dld
