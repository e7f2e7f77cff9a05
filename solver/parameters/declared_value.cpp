#include "parameters/declared_value.hpp"

#include <algorithm>
#include <cmath>

#include "parameters/advice.hpp"
#include "parameters/pillar_json.hpp"
#include "parameters/text.hpp"

namespace dld {
namespace {

using Json = nlohmann::ordered_json;

// A whole number, also when it is written 10.0 (as in JSON Schema).
bool is_whole(const Json& value) {
  return value.is_number_integer() ||
         (value.is_number_float() && std::trunc(value.get<double>()) == value.get<double>());
}

// Checks `value` against one declaration and, if it is right, stores it through the field.
class Store {
 public:
  Store(const Declaration& declaration, const Json& value, std::vector<Problem>& problems)
      : declaration_(declaration), value_(value), problems_(problems) {}

  void operator()(double* field) const {
    if (const auto number = checked_number("a number")) *field = *number;
  }
  void operator()(int* field) const {
    if (const auto number = checked_number("a whole number")) *field = static_cast<int>(*number);
  }
  void operator()(long* field) const {
    if (const auto number = checked_number("a whole number")) *field = static_cast<long>(*number);
  }
  void operator()(bool* field) const {
    if (value_.is_boolean()) {
      *field = value_.get<bool>();
    } else {
      complain("true or false", "write true or false without quotes");
    }
  }
  void operator()(std::string* field) const {
    const auto& names = declaration_.allowed.names;
    if (names.empty()) {
      if (value_.is_string() && !value_.get<std::string>().empty()) {
        *field = value_.get<std::string>();
      } else {
        complain("a text", "write it in quotes, or remove the key");
      }
    } else if (value_.is_string() && std::ranges::find(names, value_.get<std::string>()) != names.end()) {
      *field = value_.get<std::string>();
    } else {
      const std::string given = value_.is_string() ? value_.get<std::string>() : value_.dump();
      complain(allowed_text(declaration_.allowed), unknown_text_advice(given, declaration_.allowed));
    }
  }
  void operator()(std::vector<double>* field) const {
    const std::size_t items = declaration_.allowed.items;
    const bool right = value_.is_array() && !value_.empty() && (items == 0 || value_.size() == items) &&
                       std::ranges::all_of(value_, [&](const Json& item) {
                         return item.is_number() && in_range(item.get<double>(), declaration_.allowed);
                       });
    if (right) {
      *field = value_.get<std::vector<double>>();
    } else {
      complain("a list of " + (items > 0 ? number_text(static_cast<double>(items)) + " " : "") +
                   "numbers, each " + allowed_text(declaration_.allowed),
               items == 3 ? "write e.g. [4, 3, 1.5]" : "write e.g. [0, 20, 40]");
    }
  }

  void operator()(std::optional<double>* field) const { *field = checked_number("a number"); }
  void operator()(std::optional<std::string>* field) const {
    std::string name;
    (*this)(&name);
    if (!name.empty()) *field = name;
  }
  void operator()(std::optional<PillarValues>* field) const {
    *field = read_pillar(value_, declaration_.pointer(), problems_);
  }

  std::optional<double> checked_number(const std::string& kind) const {
    const bool right_kind = kind == "a whole number" ? is_whole(value_) : value_.is_number();
    const std::string range = allowed_text(declaration_.allowed);
    const std::string allowed = kind + (range == "any" ? "" : " " + range);
    if (!right_kind) {
      complain(allowed, "write " + kind + (value_.is_string() ? " without quotes" : ""));
      return std::nullopt;
    }
    if (!in_range(value_.get<double>(), declaration_.allowed)) {
      complain(allowed, nearest_advice(value_.get<double>(), declaration_.allowed));
      return std::nullopt;
    }
    return value_.get<double>();
  }

 private:
  void complain(const std::string& allowed, const std::string& advice) const {
    problems_.push_back({declaration_.pointer(), value_.dump(), allowed, advice});
  }

  const Declaration& declaration_;
  const Json& value_;
  std::vector<Problem>& problems_;
};

}  // namespace

void store_value(const Declaration& declaration, const Json& value, const Field& place,
                 std::vector<Problem>& problems) {
  std::visit(Store(declaration, value, problems), place);
}

std::optional<double> declared_number(const Declaration& declaration, const Json& value,
                                      std::vector<Problem>& problems) {
  return Store(declaration, value, problems).checked_number("a number");
}

}  // namespace dld
