#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ui/views/scene_view.h"

namespace nineline::scene {
class CurveChart;
}

namespace nineline::views {

/// What a curve stands for; decides its colour.
enum class Role { Before, After, Nodes, Curve };

struct Curve {
  Role role = Role::Curve;
  std::vector<double> x;
  std::vector<double> y;
};

/// Curves over one variable, drawn by VTK. Axis titles are names and units ("Z / mm").
class ChartView : public SceneView {
  Q_OBJECT

 public:
  explicit ChartView(QWidget* parent = nullptr);
  ~ChartView() override;
  void show(const QString& x_title, const QString& y_title, std::vector<Curve> curves);
  /// The colour of a role as text for a legend, "#0072b2".
  [[nodiscard]] static QString colourOf(Role role);

 private:
  std::unique_ptr<scene::CurveChart> chart_;
};

}  // namespace nineline::views
