#include <algorithm>
#include <numeric>

#include "output/hdf5_file.hpp"
#include "output/hdf5_handle.hpp"

namespace dld {
namespace {

Handle open_dataset(std::int64_t file, const std::string& name, const std::filesystem::path& path) {
  return Handle(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose,
                path.string() + " has no dataset " + name);
}

}  // namespace

Hdf5Reader::Hdf5Reader(const std::filesystem::path& path) : path_(path) {
  silence_hdf5();
  file_ = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  if (file_ < 0) throw IoError("cannot read " + path.string() + ": not there or not a complete HDF5 file");
}

Hdf5Reader::~Hdf5Reader() {
  H5Fclose(file_);
}

bool Hdf5Reader::exists(const std::string& name) const {
  for (std::size_t end = name.find('/', 1);; end = name.find('/', end + 1)) {
    if (H5Lexists(file_, name.substr(0, end).c_str(), H5P_DEFAULT) <= 0) return false;
    if (end == std::string::npos) return true;
  }
}

std::vector<std::string> Hdf5Reader::members(const std::string& group) const {
  const std::string what = path_.string() + " has no group " + group;
  const Handle handle(H5Gopen2(file_, group.c_str(), H5P_DEFAULT), H5Gclose, what);
  std::vector<std::string> names;
  const auto collect = [](hid_t, const char* name, const H5L_info_t*, void* list) -> herr_t {
    static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return 0;
  };
  require(H5Literate(handle, H5_INDEX_NAME, H5_ITER_INC, nullptr, collect, &names), what);
  return names;
}

Shape Hdf5Reader::shape(const std::string& dataset) const {
  const Handle handle = open_dataset(file_, dataset, path_);
  const Handle space(H5Dget_space(handle), H5Sclose, "cannot read the shape of " + dataset);
  std::vector<hsize_t> dims(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
  H5Sget_simple_extent_dims(space, dims.data(), nullptr);
  return {dims.begin(), dims.end()};
}

Hdf5Reader::Type Hdf5Reader::type(const std::string& dataset) const {
  const Handle handle = open_dataset(file_, dataset, path_);
  const Handle type(H5Dget_type(handle), H5Tclose, "cannot read the type of " + dataset);
  const std::size_t bytes = H5Tget_size(type);
  if (H5Tget_class(type) == H5T_FLOAT) return bytes == 8 ? Type::float64 : Type::float32;
  if (bytes == 1) return Type::uint8;
  return bytes == 8 ? Type::int64 : Type::int32;
}

template <class T>
std::vector<T> Hdf5Reader::read(const std::string& dataset) const {
  const Shape dims = shape(dataset);
  std::vector<T> values(std::accumulate(dims.begin(), dims.end(), std::size_t{1}, std::multiplies<>()));
  const Handle handle = open_dataset(file_, dataset, path_);
  if (!values.empty()) {
    require(H5Dread(handle, native_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
            "cannot read " + dataset + " of " + path_.string());
  }
  return values;
}

template std::vector<double> Hdf5Reader::read(const std::string&) const;
template std::vector<float> Hdf5Reader::read(const std::string&) const;
template std::vector<std::int32_t> Hdf5Reader::read(const std::string&) const;
template std::vector<std::int64_t> Hdf5Reader::read(const std::string&) const;
template std::vector<std::uint8_t> Hdf5Reader::read(const std::string&) const;

std::string Hdf5Reader::text_attribute(const std::string& object, const std::string& name) const {
  const std::string what = path_.string() + " has no text attribute '" + name + "' at " + object;
  const Handle attribute(H5Aopen_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose, what);
  const Handle type(H5Aget_type(attribute), H5Tclose, what);
  if (H5Tis_variable_str(type) <= 0) throw IoError(what);
  char* text = nullptr;
  require(H5Aread(attribute, type, &text), what);
  std::string value = text ? text : "";
  H5free_memory(text);
  return value;
}

std::vector<std::string> Hdf5Reader::text_attributes(const std::string& object) const {
  const std::string what = path_.string() + " has no object " + object;
  const Handle handle(H5Oopen(file_, object.c_str(), H5P_DEFAULT), H5Oclose, what);
  std::vector<std::string> names;
  const auto collect = [](hid_t, const char* name, const H5A_info_t*, void* list) -> herr_t {
    static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return 0;
  };
  require(H5Aiterate2(handle, H5_INDEX_NAME, H5_ITER_INC, nullptr, collect, &names), what);
  return names;
}

}  // namespace dld
