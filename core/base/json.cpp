#include "core/base/json.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "core/base/text.h"

namespace nineline {

namespace {

/// Counts lines and columns while the parser reads.
struct Place {
  std::size_t line = 1;
  std::size_t column = 0;
};

class CountingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* at, Place* place) : at_(at), place_(place) {}
  reference operator*() const { return *at_; }
  CountingIterator& operator++() {
    if (*at_ == '\n') {
      ++place_->line;
      place_->column = 0;
    } else {
      ++place_->column;
    }
    ++at_;
    return *this;
  }
  friend bool operator==(const CountingIterator& a, const CountingIterator& b) { return a.at_ == b.at_; }
  friend bool operator!=(const CountingIterator& a, const CountingIterator& b) { return a.at_ != b.at_; }

 private:
  const char* at_;
  Place* place_;
};

constexpr std::size_t kDeepest = 200;

/// Builds the tree from the parser's events.
class TreeBuilder : public nlohmann::json_sax<nlohmann::json> {
 public:
  TreeBuilder(const Place& place, std::string source) : place_(place), source_(std::move(source)) {}

  bool null() override { return add(Json()); }
  bool boolean(bool value) override { return add(Json(value)); }
  bool number_integer(number_integer_t value) override { return add(Json(static_cast<double>(value))); }
  bool number_unsigned(number_unsigned_t value) override { return add(Json(static_cast<double>(value))); }
  bool number_float(number_float_t value, const string_t& text) override {
    if (!std::isfinite(value))
      return refuse("json.number", fmt::format("'{}' is no number that can be used.", printable(text)));
    return add(Json(value));
  }
  bool string(string_t& value) override { return add(Json(std::move(value))); }
  bool binary(binary_t&) override { return refuse("json.binary", "Binary data is not expected here."); }
  bool start_object(std::size_t) override { return open(Json::object()); }
  bool start_array(std::size_t) override { return open(Json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(string_t& name) override {
    if (open_.back().value.find(name) != nullptr)
      return refuse("json.duplicate", fmt::format("The key '{}' stands twice.", printable(name)));
    open_.back().key = name;
    return true;
  }
  bool parse_error(std::size_t, const std::string& token, const nlohmann::detail::exception&) override {
    return refuse("json.syntax", fmt::format("This is not valid JSON: found '{}', expected a value, ',', "
                                             "':', or the end of an object or array.",
                                             printable(token)));
  }

  [[nodiscard]] const std::optional<Error>& error() const { return error_; }
  Json take() { return std::move(root_); }

 private:
  struct Level {
    Json value;
    std::string key;
  };
  bool refuse(std::string code, std::string text) {
    error_ = badInput(std::move(code), std::move(text), source_, place_.line, place_.column);
    return false;
  }
  bool add(Json value) {
    if (value.line() == 0) value.setPlace(place_.line, place_.column);
    if (open_.empty()) {
      root_ = std::move(value);
    } else if (Json::Object* members = open_.back().value.members()) {
      members->emplace_back(open_.back().key, std::move(value));
    } else {
      open_.back().value.items()->push_back(std::move(value));
    }
    return true;
  }
  bool open(Json value) {
    if (open_.size() >= kDeepest) return refuse("json.depth", "The values are nested too deeply.");
    value.setPlace(place_.line, place_.column);
    open_.push_back({std::move(value), {}});
    return true;
  }
  bool close() {
    Json value = std::move(open_.back().value);
    open_.pop_back();
    return add(std::move(value));
  }

  const Place& place_;
  std::string source_;
  std::vector<Level> open_;
  Json root_;
  std::optional<Error> error_;
};

void writeString(std::string& out, const std::string& text) {
  out += nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void writeNumber(std::string& out, double value) {
  if (!std::isfinite(value)) {
    out += "null";
  } else if (value == std::floor(value) && std::abs(value) < 1e15) {
    out += fmt::format("{:.0f}", value == 0.0 ? 0.0 : value);
  } else {
    out += shortest(value);
  }
}

bool isShortArray(const Json::Array& items) {
  for (const Json& item : items) {
    if (item.items() != nullptr || item.members() != nullptr) return false;
  }
  return true;
}

void writeValue(std::string& out, const Json& value, int indent, int depth) {
  const auto newLine = [&](int level) {
    if (indent >= 0) out += "\n" + std::string(static_cast<std::size_t>(indent * level), ' ');
  };
  if (const bool* flag = value.boolean()) {
    out += *flag ? "true" : "false";
  } else if (const double* number = value.number()) {
    writeNumber(out, *number);
  } else if (const std::string* text = value.string()) {
    writeString(out, *text);
  } else if (const Json::Array* items = value.items()) {
    const bool flat = isShortArray(*items);
    out += "[";
    for (std::size_t i = 0; i < items->size(); ++i) {
      if (i != 0) out += flat && indent >= 0 ? ", " : ",";
      if (!flat) newLine(depth + 1);
      writeValue(out, (*items)[i], indent, depth + 1);
    }
    if (!flat) newLine(depth);
    out += "]";
  } else if (const Json::Object* members = value.members()) {
    out += "{";
    for (std::size_t i = 0; i < members->size(); ++i) {
      if (i != 0) out += ",";
      newLine(depth + 1);
      writeString(out, (*members)[i].first);
      out += indent >= 0 ? ": " : ":";
      writeValue(out, (*members)[i].second, indent, depth + 1);
    }
    if (!members->empty()) newLine(depth);
    out += "}";
  } else {
    out += "null";
  }
}

}  // namespace

const Json* Json::find(std::string_view key) const {
  if (const Object* object = members()) {
    for (const auto& [name, value] : *object) {
      if (name == key) return &value;
    }
  }
  return nullptr;
}

Json& Json::set(std::string_view key, Json value) {
  Object* object = members();
  NL_EXPECTS(object != nullptr);
  for (auto& [name, old] : *object) {
    if (name == key) {
      old = std::move(value);
      return *this;
    }
  }
  object->emplace_back(std::string(key), std::move(value));
  return *this;
}

Json& Json::push(Json value) {
  Array* array = items();
  NL_EXPECTS(array != nullptr);
  array->push_back(std::move(value));
  return *this;
}

std::string Json::describe() const {
  if (const double* value = number()) return fmt::format("the number {}", shortest(*value));
  if (const std::string* value = string()) return fmt::format("the text '{}'", printable(*value));
  if (const bool* value = boolean()) return *value ? "'true'" : "'false'";
  if (items() != nullptr) return "a list";
  if (members() != nullptr) return "an object";
  return "null";
}

Result<Json> parseJson(std::string_view text, const std::string& source) {
  constexpr std::string_view kBom = "\xef\xbb\xbf";
  if (text.substr(0, kBom.size()) == kBom) text.remove_prefix(kBom.size());
  Place place;
  TreeBuilder builder(place, source);
  const CountingIterator begin(text.data(), &place);
  const CountingIterator end(text.data() + text.size(), &place);
  if (!nlohmann::json::sax_parse(begin, end, &builder)) return *builder.error();
  return builder.take();
}

std::string writeJson(const Json& value, int indent) {
  std::string out;
  writeValue(out, value, indent, 0);
  return out;
}

}  // namespace nineline
