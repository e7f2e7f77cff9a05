#include "geometry/pillar.hpp"

#include <array>
#include <stdexcept>

#include "geometry/circle.hpp"
#include "geometry/no_pillar.hpp"

namespace dld {
namespace {

using Maker = std::unique_ptr<PillarShape> (*)(const PillarSize&);

template <class Shape>
std::unique_ptr<PillarShape> make(const PillarSize& size) {
  return std::make_unique<Shape>(size);
}

struct Entry {
  const char* name;
  Maker maker;
};

constexpr std::array registry{
    Entry{"circle", make<Circle>},
    Entry{"none", make<NoPillar>},
};

}  // namespace

std::unique_ptr<PillarShape> make_pillar(const std::string& name, const PillarSize& size) {
  for (const Entry& entry : registry) {
    if (name == entry.name) return entry.maker(size);
  }
  throw std::invalid_argument("unknown pillar shape: " + name);
}

std::vector<std::string> pillar_shape_names() {
  std::vector<std::string> names;
  for (const Entry& entry : registry) names.emplace_back(entry.name);
  return names;
}

}  // namespace dld
