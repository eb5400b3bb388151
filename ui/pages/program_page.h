#pragma once

#include "core/base/diagnostics.h"
#include "ui/pages/page.h"

class QLabel;

namespace nineline::views {
class PathView;
}
namespace nineline::widgets {
class CodeView;
class MessageList;
class ParameterForm;
}  // namespace nineline::widgets

namespace nineline::pages {

/// The NC program: opened or generated, as text and as ideal path.
class ProgramPage : public Page {
  Q_OBJECT

 public:
  explicit ProgramPage(Context context, QWidget* parent = nullptr);

 private:
  QWidget* makeThreadForm();
  QWidget* makeText();
  QWidget* makePath();
  void openProgram();
  void generateThread();
  void changeThread(const QString& key, const Json& value);
  void refreshProgram();
  void refreshThread();
  void refreshPreview();
  [[nodiscard]] Diagnostics checkThread() const;

  widgets::ParameterForm* form_;
  widgets::MessageList* findings_;
  widgets::CodeView* text_;
  widgets::MessageList* messages_;
  QLabel* name_;
  QLabel* facts_;
  views::PathView* path_;
};

}  // namespace nineline::pages
