#include "ui/views/machine_view.h"

#include "ui/scene/machine_scene.h"

namespace nineline::views {

MachineView::MachineView(QWidget* parent)
    : SceneView(parent), scene_(std::make_unique<scene::MachineScene>()) {
  addRenderer(scene_->renderer());
  addOverlay(scene_->overlay());
}

MachineView::~MachineView() = default;

void MachineView::setMachine(const kinematics::Machine* machine) {
  if (machine == nullptr) {
    scene_->clear();
  } else {
    scene_->setMachine(*machine);
  }
  redraw();
}

void MachineView::setPosition(const kinematics::JointPositions& q) {
  scene_->setPosition(q);
  redraw();
}

void MachineView::setCamera(Camera camera) {
  scene_->setCamera(static_cast<scene::CameraPreset>(camera));
  redraw();
}

}  // namespace nineline::views
