#pragma once

#include <vtkLookupTable.h>
#include <vtkSmartPointer.h>

#include <array>

namespace nineline::scene {

using Colour = std::array<double, 3>;

/// Colours that stay apart for people who see colours differently.
inline constexpr Colour kBefore{0.835, 0.369, 0.0};
inline constexpr Colour kAfter{0.0, 0.447, 0.698};
inline constexpr Colour kIdeal{0.38, 0.42, 0.46};
inline constexpr Colour kMark{0.8, 0.1, 0.45};
inline constexpr Colour kInk{0.13, 0.17, 0.21};

/// From dark violet over green to yellow: lightness grows evenly with the value.
[[nodiscard]] vtkSmartPointer<vtkLookupTable> makeColourMap(double low, double high);

}  // namespace nineline::scene
