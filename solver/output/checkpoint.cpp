#include "output/checkpoint.hpp"

#include <ostream>
#include <span>

#include "output/hdf5_file.hpp"

namespace dld {
namespace {

const std::string arrays = "/arrays", texts = "/texts";

void save_value(Hdf5File& file, const std::string& name, const Checkpoint::Value& value) {
  std::visit(
      [&](const auto& data) {
        if constexpr (std::is_same_v<std::decay_t<decltype(data)>, std::string>) {
          file.attribute(texts, name, data);
        } else {
          file.write(arrays + "/" + name, data, "lu", "state of the run");
        }
      },
      value);
}

Checkpoint::Value load_value(const Hdf5Reader& file, const std::string& dataset) {
  switch (file.type(dataset)) {
    case Hdf5Reader::Type::float64:
      return file.read<double>(dataset);
    case Hdf5Reader::Type::float32:
      return file.read<float>(dataset);
    default:
      return file.read<std::int64_t>(dataset);
  }
}

}  // namespace

CheckpointMismatch::CheckpointMismatch(const std::filesystem::path& path)
    : IoError(path.string() +
              " is the checkpoint of another case or another build of the solver; remove it or start with "
              "--no-resume") {}

template <class T>
const T& Checkpoint::get(const std::string& name) const {
  const auto entry = values_.find(name);
  const T* value = entry == values_.end() ? nullptr : std::get_if<T>(&entry->second);
  if (!value)
    throw IoError("the checkpoint holds no '" + name + "' of the expected type; start with --no-resume");
  return *value;
}

template const std::vector<double>& Checkpoint::get(const std::string&) const;
template const std::vector<float>& Checkpoint::get(const std::string&) const;
template const std::vector<std::int64_t>& Checkpoint::get(const std::string&) const;
template const std::string& Checkpoint::get(const std::string&) const;

std::int64_t Checkpoint::integer(const std::string& name) const {
  return get<std::vector<std::int64_t>>(name).at(0);
}

void Checkpoint::save(const std::filesystem::path& path) const {
  Hdf5File file(path);
  file.set_compression(false);
  file.attribute("/", "case", case_text_);
  for (const auto& [name, value] : values_) save_value(file, name, value);
  // A second name for the last one, so that there is one at every moment.
  std::filesystem::remove(previous(path));
  std::error_code no_links;
  if (std::filesystem::exists(path)) std::filesystem::create_hard_link(path, previous(path), no_links);
  if (no_links) std::filesystem::copy_file(path, previous(path));
  file.close_sealed();
}

std::filesystem::path Checkpoint::previous(const std::filesystem::path& path) {
  return path.string() + ".previous";
}

void Checkpoint::remove(const std::filesystem::path& path) {
  for (const auto& file : {path, previous(path)}) std::filesystem::remove(file);
}

std::optional<Checkpoint> Checkpoint::load(const std::filesystem::path& path, const std::string& case_text,
                                           std::ostream& log) {
  for (const auto& file : {path, previous(path)}) {
    if (!std::filesystem::exists(file)) continue;
    if (Hdf5File::seal_holds(file)) return read(file, case_text);
    const std::filesystem::path aside = file.string() + ".damaged";
    std::filesystem::rename(file, aside);
    log << file.string() << " is damaged: put aside as " << aside.string()
        << ", the run goes on from the state before it or from the start\n";
  }
  return std::nullopt;
}

Checkpoint Checkpoint::read(const std::filesystem::path& path, const std::string& case_text) {
  const Hdf5Reader file(path);
  if (file.text_attribute("/", "case") != case_text) throw CheckpointMismatch(path);
  Checkpoint checkpoint(case_text);
  if (file.exists(arrays)) {
    for (const auto& name : file.members(arrays)) {
      checkpoint.values_[name] = load_value(file, arrays + "/" + name);
    }
  }
  if (file.exists(texts)) {
    for (const auto& name : file.text_attributes(texts)) {
      checkpoint.values_[name] = file.text_attribute(texts, name);
    }
  }
  return checkpoint;
}

}  // namespace dld
