#pragma once

#include <QLineEdit>
#include <optional>

#include "core/base/json.h"

namespace nineline::widgets {

/// A field for a number. What is typed stays as it is; what is no number is marked with its reason. Point and
/// comma both part decimals.
class NumberEdit : public QLineEdit {
  Q_OBJECT

 public:
  explicit NumberEdit(QWidget* parent = nullptr);
  /// A number, a text that was typed and is none, or null for an empty field.
  void setCell(const Json& cell);
  [[nodiscard]] Json cell() const;
  [[nodiscard]] std::optional<double> number() const;
  /// An empty field is right (the value is derived).
  void setOptional(bool optional) { optional_ = optional; }
  /// A fault found by somebody else ("above 0"); empty: none.
  void setFault(const QString& fault);

 signals:
  /// The person has finished typing a different content.
  void edited(const nineline::Json& cell);

 private:
  void mark();
  bool optional_ = false;
  QString fault_;
  QString last_;
};

}  // namespace nineline::widgets
