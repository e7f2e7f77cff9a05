#pragma once
/// Numbers and texts from outside in messages.
#include <cstdio>
#include <string>
#include <string_view>

namespace dld {

/// A number with as few digits as it needs, ten at most.
inline std::string number_text(double value) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.10g", value);
  return digits;
}

/// A text from outside as a terminal may show it: control characters, C1 (U+0080 to U+009F) among them, as
/// \u001b; with `lines`, line ends and tabulators stay.
inline std::string printable(std::string_view text, bool lines = false) {
  std::string out;
  const auto escape = [&](unsigned code) {
    char digits[8];
    std::snprintf(digits, sizeof digits, "\\u%04x", code);
    out += digits;
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const auto next = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : 0);
    if (lines && (byte == '\n' || byte == '\t')) {
      out += text[i];
    } else if (byte < 0x20 || byte == 0x7f) {
      escape(byte);
    } else if (byte == 0xc2 && next >= 0x80 && next < 0xa0) {
      escape(next);
      ++i;
    } else {
      out += text[i];
    }
  }
  return out;
}

}  // namespace dld
