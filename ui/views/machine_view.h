#pragma once

#include <memory>

#include "core/kinematics/machine.h"
#include "ui/views/path_view.h"
#include "ui/views/scene_view.h"

namespace nineline::scene {
class MachineScene;
}

namespace nineline::views {

/// The structure of a machine in 3D.
class MachineView : public SceneView {
  Q_OBJECT

 public:
  explicit MachineView(QWidget* parent = nullptr);
  ~MachineView() override;
  void setMachine(const kinematics::Machine* machine);
  void setPosition(const kinematics::JointPositions& q);
  void setCamera(Camera camera);

 private:
  std::unique_ptr<scene::MachineScene> scene_;
};

}  // namespace nineline::views
