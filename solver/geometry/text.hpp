#pragma once
/// Numbers in messages.
#include <cstdio>
#include <string>

namespace dld {

/// A number with as few digits as it needs, ten at most.
inline std::string number_text(double value) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.10g", value);
  return digits;
}

}  // namespace dld
