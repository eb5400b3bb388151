#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "core/base/contract.h"

namespace nineline {

/// Kinds of failure; the values are the exit statuses of the command line.
enum class ErrorKind { Usage = 2, BadInput = 3, NoAnswer = 4, Transfer = 5 };

/// What went wrong, in a form that a table, the command line and a translation can show.
struct Error {
  ErrorKind kind = ErrorKind::BadInput;
  std::string code;        ///< stable identifier, for example "machine.travel"; translations go by it
  std::string text;        ///< English, complete sentence with the values in it
  std::string source;      ///< file name or other origin; empty when there is none
  std::size_t line = 0;    ///< from 1; 0 when the error has no place
  std::size_t column = 0;  ///< from 1; 0 when unknown

  /// "source:line:column: text", leaving out what is absent.
  [[nodiscard]] std::string message() const;
};

[[nodiscard]] Error usageError(std::string code, std::string text);
[[nodiscard]] Error badInput(std::string code, std::string text, std::string source = {},
                             std::size_t line = 0, std::size_t column = 0);
[[nodiscard]] Error noAnswer(std::string code, std::string text, std::string source = {},
                             std::size_t line = 0);

/// A value or the Error that prevented it; the interface of std::expected<T, Error>.
template <typename T>
class [[nodiscard]] Result {
 public:
  Result(T value) : content_(std::in_place_index<0>, std::move(value)) {}  // NOLINT: implicit by intention
  Result(Error error) : content_(std::in_place_index<1>, std::move(error)) {}  // NOLINT

  [[nodiscard]] bool has_value() const { return content_.index() == 0; }
  explicit operator bool() const { return has_value(); }

  T& value() & { return checked(); }
  const T& value() const& { return const_cast<Result*>(this)->checked(); }
  T&& value() && { return std::move(checked()); }
  T& operator*() & { return checked(); }
  const T& operator*() const& { return value(); }
  T&& operator*() && { return std::move(checked()); }
  T* operator->() { return &checked(); }
  const T* operator->() const { return &value(); }

  [[nodiscard]] const Error& error() const {
    NL_EXPECTS(!has_value());
    return *std::get_if<1>(&content_);
  }
  template <typename U>
  [[nodiscard]] T value_or(U&& otherwise) const {
    return has_value() ? *std::get_if<0>(&content_) : static_cast<T>(std::forward<U>(otherwise));
  }

 private:
  T& checked() {
    NL_EXPECTS(has_value(), std::get_if<1>(&content_)->text);
    return *std::get_if<0>(&content_);
  }
  std::variant<T, Error> content_;
};

template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : error_(std::move(error)) {}  // NOLINT: implicit by intention
  [[nodiscard]] bool has_value() const { return !error_; }
  explicit operator bool() const { return has_value(); }
  [[nodiscard]] const Error& error() const {
    NL_EXPECTS(error_.has_value());
    return *error_;
  }

 private:
  std::optional<Error> error_;
};

}  // namespace nineline
