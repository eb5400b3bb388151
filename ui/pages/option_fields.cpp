#include "ui/pages/option_fields.h"

#include <QCoreApplication>
#include <cmath>

#include "core/base/units.h"
#include "core/compensation/compensation.h"

namespace nineline::pages {

namespace {

using widgets::Field;

QString text(const char* source) { return QCoreApplication::translate("options", source); }

Field group(const QString& label) {
  Field field;
  field.kind = Field::Kind::Group;
  field.label = label;
  return field;
}

Field number(const char* key, const QString& label, const char* unit, Json otherwise,
             const QString& absent = {}) {
  Field field;
  field.key = key;
  field.label = label;
  field.unit = QString::fromUtf8(unit);
  field.otherwise = std::move(otherwise);
  field.absent = absent;
  return field;
}

Field flag(const char* key, const QString& label, bool otherwise) {
  Field field;
  field.kind = Field::Kind::Flag;
  field.key = key;
  field.label = label;
  field.otherwise = Json(otherwise);
  return field;
}

Field choices(const char* key, const QString& label, std::vector<widgets::Choice> all) {
  Field field;
  field.kind = Field::Kind::Choices;
  field.key = key;
  field.label = label;
  field.otherwise = Json(all.front().value);
  field.choices = std::move(all);
  return field;
}

}  // namespace

std::vector<Field> optionFields() {
  const compensation::CompensationOptions usual;
  std::vector<Field> fields;
  fields.push_back(group(text(QT_TRANSLATE_NOOP("options", "Accuracy"))));
  fields.push_back(number("tolerance_um", text(QT_TRANSLATE_NOOP("options", "Tolerance along a block")), "µm",
                          umFromMm(usual.tolerance)));
  fields.push_back(number("angle_tolerance_arcsec",
                          text(QT_TRANSLATE_NOOP("options", "Tolerance of the tool axis")), "″",
                          std::round(10.0 * arcsecFromRad(usual.angle_tolerance)) / 10.0));
  fields.push_back(
      flag("keep_block_count", text(QT_TRANSLATE_NOOP("options", "Keep the number of blocks")), false));
  fields.push_back(
      flag("correct_rapids", text(QT_TRANSLATE_NOOP("options", "Correct rapid motions too")), true));
  fields.push_back(
      choices("mode", text(QT_TRANSLATE_NOOP("options", "Correct")),
              {{"auto", text(QT_TRANSLATE_NOOP("options", "Tip and tool axis"))},
               {"tip", text(QT_TRANSLATE_NOOP("options", "The tool tip only"))},
               {"thread", text(QT_TRANSLATE_NOOP("options", "Radius and lead of a thread (X and Z)"))}}));
  fields.push_back(group(text(QT_TRANSLATE_NOOP("options", "Limits"))));
  fields.push_back(
      number("largest_correction_mm", text(QT_TRANSLATE_NOOP("options", "Largest correction")), "mm", 1.0));
  fields.push_back(number("largest_correction_deg",
                          text(QT_TRANSLATE_NOOP("options", "Largest angular correction")), "°", 1.0));
  fields.push_back(group(text(QT_TRANSLATE_NOOP("options", "Decimals of the corrected words"))));
  fields.push_back(number("linear_decimals", text(QT_TRANSLATE_NOOP("options", "Linear axes")), "", {},
                          text(QT_TRANSLATE_NOOP("options", "as in the program"))));
  fields.push_back(number("rotary_decimals", text(QT_TRANSLATE_NOOP("options", "Rotary axes")), "", {},
                          text(QT_TRANSLATE_NOOP("options", "as in the program"))));
  return fields;
}

std::vector<Field> controlFields() {
  std::vector<Field> fields;
  fields.push_back(choices("dialect", text(QT_TRANSLATE_NOOP("options", "Control")),
                           {{"auto", text(QT_TRANSLATE_NOOP("options", "Recognise from the program"))},
                            {"fanuc", text(QT_TRANSLATE_NOOP("options", "ISO / Fanuc"))},
                            {"siemens", text(QT_TRANSLATE_NOOP("options", "Siemens 840D"))},
                            {"linuxcnc", text(QT_TRANSLATE_NOOP("options", "LinuxCNC"))}}));
  fields.push_back(
      flag("block_skip", text(QT_TRANSLATE_NOOP("options", "Skip blocks that begin with /")), false));
  return fields;
}

}  // namespace nineline::pages
