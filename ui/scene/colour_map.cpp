#include "ui/scene/colour_map.h"

#include <vtkColorTransferFunction.h>

namespace nineline::scene {

namespace {

constexpr int kColours = 256;
/// Control points at equal distances; even in lightness, checked by eye and for red-green blindness.
constexpr std::array<Colour, 6> kPoints = {Colour{0.27, 0.02, 0.35}, Colour{0.25, 0.27, 0.53},
                                           Colour{0.16, 0.47, 0.56}, Colour{0.13, 0.66, 0.51},
                                           Colour{0.48, 0.82, 0.32}, Colour{0.95, 0.88, 0.14}};

}  // namespace

vtkSmartPointer<vtkLookupTable> makeColourMap(double low, double high) {
  vtkNew<vtkColorTransferFunction> function;
  for (std::size_t i = 0; i < kPoints.size(); ++i) {
    const double at = static_cast<double>(i) / static_cast<double>(kPoints.size() - 1);
    function->AddRGBPoint(at, kPoints[i][0], kPoints[i][1], kPoints[i][2]);
  }
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(kColours);
  table->SetRange(low, high > low ? high : low + 1.0);
  for (int i = 0; i < kColours; ++i) {
    Colour colour{};
    function->GetColor(static_cast<double>(i) / (kColours - 1), colour.data());
    table->SetTableValue(i, colour[0], colour[1], colour[2], 1.0);
  }
  return table;
}

}  // namespace nineline::scene
