#pragma once
/// State of an unfinished run: named arrays and texts in one HDF5 file.
#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "output/hdf5_file.hpp"

namespace dld {

/// The checkpoint belongs to another case or another build; nothing was read from it, and it is left alone.
struct CheckpointMismatch : IoError {
  explicit CheckpointMismatch(const std::filesystem::path& path);
};

/// A scene fills it with set(), saves it, and on resuming reads it with get(). The resolved case goes
/// with it, so that the state of one case never continues another.
class Checkpoint {
 public:
  using Value = std::variant<std::vector<double>, std::vector<float>, std::vector<std::int64_t>, std::string>;

  /// `case_text` is the resolved case, echo(c).dump().
  explicit Checkpoint(std::string case_text) : case_text_(std::move(case_text)) {}

  void set(const std::string& name, Value value) { values_[name] = std::move(value); }
  void set(const std::string& name, double value) { values_[name] = std::vector<double>{value}; }
  void set(const std::string& name, std::int64_t value) { values_[name] = std::vector<std::int64_t>{value}; }

  /// The array or text stored under `name`, T being one of the four types of Value; IoError if absent.
  template <class T>
  const T& get(const std::string& name) const;
  std::int64_t integer(const std::string& name) const;  ///< a single integer

  /// Written aside, sealed and renamed; the checkpoint before it is kept as "<path>.previous".
  void save(const std::filesystem::path& path) const;
  /// The last checkpoint whose seal holds, nothing without one. A damaged one is put aside as
  /// "<path>.damaged" and said so in the log. CheckpointMismatch if it belongs to another case or build.
  static std::optional<Checkpoint> load(const std::filesystem::path& path, const std::string& case_text,
                                        std::ostream& log);
  /// Removes a checkpoint and the one before it.
  static void remove(const std::filesystem::path& path);
  /// Where the checkpoint before it stands.
  static std::filesystem::path previous(const std::filesystem::path& path);

 private:
  static Checkpoint read(const std::filesystem::path& path, const std::string& case_text);

  std::string case_text_;
  std::map<std::string, Value> values_;
};

}  // namespace dld
