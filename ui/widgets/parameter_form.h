#pragma once

#include <QScrollArea>
#include <QString>
#include <map>
#include <string>
#include <vector>

#include "core/base/json.h"

class QFormLayout;
class QLabel;

namespace nineline::widgets {

struct Choice {
  std::string value;
  QString label;
};

/// One field of a form over the members of a JSON object.
struct Field {
  enum class Kind { Group, Number, Text, Flag, Choices };
  Kind kind = Kind::Number;
  std::string key;
  QString label;
  QString unit;
  QString absent;  ///< shown in an empty field: what holds then; empty: the value is required
  std::vector<Choice> choices;
  QString hint;
  Json otherwise;  ///< shown while the object lacks the key
};

/// A form for the members of a JSON object: labels, units, hints, marks on bad values. It keeps nothing:
/// `edited` carries each change to whoever keeps the object, and setValues brings it back.
class ParameterForm : public QScrollArea {
  Q_OBJECT

 public:
  explicit ParameterForm(std::vector<Field> fields, QWidget* parent = nullptr);
  void setValues(const Json& object);
  /// Faults by key, from the checks of core; others are cleared.
  void setFaults(const std::map<std::string, QString>& faults);
  [[nodiscard]] const std::vector<Field>& fields() const { return fields_; }

 signals:
  void edited(const QString& key, const nineline::Json& value);

 private:
  QWidget* makeEditor(const Field& field);
  void addField(QFormLayout* form, const Field& field);
  std::vector<Field> fields_;
  std::map<std::string, QWidget*> editors_;
};

}  // namespace nineline::widgets
