#include "scene/separations.hpp"

#include <string>
#include <vector>

namespace dld {
namespace {

void write_line(RunContext& context, const char* name, const Separation& line, double um_per_lu,
                const char* description) {
  if (!line.found) return;
  const Eigen::MatrixX2d points = line.streamline * um_per_lu;
  const std::string dataset = std::string("/separatrix/") + name;
  context.out.write_matrix(dataset, points, "um", description);
  context.out.attribute(dataset, "separation_um", line.seed_distance * um_per_lu);
}

void save(Checkpoint& checkpoint, const std::string& name, const Separation& line) {
  checkpoint.set(name, std::vector<double>{line.found ? 1.0 : 0.0, line.seed_distance, line.minimum_distance,
                                           line.seed.x(), line.seed.y()});
  checkpoint.set(name + "_streamline", std::vector<double>(line.streamline.data(),
                                                           line.streamline.data() + line.streamline.size()));
}

Separation load(const Checkpoint& checkpoint, const std::string& name) {
  const auto& n = checkpoint.get<std::vector<double>>(name);
  const auto& points = checkpoint.get<std::vector<double>>(name + "_streamline");
  Separation line{.found = n.at(0) != 0,
                  .seed_distance = n.at(1),
                  .minimum_distance = n.at(2),
                  .seed = {n.at(3), n.at(4)},
                  .streamline = {}};
  line.streamline =
      Eigen::Map<const Eigen::MatrixX2d>(points.data(), static_cast<Eigen::Index>(points.size() / 2), 2);
  return line;
}

}  // namespace

Separations separations(const PlaneFlow& flow) {
  return {separation_downstream(flow), separation_upstream(flow)};
}

void write_separations(RunContext& context, const Separations& lines, double um_per_lu) {
  const auto& [downstream, upstream] = lines;
  write_line(context, "downstream", downstream, um_per_lu,
             "streamline that ends in the front stagnation point of the next pillar downstream");
  write_line(context, "upstream", upstream, um_per_lu,
             "streamline that leaves the rear stagnation point of the pillar upstream");
  context.summary["separation_um"] = downstream.seed_distance * um_per_lu;
  context.summary["separation_upper_um"] = upstream.seed_distance * um_per_lu;
  context.summary["separation_shortest_um"] = downstream.minimum_distance * um_per_lu;
}

void save_separations(Checkpoint& checkpoint, const Separations& lines) {
  save(checkpoint, "separation_downstream", lines.downstream);
  save(checkpoint, "separation_upstream", lines.upstream);
}

Separations load_separations(const Checkpoint& checkpoint) {
  return {load(checkpoint, "separation_downstream"), load(checkpoint, "separation_upstream")};
}

}  // namespace dld
