#pragma once

#include "core/kinematics/machine.h"
#include "ui/pages/page.h"

class QLabel;
class QListWidget;
class QTimer;

namespace nineline::views {
class MachineView;
}
namespace nineline::widgets {
class CodeView;
class MessageList;
}  // namespace nineline::widgets

namespace nineline::pages {

class AxisPanel;

/// Choose the machine, see its structure, move its axes, edit its file.
class MachinePage : public Page {
  Q_OBJECT

 public:
  explicit MachinePage(Context context, QWidget* parent = nullptr);

 private:
  QWidget* makeChooser();
  QWidget* makeView();
  QWidget* makeEditor();
  void fillList();
  void chooseBuiltIn(const QString& id);
  void openFile();
  void saveFile();
  void refresh();
  void takeText();

  QLabel* current_;
  QListWidget* list_;
  views::MachineView* view_;
  AxisPanel* axes_;
  widgets::CodeView* text_;
  widgets::MessageList* messages_;
  QTimer* typing_;
};

}  // namespace nineline::pages
