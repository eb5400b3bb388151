#include "ui/scene/machine_scene.h"

#include <vtkArrowSource.h>
#include <vtkCamera.h>
#include <vtkCubeSource.h>
#include <vtkCylinderSource.h>
#include <vtkMatrix4x4.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTextProperty.h>
#include <vtkTransform.h>

#include <algorithm>
#include <cmath>

namespace nineline::scene {

namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using kinematics::Machine;

constexpr Colour kWorkSide{0.45, 0.62, 0.78};
constexpr Colour kToolSide{0.93, 0.68, 0.38};
constexpr Colour kBed{0.80, 0.82, 0.84};
constexpr Colour kWorkpiece{0.78, 0.80, 0.83};
constexpr Colour kTool{0.55, 0.35, 0.20};
constexpr double kSmallest = 60.0;  // mm
constexpr double kLargest = 260.0;  // mm
constexpr double kParallel = 0.99;

/// The rotation that turns the y axis (VTK's cylinders) or the x axis (its arrows) into a direction.
Isometry3d turnedFrom(const Vector3d& from, const Vector3d& to, const Vector3d& at) {
  Isometry3d T = Isometry3d::Identity();
  T.linear() = Eigen::Quaterniond::FromTwoVectors(from, to).toRotationMatrix();
  T.translation() = at;
  return T;
}

double scaleOf(const Machine& machine) {
  double span = 0.0;
  for (const kinematics::Joint& joint : machine.joints()) {
    if (joint.type == kinematics::JointType::Linear && joint.travel) {
      span = std::max(span, joint.travel->high - joint.travel->low);
    }
  }
  return span > 0.0 ? std::clamp(span / 5.0, kSmallest, kLargest) : 120.0;
}

/// Work turns about the direction along which the table slides: a grinder or a lathe, not a mill.
bool isTurning(const Machine& machine) {
  for (int r = 0; r < machine.workpieceJointCount(); ++r) {
    if (!machine.isRotary(r)) continue;
    for (int l = 0; l < machine.workpieceJointCount(); ++l) {
      if (!machine.isRotary(l) &&
          std::abs(machine.joint(l).direction.dot(machine.joint(r).direction)) > kParallel) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace

MachineScene::MachineScene()
    : renderer_(vtkSmartPointer<vtkRenderer>::New()), overlay_(vtkSmartPointer<vtkRenderer>::New()) {
  overlay_->SetLayer(1);
  overlay_->InteractiveOff();
  overlay_->SetActiveCamera(renderer_->GetActiveCamera());
  renderer_->SetBackground(1.0, 1.0, 1.0);
  renderer_->SetBackground2(0.86, 0.89, 0.92);
  renderer_->GradientBackgroundOn();
}

void MachineScene::clear() {
  renderer_->RemoveAllViewProps();
  overlay_->RemoveAllViewProps();
  parts_.clear();
  labels_.clear();
  machine_.clear();
}

void MachineScene::addPart(vtkAlgorithmOutput* source, int joint, const Isometry3d& T_body,
                           const Colour& colour, double opacity) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
  actor->GetProperty()->SetOpacity(opacity);
  actor->GetProperty()->SetInterpolationToPhong();
  actor->GetProperty()->SetSpecular(0.2);
  renderer_->AddActor(actor);
  parts_.push_back({actor, joint, T_body});
}

void MachineScene::addArrow(int joint, const Vector3d& at, const Vector3d& direction, double length) {
  vtkNew<vtkArrowSource> arrow;
  arrow->SetShaftRadius(0.035);
  arrow->SetTipRadius(0.1);
  arrow->SetTipLength(0.25);
  Isometry3d T = turnedFrom(Vector3d::UnitX(), direction, at);
  addPart(arrow->GetOutputPort(), joint, T, kInk);
  parts_.back().actor->SetScale(length);
  renderer_->RemoveActor(parts_.back().actor);
  overlay_->AddActor(parts_.back().actor);
  Label label{vtkSmartPointer<vtkBillboardTextActor3D>::New(), joint, at + direction * length * 1.12};
  label.actor->SetInput(machine_.front().joint(joint).axis.text().c_str());
  label.actor->GetTextProperty()->SetFontSize(24);
  label.actor->GetTextProperty()->SetBold(1);
  label.actor->GetTextProperty()->SetColor(kInk[0], kInk[1], kInk[2]);
  label.actor->GetTextProperty()->SetJustificationToCentered();
  label.actor->GetTextProperty()->SetVerticalJustificationToCentered();
  overlay_->AddActor(label.actor);
  labels_.push_back(label);
}

void MachineScene::addJoint(int index, const Vector3d& at, double size) {
  const kinematics::Joint& joint = machine_.front().joint(index);
  const Colour& colour = machine_.front().side(index) == kinematics::Side::Workpiece ? kWorkSide : kToolSide;
  const Vector3d d = joint.direction;
  if (joint.type == kinematics::JointType::Rotary) {
    vtkNew<vtkCylinderSource> disc;
    disc->SetRadius(0.48 * size);
    disc->SetHeight(0.3 * size);
    disc->SetResolution(48);
    addPart(disc->GetOutputPort(), index, turnedFrom(Vector3d::UnitY(), d, at), colour);
  } else {
    vtkNew<vtkCubeSource> slide;
    slide->SetXLength(1.3 * size);

    slide->SetYLength(0.45 * size);
    slide->SetZLength(0.45 * size);
    addPart(slide->GetOutputPort(), index, turnedFrom(Vector3d::UnitX(), d, at), colour);
  }
  const bool rotary = joint.type == kinematics::JointType::Rotary;
  const bool parallel = std::abs(up_.dot(d)) > kParallel;
  const Vector3d aside = parallel ? d.unitOrthogonal() : (up_ - d * up_.dot(d)).normalized();
  // Out of the body, and out of what stands on it where the arrow runs along the stack.
  const double out = parallel ? 0.55 : (rotary ? 0.0 : 0.32);
  const Vector3d over = aside * out * size;
  addArrow(index, at + over + d * (rotary ? 0.15 : 0.35) * size, d, (rotary ? 1.1 : 0.9) * size);
}

void MachineScene::addChain(int first, int count, const Vector3d& stack) {
  for (int i = 0; i < count; ++i) {
    const double depth = static_cast<double>(count - i);
    const Vector3d at = stack * (0.55 * scale_ * depth);
    addJoint(first + i, at, scale_ * (0.75 + 0.15 * depth));
  }
}

void MachineScene::addWorkpiece(bool turned) {
  const Machine& machine = machine_.front();
  const int last = machine.workpieceJointCount() - 1;
  if (turned) {
    vtkNew<vtkCylinderSource> bar;
    bar->SetRadius(0.2 * scale_);
    bar->SetHeight(1.6 * scale_);
    bar->SetResolution(48);
    addPart(bar->GetOutputPort(), last,
            turnedFrom(Vector3d::UnitY(), machine.joint(last).direction, {0, 0, 0}), kWorkpiece);
    return;
  }
  vtkNew<vtkCubeSource> block;
  block->SetXLength(0.5 * scale_);
  block->SetYLength(0.5 * scale_);
  block->SetZLength(0.3 * scale_);
  Isometry3d T = Isometry3d::Identity();
  T.translation() = -0.15 * scale_ * machine.toolAxis();
  addPart(block->GetOutputPort(), last, T, kWorkpiece);
}

void MachineScene::addTool(const Vector3d& outward) {
  const Machine& machine = machine_.front();
  const int last = machine.jointCount() - 1;
  const int body = machine.workpieceJointCount() < machine.jointCount() ? last : -1;
  const bool wheel = std::abs(outward.dot(machine.toolAxis())) < 0.5;
  vtkNew<vtkCylinderSource> tool;
  tool->SetResolution(64);
  tool->SetRadius(wheel ? 0.6 * scale_ : 0.08 * scale_);
  tool->SetHeight(wheel ? 0.12 * scale_ : 0.55 * scale_);
  const double away = wheel ? 0.6 * scale_ : 0.275 * scale_;
  addPart(tool->GetOutputPort(), body,
          turnedFrom(Vector3d::UnitY(), machine.toolAxis(), machine.toolTip() + outward * away), kTool);
}

void MachineScene::setMachine(const Machine& machine) {
  const bool known = !machine_.empty();
  const Vector3d up_before = up_;
  clear();
  machine_.push_back(machine);
  scale_ = scaleOf(machine);
  const bool turning = isTurning(machine);
  const Vector3d down = turning ? Vector3d(0.0, -1.0, 0.0) : Vector3d(-machine.toolAxis());
  up_ = -down;
  const Vector3d outward = turning ? Vector3d(1.0, 0.0, 0.0) : machine.toolAxis();
  const int work = machine.workpieceJointCount();
  addChain(0, work, down);
  addChain(work, machine.jointCount() - work, outward * (turning ? 1.6 : 1.9));
  if (work > 0) addWorkpiece(turning);
  addTool(outward);
  Vector3d centre = Vector3d::Zero();
  const kinematics::BodyPoses poses = kinematics::bodyPoses(machine, {});
  for (int joint = 0; joint < machine.jointCount(); ++joint) {
    centre += poses[static_cast<std::size_t>(joint)].translation() / machine.jointCount();
  }
  centre -= down * down.dot(centre);
  vtkNew<vtkCubeSource> bed;
  bed->SetXLength(4.2 * scale_);
  bed->SetYLength(3.2 * scale_);
  bed->SetZLength(0.15 * scale_);
  addPart(bed->GetOutputPort(), -1,
          turnedFrom(Vector3d::UnitZ(), -down,
                     centre + down * (0.55 * scale_ * (static_cast<double>(work) + 1.0))),
          kBed);
  setPosition({});
  if (!known || !up_.isApprox(up_before)) setCamera(CameraPreset::Isometric);
  renderer_->ResetCamera();
}

void MachineScene::setPosition(const kinematics::JointPositions& q) {
  if (machine_.empty()) return;
  const kinematics::BodyPoses poses = kinematics::bodyPoses(machine_.front(), q);
  const auto poseOf = [&poses](int joint) {
    return joint < 0 ? Isometry3d::Identity() : poses[static_cast<std::size_t>(joint)];
  };
  for (const Part& part : parts_) {
    const Isometry3d T = poseOf(part.joint) * part.T_body;
    vtkNew<vtkMatrix4x4> matrix;
    for (int row = 0; row < 4; ++row) {
      for (int column = 0; column < 4; ++column) matrix->SetElement(row, column, T(row, column));
    }
    part.actor->SetUserMatrix(matrix);
  }
  for (const Label& label : labels_) {
    const Vector3d p = poseOf(label.joint) * label.place;
    label.actor->SetPosition(p.x(), p.y(), p.z());
  }
  renderer_->ResetCameraClippingRange();
}

void MachineScene::setCamera(CameraPreset preset) {
  const bool turning = !machine_.empty() && isTurning(machine_.front());
  vtkCamera* camera = renderer_->GetActiveCamera();
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  const Vector3d up = turning ? Vector3d::UnitY() : Vector3d::UnitZ();
  const Vector3d right = turning ? Vector3d::UnitZ() : Vector3d::UnitX();
  const Vector3d front = right.cross(up);
  Vector3d from = front;
  Vector3d above = up;
  if (preset == CameraPreset::Isometric) from = (front + 0.7 * up + 0.6 * right);
  if (preset == CameraPreset::Side) from = right;
  if (preset == CameraPreset::Top) {
    from = up;
    above = -front;
  }
  camera->SetPosition(from.x(), from.y(), from.z());
  camera->SetViewUp(above.x(), above.y(), above.z());
  renderer_->ResetCamera();
}

}  // namespace nineline::scene
