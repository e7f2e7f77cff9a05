#pragma once
/// Numbers and names in messages.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/text.hpp"

namespace dld {

/// Three significant digits, for people: 0.0123, 45.7, 12300, 1.23e-06.
inline std::string short_number(double value) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.3g", value);
  if (const double size = std::abs(value); size >= 999.5 && size < 1e7) {
    const double unit = std::pow(10.0, std::floor(std::log10(size)) - 2);
    std::snprintf(digits, sizeof digits, "%.0f", std::round(value / unit) * unit);
  }
  return digits;
}

/// "pitch along x [um]"; a number without a unit, "1", has none that people need to read.
inline std::string with_unit(std::string_view text, std::string_view unit) {
  return std::string(text) + (unit.empty() || unit == "1" ? "" : " [" + std::string(unit) + "]");
}

/// "a, b, c"
inline std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// Number of insertions, deletions and replacements that turn `a` into `b` (Levenshtein distance). Of texts
/// that are no misspelling of one another, the longer one's length: a name of megabytes costs no time.
inline std::size_t edit_distance(const std::string& a, const std::string& b) {
  constexpr std::size_t longest = 1000;
  if (const std::size_t length = std::max(a.size(), b.size()); length > longest) return length;
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, diagonal + 1, row[j] + 1});
    }
  }
  return row.back();
}

/// The known name that looks most like a misspelt one: the first of the nearest `names`, which must not be
/// empty.
inline std::string nearest_name(const std::string& name, const std::vector<std::string>& names) {
  return *std::ranges::min_element(names, {}, [&](const std::string& n) { return edit_distance(name, n); });
}

/// The same, if it looks alike: the given one and a unit ("depth", "depth_um"), or one in which no more than
/// a third of the letters differ, or two of a short name.
inline std::optional<std::string> similar_name(const std::string& name,
                                               const std::vector<std::string>& names) {
  if (names.empty()) return std::nullopt;
  const auto with_unit =
      std::ranges::find_if(names, [&](const auto& n) { return n.starts_with(name + "_"); });
  if (with_unit != names.end()) return *with_unit;
  const std::string near = nearest_name(name, names);
  const std::size_t most = std::max<std::size_t>(std::min<std::size_t>(2, near.size() / 2), near.size() / 3);
  return edit_distance(name, near) <= most ? std::optional(near) : std::nullopt;
}

}  // namespace dld
