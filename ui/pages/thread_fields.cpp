#include "ui/pages/thread_fields.h"

#include <QCoreApplication>

namespace nineline::pages {

namespace {

using widgets::Field;

QString text(const char* source) { return QCoreApplication::translate("thread", source); }

Field group(const QString& label) {
  Field field;
  field.kind = Field::Kind::Group;
  field.label = label;
  return field;
}

Field number(const char* key, const QString& label, const char* unit, Json otherwise = {},
             const QString& absent = {}) {
  Field field;
  field.key = key;
  field.label = label;
  field.unit = QString::fromUtf8(unit);
  field.otherwise = std::move(otherwise);
  field.absent = absent;
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

void appendThread(std::vector<Field>& fields) {
  fields.push_back(group(text(QT_TRANSLATE_NOOP("thread", "Thread"))));
  fields.push_back(number("diameter_mm", text(QT_TRANSLATE_NOOP("thread", "Nominal diameter")), "mm"));
  fields.push_back(number("pitch_mm", text(QT_TRANSLATE_NOOP("thread", "Pitch")), "mm"));
  fields.push_back(number("length_mm", text(QT_TRANSLATE_NOOP("thread", "Length")), "mm"));
  fields.push_back(number("starts", text(QT_TRANSLATE_NOOP("thread", "Starts")), "", 1));
  fields.push_back(choices("hand", text(QT_TRANSLATE_NOOP("thread", "Hand")),
                           {{"right", text(QT_TRANSLATE_NOOP("thread", "Right"))},
                            {"left", text(QT_TRANSLATE_NOOP("thread", "Left"))}}));
  fields.push_back(choices("type", text(QT_TRANSLATE_NOOP("thread", "Kind")),
                           {{"external", text(QT_TRANSLATE_NOOP("thread", "External"))},
                            {"internal", text(QT_TRANSLATE_NOOP("thread", "Internal"))}}));
  fields.push_back(number("depth_mm", text(QT_TRANSLATE_NOOP("thread", "Depth")), "mm", {},
                          text(QT_TRANSLATE_NOOP("thread", "ISO 68-1"))));
  fields.push_back(number("taper_1", text(QT_TRANSLATE_NOOP("thread", "Taper of the radius")), "mm/mm", 0.0));
  fields.push_back(number("start_z_mm", text(QT_TRANSLATE_NOOP("thread", "Start, Z")), "mm", 0.0));
  fields.push_back(number("start_angle_deg", text(QT_TRANSLATE_NOOP("thread", "Start angle")), "°", 0.0));
}

void appendPasses(std::vector<Field>& fields) {
  fields.push_back(group(text(QT_TRANSLATE_NOOP("thread", "Passes"))));
  fields.push_back(number("infeed_mm", text(QT_TRANSLATE_NOOP("thread", "Infeed per pass")), "mm", 0.02));
  fields.push_back(choices("infeed_mode", text(QT_TRANSLATE_NOOP("thread", "Infeed along")),
                           {{"radial", text(QT_TRANSLATE_NOOP("thread", "The radius"))},
                            {"flank", text(QT_TRANSLATE_NOOP("thread", "One flank"))},
                            {"alternating", text(QT_TRANSLATE_NOOP("thread", "Both flanks in turn"))}}));
  fields.push_back(number("finishing_passes", text(QT_TRANSLATE_NOOP("thread", "Finishing passes")), "", 0));
  fields.push_back(
      number("finishing_infeed_mm", text(QT_TRANSLATE_NOOP("thread", "Finishing infeed")), "mm", 0.005));
  fields.push_back(number("spark_out_passes", text(QT_TRANSLATE_NOOP("thread", "Spark-out passes")), "", 2));
  fields.push_back(
      number("speed_first_rpm", text(QT_TRANSLATE_NOOP("thread", "Speed, first pass")), "1/min", 10.0));
  fields.push_back(
      number("speed_last_rpm", text(QT_TRANSLATE_NOOP("thread", "Speed, last pass")), "1/min", 40.0));
}

void appendMotion(std::vector<Field>& fields) {
  fields.push_back(group(text(QT_TRANSLATE_NOOP("thread", "Motion"))));
  fields.push_back(choices("direction", text(QT_TRANSLATE_NOOP("thread", "Cuts towards")),
                           {{"plus", text(QT_TRANSLATE_NOOP("thread", "+Z of the work"))},
                            {"minus", text(QT_TRANSLATE_NOOP("thread", "−Z of the work"))}}));
  fields.push_back(number("lead_in_mm", text(QT_TRANSLATE_NOOP("thread", "Lead-in")), "mm", {},
                          text(QT_TRANSLATE_NOOP("thread", "as needed"))));
  fields.push_back(number("run_out_mm", text(QT_TRANSLATE_NOOP("thread", "Run-out")), "mm", {},
                          text(QT_TRANSLATE_NOOP("thread", "as needed"))));
  fields.push_back(number("relief_mm", text(QT_TRANSLATE_NOOP("thread", "Relief")), "mm", {},
                          text(QT_TRANSLATE_NOOP("thread", "as needed"))));
  fields.push_back(number("clearance_mm", text(QT_TRANSLATE_NOOP("thread", "Return clearance")), "mm", 0.5));
  fields.push_back(number("safety_mm", text(QT_TRANSLATE_NOOP("thread", "Safety distance")), "mm", 5.0));
}

void appendWheel(std::vector<Field>& fields) {
  fields.push_back(group(text(QT_TRANSLATE_NOOP("thread", "Wheel"))));
  fields.push_back(number("wheel_diameter_mm", text(QT_TRANSLATE_NOOP("thread", "Diameter")), "mm", {},
                          text(QT_TRANSLATE_NOOP("thread", "as needed"))));
  fields.push_back(number("wheel_width_mm", text(QT_TRANSLATE_NOOP("thread", "Width")), "mm", {},
                          text(QT_TRANSLATE_NOOP("thread", "as needed"))));
  fields.push_back(number("wheel_ribs", text(QT_TRANSLATE_NOOP("thread", "Ribs")), "", 1));
  fields.push_back(number("wheel_tilt_deg", text(QT_TRANSLATE_NOOP("thread", "Tilt")), "°", {},
                          text(QT_TRANSLATE_NOOP("thread", "helix angle"))));
  fields.push_back(
      number("dress_every_passes", text(QT_TRANSLATE_NOOP("thread", "Dress every … passes")), "", 0));
}

void appendProgram(std::vector<Field>& fields) {
  fields.push_back(group(text(QT_TRANSLATE_NOOP("thread", "Program"))));
  fields.push_back(
      number("block_step_deg", text(QT_TRANSLATE_NOOP("thread", "C turn per block")), "°", 15.0));
  fields.push_back(number("decimals", text(QT_TRANSLATE_NOOP("thread", "Decimals")), "", 3));
  fields.push_back(number("program_number", text(QT_TRANSLATE_NOOP("thread", "Program number")), "", 1));
}

}  // namespace

std::vector<Field> threadFields() {
  std::vector<Field> fields;
  appendThread(fields);
  appendPasses(fields);
  appendMotion(fields);
  appendWheel(fields);
  appendProgram(fields);
  return fields;
}

}  // namespace nineline::pages
