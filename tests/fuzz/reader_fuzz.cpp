/// Coverage-guided fuzzing of the reader of case files: libFuzzer calls it with bytes, it has to answer with
/// a case or with a list of problems. What it accepts has to be echoed to the same case, and its derived
/// numbers computed.
#include <cstdlib>
#include <iostream>
#include <string>

#include "parameters/limits.hpp"
#include "parameters/reader.hpp"
#include "parameters/report.hpp"

namespace {

// Ends the fuzzing with the input that is at fault.
void require(bool holds, const char* what) {
  if (holds) return;
  std::cerr << what << "\n";
  std::abort();
}

void read_and_derive(const std::string& text) {
  const dld::Case c = dld::parse_case(text, "case.json");
  const std::string echoed = dld::echo(c).dump();
  require(dld::echo(dld::parse_case(echoed, "echo.json")).dump() == echoed, "the echo is another case");
  dld::lattice_numbers(c);
  dld::dimensionless_numbers(c);
  dld::si_numbers(c);
  dld::memory_MiB(c);
  dld::expected_cost(c);
  dld::margins_json(dld::stability_margins(c));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    read_and_derive(std::string(reinterpret_cast<const char*>(data), size));
  } catch (const dld::CaseError& error) {
    require(!error.problems.empty() && error.what()[0] != '\0', "a refusal without a reason");
  }
  return 0;
}
