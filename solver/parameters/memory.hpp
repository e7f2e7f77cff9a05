#pragma once
/// What a run needs of the machine's memory, known before it is started.
#include <string>

#include "parameters/case.hpp"

namespace dld {

/// Largest memory of the run, MiB: fields with the margins of their storage, a checkpoint while it is
/// written, the membrane, the shapes that are kept to the end. Of what was measured it is 0.9 to 1.3 times.
double memory_MiB(const Case& c);

/// What to change so that the case needs less, for a message.
std::string memory_advice(const Case& c);

}  // namespace dld
