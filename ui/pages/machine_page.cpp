#include "ui/pages/machine_page.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTabWidget>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>

#include "core/base/file.h"
#include "core/kinematics/built_in_machine_texts.h"
#include "core/kinematics/machine_file.h"
#include "ui/models/component_names.h"
#include "ui/models/effect_entries.h"
#include "ui/pages/axis_panel.h"
#include "ui/pages/camera_buttons.h"
#include "ui/views/machine_view.h"
#include "ui/widgets/code_view.h"
#include "ui/widgets/message_list.h"

namespace nineline::pages {

namespace {

constexpr int kTypingDelay_ms = 400;
constexpr int kChooserWidth = 280;
constexpr int kEditorWidth = 340;

}  // namespace

MachinePage::MachinePage(Context context, QWidget* parent)
    : Page(context, tr("Choose the machine whose errors are compensated, or open its file."), parent),
      typing_(new QTimer(this)) {
  auto* layout = new QHBoxLayout(body());
  layout->setContentsMargins(0, 0, 0, 0);
  auto* splitter = new QSplitter(body());
  splitter->addWidget(makeChooser());
  splitter->addWidget(makeView());
  splitter->addWidget(makeEditor());
  splitter->setStretchFactor(1, 1);
  splitter->setSizes({kChooserWidth, 640, kEditorWidth});
  layout->addWidget(splitter);
  typing_->setSingleShot(true);
  typing_->setInterval(kTypingDelay_ms);
  connect(typing_, &QTimer::timeout, this, &MachinePage::takeText);
  connect(&workspace(), &models::Workspace::machineChanged, this, &MachinePage::refresh);
  fillList();
  refresh();
}

QWidget* MachinePage::makeChooser() {
  auto* panel = new QWidget(this);
  auto* layout = new QVBoxLayout(panel);
  layout->setContentsMargins(0, 0, 0, 0);
  current_ = new QLabel(panel);
  current_->setObjectName(QStringLiteral("editorTitle"));
  current_->setWordWrap(true);
  layout->addWidget(current_);
  list_ = new QListWidget(panel);
  list_->setObjectName(QStringLiteral("machineList"));
  list_->setWordWrap(true);
  list_->setTextElideMode(Qt::ElideNone);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setSpacing(2);
  list_->setResizeMode(QListView::Adjust);
  list_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
  connect(list_, &QListWidget::itemClicked, this,
          [this](const QListWidgetItem* item) { chooseBuiltIn(item->data(Qt::UserRole).toString()); });
  connect(list_, &QListWidget::itemActivated, this,
          [this](const QListWidgetItem* item) { chooseBuiltIn(item->data(Qt::UserRole).toString()); });
  layout->addWidget(list_, 1);
  auto* open = new QPushButton(tr("Open machine file…"), panel);
  connect(open, &QPushButton::clicked, this, &MachinePage::openFile);
  layout->addWidget(open);
  auto* save = new QPushButton(tr("Save machine file…"), panel);
  connect(save, &QPushButton::clicked, this, &MachinePage::saveFile);
  layout->addWidget(save);
  return panel;
}

QWidget* MachinePage::makeView() {
  auto* panel = new QWidget(this);
  auto* layout = new QVBoxLayout(panel);
  layout->setContentsMargins(6, 0, 6, 0);
  view_ = new views::MachineView(panel);
  auto* cameras = new CameraButtons(panel);
  connect(cameras, &CameraButtons::chosen, view_, &views::MachineView::setCamera);
  layout->addWidget(view_, 1);
  layout->addWidget(cameras);
  return panel;
}

QWidget* MachinePage::makeEditor() {
  auto* tabs = new QTabWidget(this);
  axes_ = new AxisPanel(tabs);
  connect(axes_, &AxisPanel::moved, this,
          [this](const kinematics::JointPositions& q) { view_->setPosition(q); });
  tabs->addTab(axes_, tr("Move axes"));
  auto* editor = new QWidget(tabs);
  auto* layout = new QVBoxLayout(editor);
  layout->setContentsMargins(0, 0, 0, 0);
  text_ = new widgets::CodeView(editor);
  text_->setUndoRedoEnabled(false);
  messages_ = new widgets::MessageList(editor);
  messages_->setMaximumHeight(110);
  layout->addWidget(text_, 1);
  layout->addWidget(messages_);
  connect(text_, &QPlainTextEdit::textChanged, this, [this]() { typing_->start(); });
  connect(messages_, &widgets::MessageList::placeChosen, text_, &widgets::CodeView::goTo);
  tabs->addTab(editor, tr("Machine file"));
  return tabs;
}

void MachinePage::fillList() {
  for (const kinematics::Machine& machine : kinematics::builtInMachines()) {
    QString axes;
    for (const kinematics::Joint& joint : machine.joints()) {
      axes += QString::fromStdString(joint.axis.text()) + QLatin1Char(' ');
    }
    auto* item = new QListWidgetItem(
        QStringLiteral("%1\n%2").arg(models::machineName(machine), tr("Axes %1").arg(axes)), list_);
    item->setData(Qt::UserRole, QString::fromStdString(machine.id()));
  }
}

void MachinePage::chooseBuiltIn(const QString& id) {
  const auto& machines = kinematics::builtInMachines();
  const auto found = std::find_if(machines.begin(), machines.end(), [&id](const kinematics::Machine& one) {
    return one.id() == id.toStdString();
  });
  if (found == machines.end()) return;
  models::Document next = document();
  next.machine_text = kinematics::builtInMachineTexts()[static_cast<std::size_t>(found - machines.begin())];
  next.effects = models::effectsFor(*found, next.effects);
  edit(tr("Choose machine"), std::move(next));
}

void MachinePage::openFile() {
  const QString path = askOpen(tr("Open machine file"), tr("Machine files (*.json);;All files (*)"));
  if (path.isEmpty()) return;
  const Result<std::string> text = readFile(path.toStdString());
  if (!text) return showError(tr("Machine file"), text.error());
  models::Document next = document();
  next.machine_text = *text;
  edit(tr("Open machine file"), std::move(next));
}

void MachinePage::saveFile() {
  const QString path = askSave(tr("Save machine file"), QStringLiteral("machine.json"),
                               tr("Machine files (*.json);;All files (*)"));
  if (path.isEmpty()) return;
  const Result<void> written = writeFile(path.toStdString(), document().machine_text);
  if (!written) showError(tr("Machine file"), written.error());
}

void MachinePage::takeText() {
  models::Document next = document();
  next.machine_text = text_->toPlainText().toStdString();
  edit(tr("Edit machine file"), std::move(next), QStringLiteral("machine-text"));
}

void MachinePage::refresh() {
  {
    const QSignalBlocker blocker(text_);
    text_->setTextKeepingPlace(QString::fromStdString(document().machine_text));
  }
  const auto& machine = workspace().machine();
  text_->markFault(machine ? 0 : machine.error().line);
  if (!machine) return messages_->setError(machine.error());
  messages_->setFine(tr("The machine file is right."));
  view_->setMachine(&*machine);
  axes_->setMachine(*machine);
  current_->setText(models::machineName(*machine));
  list_->setCurrentRow(-1);
  for (int row = 0; row < list_->count(); ++row) {
    const bool same = list_->item(row)->data(Qt::UserRole).toString().toStdString() == machine->id();
    if (same) list_->setCurrentRow(row);
  }
}

}  // namespace nineline::pages
