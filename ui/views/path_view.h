#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "core/simulation/simulation.h"
#include "ui/views/scene_view.h"

namespace nineline::scene {
class PathScene;
}

namespace nineline::views {

enum class Camera { Isometric, Front, Top, Side };

/// The tool path in 3D.
class PathView : public SceneView {
  Q_OBJECT

 public:
  explicit PathView(QWidget* parent = nullptr);
  ~PathView() override;
  /// Keeps the samples; `after` may be empty.
  void setPaths(std::vector<simulation::PathSample> before, std::vector<simulation::PathSample> after);
  void setShown(bool ideal, bool before, bool after);
  void setMagnification(double factor);
  [[nodiscard]] double suggestedMagnification() const;
  void setCamera(Camera camera);
  void markLine(std::size_t line);

 signals:
  /// A place of the path was chosen (both samples at that place; `after` null while there is none).
  void picked(const nineline::simulation::PathSample* before, const nineline::simulation::PathSample* after);

 private:
  void pickAt(double x, double y);
  std::unique_ptr<scene::PathScene> scene_;
  std::vector<simulation::PathSample> before_, after_;
};

}  // namespace nineline::views
