#pragma once
/// How far a case is from where explicit coupling and the lattice are known to fail, before it is run.
#include <string>
#include <vector>

#include "parameters/case.hpp"

namespace dld {

/// One margin: `share` is the used part of it, below 1 while it holds. The limits agree with the stability
/// maps (results/tables/stability.csv); they are no proofs of stability.
struct Margin {
  std::string name;
  double value = 0, limit = 0, share = 0;
  std::string unit;
  bool ok = true;
  bool fails = true;   ///< a violation makes the run diverge; otherwise it makes it inaccurate
  std::string advice;  ///< what to change when it is violated
};

/// The margins of the case's scene.
std::vector<Margin> stability_margins(const Case& c);

/// Margins by scene: of the coupled membrane, of the contact and of the flow; of none where nothing is known.
/// kink_mobility: what the kernel gives back (lu, see CouplingModel), which only the coupling knows.
std::vector<Margin> passage_margins(const Case& c, double kink_mobility);
std::vector<Margin> streamlines_margins(const Case& c);
std::vector<Margin> stretching_margins(const Case& c, double kink_mobility);
std::vector<Margin> channel_margins(const Case& c);
std::vector<Margin> shear_margins(const Case& c);

/// Is one violated that makes a run diverge?
bool expected_to_diverge(const std::vector<Margin>& margins);

/// The margin of largest share among those whose violation makes a run diverge; nullptr for an empty list.
const Margin* tightest(const std::vector<Margin>& margins);

}  // namespace dld
