#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/base/result.h"

namespace nineline {

/// A JSON value that remembers where it stood, so that a message can name the place. Objects keep their
/// order.
class Json {
 public:
  using Array = std::vector<Json>;
  using Object = std::vector<std::pair<std::string, Json>>;

  Json() = default;                                        ///< null
  Json(bool value) : value_(value) {}                      // NOLINT: implicit by intention, like those below
  Json(double value) : value_(value) {}                    // NOLINT
  Json(int value) : value_(double(value)) {}               // NOLINT
  Json(std::size_t value) : value_(double(value)) {}       // NOLINT
  Json(const char* value) : value_(std::string(value)) {}  // NOLINT
  Json(std::string value) : value_(std::move(value)) {}    // NOLINT
  Json(std::string_view value) : value_(std::string(value)) {}  // NOLINT
  Json(Array value) : value_(std::move(value)) {}               // NOLINT
  Json(Object value) : value_(std::move(value)) {}              // NOLINT

  [[nodiscard]] static Json object() { return Json(Object{}); }
  [[nodiscard]] static Json array() { return Json(Array{}); }

  [[nodiscard]] bool isNull() const { return value_.index() == 0; }
  [[nodiscard]] const bool* boolean() const { return std::get_if<bool>(&value_); }
  [[nodiscard]] const double* number() const { return std::get_if<double>(&value_); }
  [[nodiscard]] const std::string* string() const { return std::get_if<std::string>(&value_); }
  [[nodiscard]] const Array* items() const { return std::get_if<Array>(&value_); }
  [[nodiscard]] const Object* members() const { return std::get_if<Object>(&value_); }
  [[nodiscard]] Array* items() { return std::get_if<Array>(&value_); }
  [[nodiscard]] Object* members() { return std::get_if<Object>(&value_); }

  /// The member of an object; null when this is no object or has no such member.
  [[nodiscard]] const Json* find(std::string_view key) const;
  /// Sets (replaces) a member. Requires an object.
  Json& set(std::string_view key, Json value);
  /// Appends to an array. Requires an array.
  Json& push(Json value);

  /// What kind of value stands here, for messages: "a number (3.5)", "the text 'abc'", "nothing".
  [[nodiscard]] std::string describe() const;

  [[nodiscard]] std::size_t line() const { return line_; }
  [[nodiscard]] std::size_t column() const { return column_; }
  void setPlace(std::size_t line, std::size_t column) { line_ = line, column_ = column; }

 private:
  std::variant<std::monostate, bool, double, std::string, Array, Object> value_;
  std::size_t line_ = 0;
  std::size_t column_ = 0;
};

/// Reads JSON text (a BOM is skipped). Duplicate keys, NaN and trailing text are faults, reported with their
/// place.
[[nodiscard]] Result<Json> parseJson(std::string_view text, const std::string& source);

/// `indent` < 0 writes one line. Numbers take the shortest form that reads back the same; non-finite ones
/// become null.
[[nodiscard]] std::string writeJson(const Json& value, int indent = 2);

/// Reads the members of one object, collecting the first fault; every error names file, line, key, what stood
/// there and what was expected.
class JsonReader {
 public:
  JsonReader(const Json& object, std::string source, std::string what);

  [[nodiscard]] bool has(std::string_view key) const { return object_.find(key) != nullptr; }
  double number(std::string_view key);
  double numberOr(std::string_view key, double otherwise);
  bool booleanOr(std::string_view key, bool otherwise);
  std::string string(std::string_view key);
  std::string stringOr(std::string_view key, std::string otherwise);
  std::vector<double> numbers(std::string_view key);
  /// Exactly `count` numbers.
  std::vector<double> numbers(std::string_view key, std::size_t count);
  const Json::Array& items(std::string_view key);
  /// Reports a fault found by the caller at a member (or at the object itself when the key is absent).
  void fail(std::string_view key, std::string code, std::string text);

  [[nodiscard]] const Json& json() const { return object_; }
  [[nodiscard]] const std::string& source() const { return source_; }
  [[nodiscard]] bool failed() const { return error_.has_value(); }
  [[nodiscard]] const Error& error() const { return *error_; }

 private:
  const Json* required(std::string_view key, std::string_view expected);
  void wrong(const Json& found, std::string_view key, std::string_view expected);
  const Json& object_;
  std::string source_;
  std::string what_;
  std::optional<Error> error_;
};

}  // namespace nineline
