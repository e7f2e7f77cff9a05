#pragma once
/// Files that are there completely or not at all, whatever happens to the machine.
#include <filesystem>
#include <span>
#include <stdexcept>

namespace dld {

/// A file could not be read or written (exit code 4).
struct IoError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Writes the bytes and waits until the disk has them. Throws IoError, and removes what there is, if it
/// cannot.
void write_durably(const std::filesystem::path& path, std::span<const char> bytes);

/// Gives a file that the disk has the place of another, and waits until the disk knows. Throws IoError.
void rename_durably(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace dld
