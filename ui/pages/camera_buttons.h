#pragma once

#include <QWidget>

#include "ui/views/path_view.h"

namespace nineline::pages {

/// Buttons for the camera's standard places.
class CameraButtons : public QWidget {
  Q_OBJECT

 public:
  explicit CameraButtons(QWidget* parent = nullptr);

 signals:
  void chosen(nineline::views::Camera camera);
};

}  // namespace nineline::pages
