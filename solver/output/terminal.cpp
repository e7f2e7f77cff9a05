#include "output/terminal.hpp"

#include <cerrno>
#include <cstring>
#include <string>

#include "geometry/text.hpp"
#include "output/durable_file.hpp"

namespace dld {

PrintableStream::PrintableStream(std::ostream& stream) : stream_(stream), target_(stream.rdbuf(this)) {}

PrintableStream::~PrintableStream() {
  stream_.rdbuf(target_);
}

PrintableStream::int_type PrintableStream::overflow(int_type character) {
  if (traits_type::eq_int_type(character, traits_type::eof())) return traits_type::not_eof(character);
  const char byte = traits_type::to_char_type(character);
  return xsputn(&byte, 1) == 1 ? character : traits_type::eof();
}

std::streamsize PrintableStream::xsputn(const char* text, std::streamsize size) {
  const std::string safe = printable({text, static_cast<std::size_t>(size)}, true);
  const auto length = static_cast<std::streamsize>(safe.size());
  return target_->sputn(safe.data(), length) == length ? size : 0;
}

int PrintableStream::sync() {
  return target_->pubsync();
}

void flush_output() {
  errno = 0;
  if (!std::cout.flush())
    throw IoError(std::string("cannot write to the standard output") +
                  (errno != 0 ? std::string(": ") + std::strerror(errno) : ""));
}

}  // namespace dld
