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
enum class Role { Before, After, Nodes, Curve, DotsBefore, DotsAfter };

struct Curve {
  Role role = Role::Curve;
  std::vector<double> x;
  std::vector<double> y;
};

/// A rectangle drawn with the curves: what the repeatability explains, or the place of a gap.
struct Frame {
  enum class Meaning { Repeatability, Place };
  Meaning meaning = Meaning::Repeatability;
  double x_low = 0.0, x_high = 0.0;
  double y_low = 0.0, y_high = 0.0;
};

/// Curves over one variable, drawn by VTK. Axis titles are names and units ("Z / mm").
class ChartView : public SceneView {
  Q_OBJECT

 public:
  explicit ChartView(QWidget* parent = nullptr);
  ~ChartView() override;
  void show(const QString& x_title, const QString& y_title, std::vector<Curve> curves,
            const std::vector<Frame>& frames = {});
  /// The colour of a role as text for a legend, "#0072b2".
  [[nodiscard]] static QString colourOf(Role role);

 private:
  std::unique_ptr<scene::CurveChart> chart_;
};

}  // namespace nineline::views
