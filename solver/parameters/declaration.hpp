#pragma once
/// The parameter table: one line per parameter, from which the strict reader, the resolved echo and the
/// JSON Schema are all derived. Defaults come from the member initialisers of struct Case.
#include <limits>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "parameters/case.hpp"

namespace dld {

/// Where a value goes in a Case; its alternative is the parameter's type. What is optional has no default:
/// the echo leaves it out when it is absent.
using Field = std::variant<double*, int*, long*, bool*, std::string*, std::vector<double>*,
                           std::optional<double>*, std::optional<PillarValues>*, std::optional<std::string>*>;

/// Allowed values: an interval for numbers (and for the items of a list), names for texts.
struct Allowed {
  double minimum = -std::numeric_limits<double>::infinity();
  double maximum = std::numeric_limits<double>::infinity();
  bool open_minimum = false;  ///< the minimum itself is not allowed
  std::vector<std::string> names = {};
  std::size_t items = 0;     ///< of a list; 0: any number but none
  std::string meaning = {};  ///< of the names: what each is for, where they do not speak for themselves
};

struct Declaration {
  std::string_view section;  ///< "cell/start", empty for the top level
  std::string_view name;
  Field (*field)(Case&);
  Allowed allowed;
  std::string_view unit;  ///< "1" for a dimensionless number, empty for texts and switches
  std::string_view doc;

  std::string pointer() const;  ///< JSON pointer, "/cell/start/x_um"
};

/// All parameters, in the order of struct Case. `scene` is the only required one. A text or list that is
/// empty by default has no default: empty means that the case does not give it.
const std::vector<Declaration>& declarations();

/// geometry/epsilon = d / lambda, the other way of giving row_shift_um: it has no member of its own.
const Declaration& epsilon_declaration();

/// Names at the top level that speak about the case and change nothing: "$schema", "description".
inline const std::vector<std::string> annotations = {"$schema", "description"};

/// Sections ("geometry", "cell", "cell/start", ...) in the order of the table.
std::vector<std::string> sections();

bool in_range(double value, const Allowed& allowed);

/// The allowed values in words: "between 0.5 and 100", "one of bgk, trt".
std::string allowed_text(const Allowed& allowed);

/// What to change in a number that is out of range: "use at most 100".
std::string nearest_advice(double value, const Allowed& allowed);

}  // namespace dld
