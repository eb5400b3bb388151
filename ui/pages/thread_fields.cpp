#include "ui/pages/thread_fields.h"

#include <QCoreApplication>

namespace nineline::pages {

namespace {

using widgets::Field;

QString tr(const char* text) { return QCoreApplication::translate("thread", text); }

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
  fields.push_back(group(tr("Thread")));
  fields.push_back(number("diameter_mm", tr("Nominal diameter"), "mm"));
  fields.push_back(number("pitch_mm", tr("Pitch"), "mm"));
  fields.push_back(number("length_mm", tr("Length"), "mm"));
  fields.push_back(number("starts", tr("Starts"), "", 1));
  fields.push_back(choices("hand", tr("Hand"), {{"right", tr("Right")}, {"left", tr("Left")}}));
  fields.push_back(choices("type", tr("Kind"), {{"external", tr("External")}, {"internal", tr("Internal")}}));
  fields.push_back(number("depth_mm", tr("Depth"), "mm", {}, tr("ISO 68-1")));
  fields.push_back(number("taper_1", tr("Taper, radius per length"), "mm/mm", 0.0));
  fields.push_back(number("start_z_mm", tr("Start, Z"), "mm", 0.0));
  fields.push_back(number("start_angle_deg", tr("Start angle"), "°", 0.0));
}

void appendPasses(std::vector<Field>& fields) {
  fields.push_back(group(tr("Passes")));
  fields.push_back(number("infeed_mm", tr("Infeed per pass"), "mm", 0.02));
  fields.push_back(choices("infeed_mode", tr("Infeed along"),
                           {{"radial", tr("The radius")},
                            {"flank", tr("One flank")},
                            {"alternating", tr("Both flanks in turn")}}));
  fields.push_back(number("finishing_passes", tr("Finishing passes"), "", 0));
  fields.push_back(number("finishing_infeed_mm", tr("Finishing infeed"), "mm", 0.005));
  fields.push_back(number("spark_out_passes", tr("Spark-out passes"), "", 2));
  fields.push_back(number("speed_first_rpm", tr("Work speed, first pass"), "1/min", 10.0));
  fields.push_back(number("speed_last_rpm", tr("Work speed, last pass"), "1/min", 40.0));
}

void appendMotion(std::vector<Field>& fields) {
  fields.push_back(group(tr("Motion")));
  fields.push_back(choices("direction", tr("Cuts towards"),
                           {{"plus", tr("+Z of the work")}, {"minus", tr("−Z of the work")}}));
  fields.push_back(number("lead_in_mm", tr("Lead-in"), "mm", {}, tr("as needed")));
  fields.push_back(number("run_out_mm", tr("Run-out"), "mm", {}, tr("as needed")));
  fields.push_back(number("relief_mm", tr("Relief before the return"), "mm", {}, tr("as needed")));
  fields.push_back(number("clearance_mm", tr("Clearance while returning"), "mm", 0.5));
  fields.push_back(number("safety_mm", tr("Safety distance"), "mm", 5.0));
}

void appendWheel(std::vector<Field>& fields) {
  fields.push_back(group(tr("Wheel")));
  fields.push_back(number("wheel_diameter_mm", tr("Diameter"), "mm", {}, tr("as needed")));
  fields.push_back(number("wheel_width_mm", tr("Width"), "mm", {}, tr("as needed")));
  fields.push_back(number("wheel_ribs", tr("Ribs"), "", 1));
  fields.push_back(number("wheel_tilt_deg", tr("Tilt"), "°", {}, tr("helix angle")));
  fields.push_back(number("dress_every_passes", tr("Dress every … passes"), "", 0));
}

void appendProgram(std::vector<Field>& fields) {
  fields.push_back(group(tr("Program")));
  fields.push_back(number("block_step_deg", tr("Turn of C for each block"), "°", 15.0));
  fields.push_back(number("decimals", tr("Decimals"), "", 3));
  fields.push_back(number("program_number", tr("Program number"), "", 1));
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
