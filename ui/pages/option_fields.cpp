#include "ui/pages/option_fields.h"

#include <QCoreApplication>

namespace nineline::pages {

namespace {

using widgets::Field;

QString tr(const char* text) { return QCoreApplication::translate("options", text); }

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
  std::vector<Field> fields;
  fields.push_back(group(tr("Accuracy")));
  fields.push_back(number("tolerance_um", tr("Tolerance along a block"), "µm", 1.0));
  fields.push_back(number("angle_tolerance_arcsec", tr("Tolerance of the tool axis"), "″", 3.6));
  fields.push_back(flag("keep_block_count", tr("Keep the number of blocks"), false));
  fields.push_back(flag("correct_rapids", tr("Correct rapid motions too"), true));
  fields.push_back(choices("mode", tr("Correct"),
                           {{"auto", tr("Tip and tool axis")},
                            {"tip", tr("The tool tip only")},
                            {"thread", tr("Radius and lead of a thread (X and Z)")}}));
  fields.push_back(group(tr("Limits")));
  fields.push_back(number("largest_correction_mm", tr("Largest correction"), "mm", 1.0));
  fields.push_back(number("largest_correction_deg", tr("Largest angular correction"), "°", 1.0));
  fields.push_back(group(tr("Decimals of the corrected words")));
  fields.push_back(number("linear_decimals", tr("Linear axes"), "", {}, tr("as in the program")));
  fields.push_back(number("rotary_decimals", tr("Rotary axes"), "", {}, tr("as in the program")));
  return fields;
}

std::vector<Field> controlFields() {
  std::vector<Field> fields;
  fields.push_back(choices("dialect", tr("Control"),
                           {{"auto", tr("Recognise from the program")},
                            {"fanuc", tr("ISO / Fanuc")},
                            {"siemens", tr("Siemens 840D")},
                            {"linuxcnc", tr("LinuxCNC")}}));
  fields.push_back(flag("block_skip", tr("Skip blocks that begin with /"), false));
  return fields;
}

}  // namespace nineline::pages
