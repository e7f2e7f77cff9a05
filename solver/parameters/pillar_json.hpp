#pragma once
/// The pillar of a case: what each shape declares about itself (geometry/pillar.hpp) as reader, echo and
/// schema.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "geometry/pillar.hpp"
#include "parameters/reader.hpp"

namespace dld {

/// Reads {"shape": ..., parameters of that shape}, with the defaults filled in; `pointer` is its place in the
/// file. Every problem is added to the list; nothing is returned if there is one.
std::optional<PillarValues> read_pillar(const nlohmann::ordered_json& json, const std::string& pointer,
                                        std::vector<Problem>& problems);

/// Reading it gives the same values.
nlohmann::ordered_json pillar_json(const PillarValues& values);

/// "circle, radius 10 um", every number as `number` writes it.
std::string pillar_words(const PillarValues& values, std::string (*number)(double));

/// One alternative per registered shape.
nlohmann::ordered_json pillar_schema();

}  // namespace dld
