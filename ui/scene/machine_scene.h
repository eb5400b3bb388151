#pragma once

#include <vtkActor.h>
#include <vtkAlgorithmOutput.h>
#include <vtkBillboardTextActor3D.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "core/kinematics/chain.h"
#include "ui/scene/path_scene.h"

namespace nineline::scene {

/// The structure of a machine as simple bodies: a slide or a table for each joint with an arrow and its
/// letter, the workpiece and the tool. Bodies are drawn apart along the stacking direction, because machine
/// files place most joints at one point.
class MachineScene {
 public:
  MachineScene();
  [[nodiscard]] vtkRenderer* renderer() const { return renderer_; }
  /// Arrows and letters, drawn over the bodies; a layer above `renderer`.
  [[nodiscard]] vtkRenderer* overlay() const { return overlay_; }
  void setMachine(const kinematics::Machine& machine);
  void setPosition(const kinematics::JointPositions& q);
  void clear();
  void setCamera(CameraPreset preset);

 private:
  /// An actor that travels with a joint's body (−1: the bed).
  struct Part {
    vtkSmartPointer<vtkActor> actor;
    int joint = -1;
    Eigen::Isometry3d T_body;  ///< of the actor in the body's frame
  };
  struct Label {
    vtkSmartPointer<vtkBillboardTextActor3D> actor;
    int joint = -1;
    Eigen::Vector3d place;
  };
  void addChain(int first, int count, const Eigen::Vector3d& stack);
  void addJoint(int joint, const Eigen::Vector3d& at, double size);
  void addArrow(int joint, const Eigen::Vector3d& at, const Eigen::Vector3d& direction, double length);
  void addTool(const Eigen::Vector3d& outward);
  void addWorkpiece(bool turned);
  void addPart(vtkAlgorithmOutput* source, int joint, const Eigen::Isometry3d& T_body, const Colour& colour,
               double opacity = 1.0);

  vtkSmartPointer<vtkRenderer> renderer_;
  vtkSmartPointer<vtkRenderer> overlay_;
  std::vector<Part> parts_;
  std::vector<Label> labels_;
  std::vector<kinematics::Machine> machine_;  // one or none
  double scale_ = 100.0;
  Eigen::Vector3d up_ = Eigen::Vector3d::UnitZ();
};

}  // namespace nineline::scene
