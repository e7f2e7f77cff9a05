#include "parameters/syntax.hpp"

#include <cstddef>
#include <iterator>
#include <set>

namespace dld {
namespace {

// No section has nearly as many; the time that an object of the library takes grows with the square.
constexpr std::size_t most_names = 1000, most_repeated = 50;

using Json = nlohmann::ordered_json;

// "line 3, column 5" of a byte offset (1-based, as the parser counts).
std::string place(const std::string& text, std::size_t byte) {
  std::size_t line = 1, column = 1;
  for (std::size_t i = 0; i + 1 < byte && i < text.size(); ++i) {
    column = text[i] == '\n' ? 1 : column + 1;
    line += text[i] == '\n' ? 1 : 0;
  }
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

// The parser's message without its code and position: "syntax error while parsing ...".
std::string reason(const std::string& message) {
  for (const char* before : {": ", "] "}) {
    const auto start = message.find(before);
    if (start != std::string::npos) return message.substr(start + 2);
  }
  return message;
}

/// Reads a text byte by byte and counts: the parser does not tell its handler where it is.
class CountedBytes {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountedBytes(const char* at, std::size_t* read) : at_(at), read_(read) {}
  reference operator*() const { return *at_; }
  CountedBytes& operator++() {
    ++at_;
    ++*read_;
    return *this;
  }
  CountedBytes operator++(int) {
    CountedBytes before = *this;
    ++*this;
    return before;
  }
  bool operator==(const CountedBytes& other) const { return at_ == other.at_; }
  bool operator!=(const CountedBytes& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  std::size_t* read_;
};

/// Builds the tree from the parser's events and knows the place of each in the tree and in the text.
class TreeBuilder {
 public:
  TreeBuilder(const std::string& text, const std::size_t& read, std::vector<Problem>& problems)
      : text_(text), read_(read), problems_(problems) {}

  Json root;

  bool null() { return add(nullptr); }
  bool boolean(bool value) { return add(value); }
  bool number_integer(Json::number_integer_t value) { return add(value); }
  bool number_unsigned(Json::number_unsigned_t value) { return add(value); }
  bool number_float(Json::number_float_t value, const std::string&) { return add(value); }
  bool string(std::string& value) { return add(value); }
  bool binary(Json::binary_t&) { return false; }
  bool start_object(std::size_t) { return open(Json::object()); }
  bool start_array(std::size_t) { return open(Json::array()); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }

  bool key(std::string& name) {
    Level& level = levels_.back();
    level.name = name;
    if (!level.names.insert(name).second)
      problems_.push_back({pointer(), Json(name).dump(), "each name once",
                           "remove the repeated name " + Json(name).dump() + " at " + place(text_, read_)});
    if (level.names.size() > most_names) {
      problems_.push_back({"", "", "at most " + std::to_string(most_names) + " names in an object",
                           "remove names before " + place(text_, read_)});
    }
    // What follows would say the same, and to find the place of each takes long.
    return level.names.size() <= most_names && problems_.size() < most_repeated;
  }

  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& error) {
    constexpr int out_of_range = 406;
    problems_.push_back({pointer(), "", error.id == out_of_range ? "a number below 1.8e308" : "JSON",
                         place(text_, position) + ": " + reason(error.what())});
    return false;
  }

 private:
  struct Level {
    Json* value;
    std::string name = {};             ///< of the member that is read
    std::set<std::string> names = {};  ///< so far, of an object
  };

  std::string pointer() const {
    nlohmann::json::json_pointer path;
    for (const Level& level : levels_) {
      if (level.value->is_array()) path /= level.value->size();
      if (level.value->is_object() && !level.names.empty()) path /= level.name;
    }
    return path.to_string();
  }

  Json* put(Json value) {
    if (levels_.empty()) return &(root = std::move(value));
    Json& parent = *levels_.back().value;
    if (parent.is_object()) return &(parent[levels_.back().name] = std::move(value));
    parent.push_back(std::move(value));
    return &parent.back();
  }
  bool add(Json value) {
    put(std::move(value));
    return true;
  }
  bool open(Json value) {
    if (levels_.size() == deepest_json) {
      problems_.push_back({"", "",
                           "at most " + std::to_string(deepest_json) + " objects and lists in one another",
                           "remove brackets at " + place(text_, read_)});
      return false;
    }
    levels_.push_back({put(std::move(value))});
    return true;
  }
  bool close() {
    levels_.pop_back();
    return true;
  }

  const std::string& text_;
  const std::size_t& read_;
  std::vector<Problem>& problems_;
  std::vector<Level> levels_;  ///< objects and lists that are open; what is within one of them does not move
};

}  // namespace

nlohmann::ordered_json parse_json(const std::string& text, std::vector<Problem>& problems) {
  std::size_t read = 0;
  const CountedBytes first(text.data(), &read), last(text.data() + text.size(), &read);
  TreeBuilder builder(text, read, problems);
  if (!Json::sax_parse(first, last, &builder)) return nullptr;
  return std::move(builder.root);
}

}  // namespace dld
