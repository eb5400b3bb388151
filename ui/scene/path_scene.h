#pragma once

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkScalarBarActor.h>
#include <vtkSmartPointer.h>

#include <optional>
#include <span>
#include <vector>

#include "core/simulation/simulation.h"
#include "ui/scene/colour_map.h"

namespace nineline::scene {

enum class CameraPreset { Isometric, Front, Top, Side };

/// A tool path in the workpiece frame: the ideal path, and the actual ones before and after compensation with
/// their deviation magnified and coloured in µm.
class PathScene {
 public:
  struct Shown {
    bool ideal = true;
    bool before = true;
    bool after = true;
    bool rapids = true;
  };
  /// What lies under a picked place: the path and the index of its sample.
  struct Picked {
    bool after = false;
    std::size_t sample = 0;
  };

  PathScene();
  [[nodiscard]] vtkRenderer* renderer() const { return renderer_; }

  /// The samples must outlive the scene's use of them; `after` may be empty.
  void setPaths(std::span<const simulation::PathSample> before,
                std::span<const simulation::PathSample> after);
  void setMagnification(double factor);
  void setShown(const Shown& shown);
  void setCamera(CameraPreset preset);
  /// Marks the motions of one line of the program; 0 marks nothing.
  void markLine(std::size_t line);
  void markSample(const std::optional<Picked>& picked);
  /// The sample nearest to a place of the window (pixels from the lower left).
  [[nodiscard]] std::optional<Picked> pick(double x, double y) const;
  /// A factor that makes the largest deviation a visible part of the path's size.
  [[nodiscard]] double suggestedMagnification() const;

 private:
  [[nodiscard]] Eigen::Vector3d place(const simulation::PathSample& sample, double factor) const;
  void rebuild();
  void rebuildColours();
  void build(vtkPolyData* data, std::span<const simulation::PathSample> samples, double factor,
             bool rapids) const;
  vtkSmartPointer<vtkActor> addActor(vtkPolyData* data, const Colour& colour, float width);

  vtkSmartPointer<vtkRenderer> renderer_;
  vtkSmartPointer<vtkPolyData> ideal_, rapid_, before_, after_, line_, point_;
  vtkSmartPointer<vtkActor> ideal_actor_, rapid_actor_, before_actor_, after_actor_, line_actor_,
      point_actor_;
  vtkSmartPointer<vtkScalarBarActor> bar_;
  std::span<const simulation::PathSample> before_samples_, after_samples_;
  double factor_ = 1.0;
  Shown shown_;
  std::size_t marked_line_ = 0;
};

}  // namespace nineline::scene
