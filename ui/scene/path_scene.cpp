#include "ui/scene/path_scene.h"

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace nineline::scene {

namespace {

using simulation::PathSample;

constexpr float kThin = 1.0F;
constexpr float kMedium = 2.0F;
constexpr float kThick = 5.0F;
constexpr float kDot = 14.0F;
constexpr double kPickRadius = 14.0;        // pixels
constexpr double kVisibleDeviation = 0.05;  // of the path's size

vtkSmartPointer<vtkPolyData> emptyData() { return vtkSmartPointer<vtkPolyData>::New(); }

}  // namespace

PathScene::PathScene()
    : renderer_(vtkSmartPointer<vtkRenderer>::New()),
      ideal_(emptyData()),
      rapid_(emptyData()),
      before_(emptyData()),
      after_(emptyData()),
      line_(emptyData()),
      point_(emptyData()),
      bar_(vtkSmartPointer<vtkScalarBarActor>::New()) {
  renderer_->SetBackground(1.0, 1.0, 1.0);
  renderer_->SetBackground2(0.86, 0.89, 0.92);
  renderer_->GradientBackgroundOn();
  rapid_actor_ = addActor(rapid_, {0.72, 0.75, 0.78}, kThin);
  ideal_actor_ = addActor(ideal_, kIdeal, kThin);
  before_actor_ = addActor(before_, kBefore, kMedium);
  after_actor_ = addActor(after_, kAfter, kMedium);
  line_actor_ = addActor(line_, kMark, kThick);
  point_actor_ = addActor(point_, kMark, kThick);
  point_actor_->GetProperty()->SetPointSize(kDot);
  point_actor_->GetProperty()->SetRenderPointsAsSpheres(true);
  bar_->SetTitle("\xC2\xB5m");
  bar_->SetNumberOfLabels(5);
  bar_->SetLabelFormat("%.3g");
  bar_->SetMaximumWidthInPixels(70);
  bar_->SetPosition(0.9, 0.2);
  bar_->SetHeight(0.6);
  bar_->UnconstrainedFontSizeOn();
  for (vtkTextProperty* text : {bar_->GetTitleTextProperty(), bar_->GetLabelTextProperty()}) {
    text->SetColor(kInk[0], kInk[1], kInk[2]);
    text->SetFontSize(14);
    text->SetBold(0);
    text->SetItalic(0);
    text->ShadowOff();
  }
  bar_->VisibilityOff();
  renderer_->AddActor2D(bar_);
}

vtkSmartPointer<vtkActor> PathScene::addActor(vtkPolyData* data, const Colour& colour, float width) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
  actor->GetProperty()->SetLineWidth(width);
  actor->GetProperty()->LightingOff();
  renderer_->AddActor(actor);
  return actor;
}

Eigen::Vector3d PathScene::place(const PathSample& sample, double factor) const {
  return sample.ideal.tip + factor * sample.deviation.tip;
}

void PathScene::build(vtkPolyData* data, std::span<const PathSample> samples, double factor,
                      bool rapids) const {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkDoubleArray> deviation_um;
  points->SetDataTypeToDouble();
  bool open = false;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const PathSample& sample = samples[i];
    if (sample.rapid != rapids) {
      open = false;
      continue;
    }
    if (!open && i > 0) {
      const Eigen::Vector3d p = place(samples[i - 1], factor);
      points->InsertNextPoint(p.data());
      deviation_um->InsertNextValue(umFromMm(samples[i - 1].deviation.tip.norm()));
      open = true;
    }
    const Eigen::Vector3d p = place(sample, factor);
    const vtkIdType id = points->InsertNextPoint(p.data());
    deviation_um->InsertNextValue(umFromMm(sample.deviation.tip.norm()));
    if (open) {
      const vtkIdType ends[2] = {id - 1, id};
      lines->InsertNextCell(2, ends);
    }
    open = true;
  }
  data->Initialize();
  data->SetPoints(points);
  data->SetLines(lines);
  data->GetPointData()->SetScalars(deviation_um);
  data->Modified();
}

void PathScene::setPaths(std::span<const PathSample> before, std::span<const PathSample> after) {
  before_samples_ = before;
  after_samples_ = after;
  markSample(std::nullopt);
  rebuild();
}

void PathScene::setMagnification(double factor) {
  factor_ = factor;
  rebuild();
}

void PathScene::setShown(const Shown& shown) {
  shown_ = shown;
  ideal_actor_->SetVisibility(shown.ideal);
  rapid_actor_->SetVisibility(shown.rapids && shown.ideal);
  before_actor_->SetVisibility(shown.before);
  after_actor_->SetVisibility(shown.after);
  rebuildColours();
}

void PathScene::rebuild() {
  build(ideal_, before_samples_, 0.0, false);
  build(rapid_, before_samples_, 0.0, true);
  build(before_, before_samples_, factor_, false);
  build(after_, after_samples_, factor_, false);
  rebuildColours();
  markLine(marked_line_);
}

void PathScene::rebuildColours() {
  double largest_um = 0.0;
  const auto widen = [&largest_um](std::span<const PathSample> samples) {
    for (const PathSample& sample : samples) {
      if (!sample.rapid) largest_um = std::max(largest_um, umFromMm(sample.deviation.tip.norm()));
    }
  };
  if (shown_.before) widen(before_samples_);
  if (shown_.after) widen(after_samples_);
  const bool coloured = largest_um > 0.0;
  const auto colours = makeColourMap(0.0, largest_um);
  for (vtkActor* actor : {before_actor_.Get(), after_actor_.Get()}) {
    auto* mapper = vtkPolyDataMapper::SafeDownCast(actor->GetMapper());
    mapper->SetScalarVisibility(coloured);
    mapper->SetLookupTable(colours);
    mapper->SetUseLookupTableScalarRange(true);
  }
  bar_->SetLookupTable(colours);
  bar_->SetVisibility(coloured);
}

void PathScene::markLine(std::size_t line) {
  marked_line_ = line;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  points->SetDataTypeToDouble();
  for (std::size_t i = 1; line != 0 && i < before_samples_.size(); ++i) {
    if (before_samples_[i].line != line) continue;
    const vtkIdType first = points->InsertNextPoint(before_samples_[i - 1].ideal.tip.data());
    const vtkIdType ends[2] = {first, points->InsertNextPoint(before_samples_[i].ideal.tip.data())};
    lines->InsertNextCell(2, ends);
  }
  line_->Initialize();
  line_->SetPoints(points);
  line_->SetLines(lines);
  line_->Modified();
}

void PathScene::markSample(const std::optional<Picked>& picked) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> dots;
  points->SetDataTypeToDouble();
  if (picked) {
    const auto& samples = picked->after ? after_samples_ : before_samples_;
    const Eigen::Vector3d p = place(samples[picked->sample], factor_);
    const vtkIdType id = points->InsertNextPoint(p.data());
    dots->InsertNextCell(1, &id);
  }
  point_->Initialize();
  point_->SetPoints(points);
  point_->SetVerts(dots);
  point_->Modified();
}

std::optional<PathScene::Picked> PathScene::pick(double x, double y) const {
  std::optional<Picked> best;
  double nearest = kPickRadius;
  const auto search = [&](std::span<const PathSample> samples, bool after) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const Eigen::Vector3d p = place(samples[i], factor_);
      renderer_->SetWorldPoint(p.x(), p.y(), p.z(), 1.0);
      renderer_->WorldToDisplay();
      const double* at = renderer_->GetDisplayPoint();
      const double distance = std::hypot(at[0] - x, at[1] - y);
      if (distance >= nearest) continue;
      nearest = distance;
      best = Picked{after, i};
    }
  };
  if (shown_.after) search(after_samples_, true);
  if (shown_.before || shown_.ideal) search(before_samples_, false);
  return best;
}

double PathScene::suggestedMagnification() const {
  double largest = 0.0;
  Eigen::AlignedBox3d box;
  for (const PathSample& sample : before_samples_) {
    if (sample.rapid) continue;
    largest = std::max(largest, sample.deviation.tip.norm());
    box.extend(sample.ideal.tip);
  }
  if (largest <= 0.0 || box.isEmpty()) return 1.0;
  const double wanted = kVisibleDeviation * box.diagonal().norm() / largest;
  if (wanted <= 1.0) return 1.0;
  const double decade = std::pow(10.0, std::floor(std::log10(wanted)));
  const double lead = wanted / decade;
  return (lead >= 5.0 ? 5.0 : (lead >= 2.0 ? 2.0 : 1.0)) * decade;
}

void PathScene::setCamera(CameraPreset preset) {
  vtkCamera* camera = renderer_->GetActiveCamera();
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  switch (preset) {
    case CameraPreset::Isometric:
      camera->SetPosition(1.0, -1.2, 0.8);
      break;
    case CameraPreset::Front:
      camera->SetPosition(0.0, -1.0, 0.0);
      break;
    case CameraPreset::Side:
      camera->SetPosition(1.0, 0.0, 0.0);
      break;
    case CameraPreset::Top:
      camera->SetPosition(0.0, 0.0, 1.0);
      camera->SetViewUp(0.0, 1.0, 0.0);
      break;
  }
  // What cuts fills the window; rapids may reach out of it.
  double bounds[6];
  if (ideal_->GetNumberOfPoints() > 0) {
    ideal_->GetBounds(bounds);
    const double margin =
        0.05 * std::max({bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]});
    for (int i = 0; i < 3; ++i) {
      bounds[2 * i] -= margin;
      bounds[2 * i + 1] += margin;
    }
    renderer_->ResetCamera(bounds);
  } else {
    renderer_->ResetCamera();
  }
  renderer_->ResetCameraClippingRange();
}

}  // namespace nineline::scene
