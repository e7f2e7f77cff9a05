#include "output/durable_file.hpp"

#include <fcntl.h>
#include <unistd.h>
#include <zlib.h>

#include <cerrno>
#include <cstring>
#include <fstream>

namespace dld {
namespace {

/// All bytes, also after a signal; false with errno set if the disk takes no more.
bool write_all(int file, std::span<const char> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) return false;
    if (written > 0) bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return ::fsync(file) == 0;
}

void write_durably(const std::filesystem::path& path, std::span<const char> bytes, int mode) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | mode, 0666);
  if (file < 0)
    throw IoError("cannot create " + path.string() + ": " + std::strerror(errno) +
                  " (does the folder exist, is it writable?)");
  const bool good = write_all(file, bytes);
  const int reason = errno;
  const bool closed = ::close(file) == 0;
  if (good && closed) return;
  std::error_code ignored;
  std::filesystem::remove(path, ignored);
  throw IoError("cannot write " + path.string() + ": " + std::strerror(good ? errno : reason));
}

}  // namespace

void write_durably(const std::filesystem::path& path, std::span<const char> bytes) {
  write_durably(path, bytes, O_TRUNC);
}

std::filesystem::path part_of(const std::filesystem::path& path) {
  return path.string() + ".part";
}

void write_whole(const std::filesystem::path& path, std::span<const char> bytes) {
  const std::filesystem::path part = part_of(path);
  write_durably(part, bytes);
  rename_durably(part, path);
}

void append_durably(const std::filesystem::path& path, std::span<const char> bytes) {
  write_durably(path, bytes, O_APPEND);
}

std::vector<char> read_bytes(const std::filesystem::path& path) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(path, none))  // a folder can be opened, too
    throw IoError("cannot read " + path.string() + ": no such file");
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  std::vector<char> bytes(file ? static_cast<std::size_t>(file.tellg()) : 0);
  file.seekg(0);
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!file) throw IoError("cannot read " + path.string());
  return bytes;
}

std::uint32_t checksum(std::span<const char> bytes) {
  return static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

void require_writable(const std::filesystem::path& path) {
  std::error_code none;
  const auto kind = std::filesystem::status(path, none).type();
  if (kind == std::filesystem::file_type::directory)
    throw IoError(path.string() + " is a folder; move it away or name another file");
  if (kind != std::filesystem::file_type::regular && kind != std::filesystem::file_type::not_found)
    throw IoError(path.string() +
                  " is no file whose place another can take (or cannot be reached); name another");
}

void rename_durably(const std::filesystem::path& from, const std::filesystem::path& to) {
  std::error_code error;
  std::filesystem::rename(from, to, error);
  if (error) throw IoError("cannot rename " + from.string() + " to " + to.string() + ": " + error.message());
  const std::filesystem::path folder = to.has_parent_path() ? to.parent_path() : ".";
  const int directory = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (directory < 0) return;  // some file systems have no folders to open: the name is as good as it gets
  ::fsync(directory);
  ::close(directory);
}

}  // namespace dld
