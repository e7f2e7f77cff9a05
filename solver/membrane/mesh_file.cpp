#include "membrane/mesh_file.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>
#include <vector>

namespace dld {
namespace {

constexpr std::size_t most_faces = 1000000;

using Point = std::array<double, 3>;
using Corners = std::array<int, 3>;

[[noreturn]] void fail(std::size_t line, const std::string& why) {
  throw MeshFileError("line " + std::to_string(line) + ": " + why);
}

/// The lines of a text that hold something, split at white space; what follows a # is a comment.
class Lines {
 public:
  explicit Lines(const std::string& text) : in_(text) {}

  /// The words of the next line that has some; false at the end of the text.
  bool next() {
    std::string line;
    while (std::getline(in_, line)) {
      ++number_;
      std::istringstream rest(line.substr(0, line.find('#')));
      words_.clear();
      for (std::string word; rest >> word;) words_.push_back(word);
      if (!words_.empty()) return true;
    }
    return false;
  }
  void require(const std::string& what) {
    if (!next()) fail(number_, "the file ends where " + what + " should stand");
  }
  std::vector<std::string>& words() { return words_; }
  std::size_t number() const { return number_; }

  template <class Number>
  Number value(std::size_t word) const {
    Number value{};
    const std::string& text = words_.at(word);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) fail(number_, "no number: " + text);
    return value;
  }
  Point point(std::size_t first) const {
    return {value<double>(first), value<double>(first + 1), value<double>(first + 2)};
  }

 private:
  std::istringstream in_;
  std::vector<std::string> words_;
  std::size_t number_ = 0;
};

TriangleMesh mesh_of(const std::vector<Point>& points, const std::vector<Corners>& corners) {
  TriangleMesh mesh;
  mesh.vertices.resize(static_cast<Eigen::Index>(points.size()), 3);
  mesh.faces.resize(static_cast<Eigen::Index>(corners.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i)
    mesh.vertices.row(static_cast<Eigen::Index>(i)) << points[i][0], points[i][1], points[i][2];
  for (std::size_t i = 0; i < corners.size(); ++i)
    mesh.faces.row(static_cast<Eigen::Index>(i)) << corners[i][0], corners[i][1], corners[i][2];
  return mesh;
}

TriangleMesh read_off(const std::string& text) {
  Lines lines(text);
  lines.require("OFF");
  if (lines.words().front() != "OFF") fail(lines.number(), "an OFF file begins with the word OFF");
  lines.words().erase(lines.words().begin());
  if (lines.words().empty()) lines.require("the numbers of vertices and faces");
  if (lines.words().size() < 2) fail(lines.number(), "the numbers of vertices and faces should stand here");
  const auto vertices = lines.value<std::size_t>(0), faces = lines.value<std::size_t>(1);
  if (faces > most_faces || vertices > most_faces) fail(lines.number(), "more than a million faces");
  std::vector<Point> points;
  std::vector<Corners> corners;
  for (std::size_t i = 0; i < vertices; ++i) {
    lines.require("vertex " + std::to_string(i));
    if (lines.words().size() != 3) fail(lines.number(), "a vertex has three coordinates");
    points.push_back(lines.point(0));
  }
  for (std::size_t i = 0; i < faces; ++i) {
    lines.require("face " + std::to_string(i));
    const auto count = lines.value<std::size_t>(0);
    if (count != 3 || lines.words().size() < 4)  // colours may follow the three numbers
      fail(lines.number(), "a face has three corners: split polygons into triangles");
    for (std::size_t k = 1; k <= 3; ++k) {
      if (lines.value<std::size_t>(k) >= vertices) fail(lines.number(), "no vertex " + lines.words()[k]);
    }
    corners.push_back({lines.value<int>(1), lines.value<int>(2), lines.value<int>(3)});
  }
  if (lines.next()) fail(lines.number(), "more lines than vertices and faces");
  return mesh_of(points, corners);
}

/// Makes vertices of corners: equal coordinates are the same vertex.
TriangleMesh merged(const std::vector<Point>& corners) {
  std::map<Point, int> number_of;
  std::vector<Point> points;
  std::vector<Corners> faces;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    Corners face{};
    for (std::size_t k = 0; k < 3; ++k) {
      Point p = corners[i + k];
      for (double& x : p) x += 0.0;  // -0 and 0 are equal and one key
      const auto [entry, added] = number_of.try_emplace(p, static_cast<int>(points.size()));
      if (added) points.push_back(p);
      face[k] = entry->second;
    }
    faces.push_back(face);
  }
  return mesh_of(points, faces);
}

TriangleMesh read_stl_text(const std::string& text) {
  Lines lines(text);
  std::vector<Point> corners;
  std::size_t of_facet = 0;
  bool in_facet = false;
  lines.require("solid");
  while (lines.next()) {
    const std::string word = lines.words().front();
    if (word == "vertex") {
      if (lines.words().size() != 4) fail(lines.number(), "a vertex has three coordinates");
      corners.push_back(lines.point(1));
      ++of_facet;
    } else if (word == "facet") {
      if (in_facet) fail(lines.number(), "a facet within a facet");
      in_facet = true;
      of_facet = 0;
    } else if (word == "endfacet") {
      if (!in_facet || of_facet != 3) fail(lines.number(), "a facet has three vertices");
      in_facet = false;
    } else if (word != "outer" && word != "endloop" && word != "endsolid" && word != "solid") {
      fail(lines.number(), "unknown word " + word);
    }
    if (corners.size() > 3 * most_faces) fail(lines.number(), "more than a million faces");
  }
  if (in_facet) fail(lines.number(), "the file ends within a facet");
  return merged(corners);
}

/// 80 bytes of header, the number of facets, and for each: normal, three vertices (floats), two bytes.
constexpr std::size_t stl_header = 84, stl_facet = 50;

std::uint32_t stl_count(const std::string& bytes) {
  static_assert(std::endian::native == std::endian::little);
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + stl_header - sizeof count, sizeof count);
  return count;
}

TriangleMesh read_stl_binary(const std::string& bytes) {
  std::vector<Point> corners;
  for (std::size_t facet = stl_header; facet < bytes.size(); facet += stl_facet) {
    std::array<float, 12> numbers;
    std::memcpy(numbers.data(), bytes.data() + facet, sizeof numbers);
    for (std::size_t k = 3; k < 12; k += 3) corners.push_back({numbers[k], numbers[k + 1], numbers[k + 2]});
  }
  return merged(corners);
}

TriangleMesh read_stl(const std::string& bytes) {
  if (bytes.size() >= stl_header && bytes.size() == stl_header + stl_facet * stl_count(bytes)) {
    if (stl_count(bytes) > most_faces) throw MeshFileError("more than a million faces");
    return read_stl_binary(bytes);
  }
  if (bytes.starts_with("solid")) return read_stl_text(bytes);
  throw MeshFileError(
      "neither a text that begins with solid nor as many bytes as its number of facets needs");
}

}  // namespace

TriangleMesh read_mesh(const std::filesystem::path& path) {
  std::string kind = path.extension().string();
  std::ranges::transform(kind, kind.begin(), [](unsigned char c) { return std::tolower(c); });
  if (kind != ".off" && kind != ".stl") throw MeshFileError("its name ends neither in .off nor in .stl");
  std::error_code none;  // a folder and a device without end can be opened, too
  if (!std::filesystem::is_regular_file(path, none)) throw MeshFileError("the file cannot be read");
  std::ifstream in(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << in.rdbuf();
  if (!in) throw MeshFileError("the file cannot be read");
  return kind == ".off" ? read_off(bytes.str()) : read_stl(bytes.str());
}

}  // namespace dld
