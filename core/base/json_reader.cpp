#include <fmt/format.h>

#include "core/base/json.h"
#include "core/base/text.h"

namespace nineline {

JsonReader::JsonReader(const Json& object, std::string source, std::string what)
    : object_(object), source_(std::move(source)), what_(std::move(what)) {
  if (object_.members() == nullptr) {
    error_ =
        badInput("json.type", fmt::format("{}: found {}, expected an object.", what_, object_.describe()),
                 source_, object_.line(), object_.column());
  }
}

void JsonReader::fail(std::string_view key, std::string code, std::string text) {
  if (error_) return;
  const Json* found = object_.find(key);
  const Json& place = found != nullptr ? *found : object_;
  error_ =
      badInput(std::move(code), fmt::format("{}: {}", what_, text), source_, place.line(), place.column());
}

void JsonReader::wrong(const Json& found, std::string_view key, std::string_view expected) {
  fail(key, "json.type", fmt::format("'{}' is {}, expected {}.", key, found.describe(), expected));
}

const Json* JsonReader::required(std::string_view key, std::string_view expected) {
  const Json* found = object_.find(key);
  if (found == nullptr)
    fail(key, "json.missing", fmt::format("'{}' is missing, expected {}.", key, expected));
  return found;
}

double JsonReader::number(std::string_view key) {
  const Json* found = required(key, "a number");
  if (found == nullptr) return 0.0;
  if (found->number() == nullptr) wrong(*found, key, "a number");
  return found->number() != nullptr ? *found->number() : 0.0;
}

double JsonReader::numberOr(std::string_view key, double otherwise) {
  return has(key) ? number(key) : otherwise;
}

bool JsonReader::booleanOr(std::string_view key, bool otherwise) {
  const Json* found = object_.find(key);
  if (found == nullptr) return otherwise;
  if (found->boolean() == nullptr) wrong(*found, key, "true or false");
  return found->boolean() != nullptr ? *found->boolean() : otherwise;
}

std::string JsonReader::string(std::string_view key) {
  const Json* found = required(key, "a text");
  if (found == nullptr) return {};
  if (found->string() == nullptr) wrong(*found, key, "a text");
  return found->string() != nullptr ? *found->string() : std::string();
}

std::string JsonReader::stringOr(std::string_view key, std::string otherwise) {
  return has(key) ? string(key) : std::move(otherwise);
}

std::vector<double> JsonReader::numbers(std::string_view key) {
  std::vector<double> values;
  for (const Json& item : items(key)) {
    if (item.number() == nullptr) {
      if (!error_) {
        error_ = badInput("json.type",
                          fmt::format("{}: value {} of '{}' is {}, expected a number.", what_,
                                      values.size() + 1, key, item.describe()),
                          source_, item.line(), item.column());
      }
      return {};
    }
    values.push_back(*item.number());
  }
  return values;
}

std::vector<double> JsonReader::numbers(std::string_view key, std::size_t count) {
  std::vector<double> values = numbers(key);
  if (values.size() != count) {
    fail(key, "json.count", fmt::format("'{}' has {} values, expected {}.", key, values.size(), count));
    values.assign(count, 0.0);
  }
  return values;
}

const Json::Array& JsonReader::items(std::string_view key) {
  static const Json::Array kNone;
  const Json* found = required(key, "a list");
  if (found == nullptr) return kNone;
  if (found->items() == nullptr) wrong(*found, key, "a list");
  return found->items() != nullptr ? *found->items() : kNone;
}

}  // namespace nineline
