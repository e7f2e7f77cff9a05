#pragma once
/// How far a case is from where explicit coupling and the lattice are known to fail, before it is run.
#include <string>
#include <vector>

#include "parameters/case.hpp"

namespace dld {

/// One margin: `value` must stay below `limit`. The limits are estimates and not proofs of stability.
struct Margin {
  std::string name;
  double value = 0, limit = 0;
  std::string unit;
  bool ok = true;
  std::string advice;  ///< what to change when it is violated
};

/// Margins of a coupled run (passage, coupled stretching); empty for scenes without a coupled membrane.
std::vector<Margin> stability_margins(const Case& c);

}  // namespace dld
