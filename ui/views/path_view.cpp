#include "ui/views/path_view.h"

#include "ui/scene/path_scene.h"

namespace nineline::views {

PathView::PathView(QWidget* parent) : SceneView(parent), scene_(std::make_unique<scene::PathScene>()) {
  addRenderer(scene_->renderer());
  connect(this, &SceneView::clicked, this, &PathView::pickAt);
}

PathView::~PathView() = default;

void PathView::setPaths(std::vector<simulation::PathSample> before,
                        std::vector<simulation::PathSample> after) {
  scene_->setPaths({}, {});
  before_ = std::move(before);
  after_ = std::move(after);
  scene_->setPaths(before_, after_);
  setCamera(Camera::Isometric);
}

void PathView::setShown(bool ideal, bool before, bool after) {
  scene_->setShown({ideal, before, after, ideal});
  redraw();
}

void PathView::setMagnification(double factor) {
  scene_->setMagnification(factor);
  redraw();
}

double PathView::suggestedMagnification() const { return scene_->suggestedMagnification(); }

void PathView::setCamera(Camera camera) {
  scene_->setCamera(static_cast<scene::CameraPreset>(camera));
  redraw();
}

void PathView::markLine(std::size_t line) {
  scene_->markLine(line);
  redraw();
}

void PathView::pickAt(double x, double y) {
  const auto found = scene_->pick(x, y);
  scene_->markSample(found);
  redraw();
  if (!found) return;
  const std::size_t at = found->sample;
  emit picked(at < before_.size() ? &before_[at] : nullptr, at < after_.size() ? &after_[at] : nullptr);
}

}  // namespace nineline::views
