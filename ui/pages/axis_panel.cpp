#include "ui/pages/axis_panel.h"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>
#include <cmath>

#include "core/base/units.h"
#include "ui/models/component_names.h"

namespace nineline::pages {

namespace {

constexpr int kSliderSteps = 2000;
constexpr double kUnlimited_mm = 500.0;
constexpr double kUnlimited_deg = 360.0;

struct Range {
  double low, high;  // mm, deg
};

Range rangeOf(const kinematics::Machine& machine, int joint) {
  const auto& travel = machine.joint(joint).travel;
  const bool rotary = machine.isRotary(joint);
  if (!travel) return rotary ? Range{-kUnlimited_deg, kUnlimited_deg} : Range{-kUnlimited_mm, kUnlimited_mm};
  return rotary ? Range{degFromRad(travel->low), degFromRad(travel->high)} : Range{travel->low, travel->high};
}

}  // namespace

AxisPanel::AxisPanel(QWidget* parent) : QScrollArea(parent) {
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
}

void AxisPanel::setMachine(const kinematics::Machine& machine) {
  machine_ = machine;
  q_ = {};
  auto* body = new QWidget(this);
  auto* form = new QFormLayout(body);
  form->setVerticalSpacing(10);
  for (int joint = 0; joint < machine.jointCount(); ++joint) addAxis(form, joint);
  auto* home = new QPushButton(tr("All axes to zero"), body);
  connect(home, &QPushButton::clicked, this, [this]() {
    setMachine(kinematics::Machine(*machine_));
    emit moved(q_);
  });
  form->addRow(home);
  setWidget(body);
}

void AxisPanel::addAxis(QFormLayout* form, int joint) {
  const Range range = rangeOf(*machine_, joint);
  auto* box = new QDoubleSpinBox(this);
  box->setRange(range.low, range.high);
  box->setDecimals(3);
  box->setSuffix(QLatin1Char(' ') + models::positionUnitOf(*machine_, joint));
  box->setValue(std::clamp(0.0, range.low, range.high));
  box->setAlignment(Qt::AlignRight);
  auto* slider = new QSlider(Qt::Horizontal, this);
  slider->setRange(0, kSliderSteps);
  const auto stepOf = [range](double value) {
    return static_cast<int>(std::lround((value - range.low) / (range.high - range.low) * kSliderSteps));
  };
  slider->setValue(stepOf(box->value()));
  connect(slider, &QSlider::valueChanged, box, [box, range](int step) {
    box->setValue(range.low + (range.high - range.low) * step / kSliderSteps);
  });
  connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
          [this, joint, slider, stepOf](double value) {
            const QSignalBlocker blocker(slider);
            slider->setValue(stepOf(value));
            q_[static_cast<std::size_t>(joint)] = machine_->isRotary(joint) ? radFromDeg(value) : value;
            emit moved(q_);
          });
  auto* label = new QLabel(QString::fromStdString(machine_->joint(joint).axis.text()), this);
  label->setObjectName(QStringLiteral("axisLetter"));
  auto* row = new QWidget(this);
  auto* layout = new QVBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(box);
  layout->addWidget(slider);
  form->addRow(label, row);
}

}  // namespace nineline::pages
