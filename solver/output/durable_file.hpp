#pragma once
/// Files that are there completely or not at all, whatever happens to the machine.
#include <cstdint>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <vector>

namespace dld {

/// A file could not be read or written (exit code 4).
struct IoError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Writes the bytes and waits until the disk has them. Throws IoError, and removes what there is, if it
/// cannot.
void write_durably(const std::filesystem::path& path, std::span<const char> bytes);

/// Where a file stands until it is complete.
std::filesystem::path part_of(const std::filesystem::path& path);

/// The same beside the place of the file, which it takes when the disk has it.
void write_whole(const std::filesystem::path& path, std::span<const char> bytes);

/// Writes them at the end of a file, whose other bytes the disk has then, too.
void append_durably(const std::filesystem::path& path, std::span<const char> bytes);

/// All bytes of a file. Throws IoError.
std::vector<char> read_bytes(const std::filesystem::path& path);

/// Checksum over every byte (CRC-32, as of gzip): tells a damaged file, not a forged one.
std::uint32_t checksum(std::span<const char> bytes);

/// Whether a file can take this place in the end: nothing is there, or a file. Throws IoError if a folder, a
/// device or a pipe is.
void require_writable(const std::filesystem::path& path);

/// Gives a file that the disk has the place of another, and waits until the disk knows. Throws IoError.
void rename_durably(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace dld
