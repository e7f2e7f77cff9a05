#pragma once
/// What the program prints. Names of files, cases and arguments come from outside, and end in messages of
/// every kind: so control characters are escaped in the stream and not at each message.
#include <iostream>
#include <streambuf>

namespace dld {

/// Passes a stream's text on with its control characters escaped, while it lives. A text of more than a byte
/// must come in one piece.
class PrintableStream : public std::streambuf {
 public:
  explicit PrintableStream(std::ostream& stream);
  ~PrintableStream() override;
  PrintableStream(const PrintableStream&) = delete;
  PrintableStream& operator=(const PrintableStream&) = delete;

 protected:
  int_type overflow(int_type character) override;
  std::streamsize xsputn(const char* text, std::streamsize size) override;
  int sync() override;

 private:
  std::ostream& stream_;
  std::streambuf* target_;
};

/// Hands all to the system that was printed to the standard output. Throws IoError if it cannot be written.
void flush_output();

}  // namespace dld
