#include "ui/pages/export_page.h"

#include <QFileInfo>
#include <QFontDatabase>
#include <QHeaderView>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QVBoxLayout>

#include "core/base/file.h"
#include "ui/models/difference_model.h"

namespace nineline::pages {

namespace {

constexpr int kRowHeight = 24;

class DifferenceDelegate final : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

 protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
    QStyledItemDelegate::initStyleOption(option, index);
    if (!index.data(models::DifferenceModel::ChangedRole).toBool()) return;
    if (index.column() == 1) option->backgroundBrush = QColor(0xFC, 0xEE, 0xE3);
    if (index.column() >= 2) option->backgroundBrush = QColor(0xE4, 0xF0, 0xF9);
  }
};

}  // namespace

ExportPage::ExportPage(Context context, QWidget* parent)
    : Page(context, tr("Compare the corrected program with the original, then save it for the machine."),
           parent),
      model_(new models::DifferenceModel(this)) {
  auto* layout = new QVBoxLayout(body());
  layout->setContentsMargins(0, 0, 0, 0);
  note_ = new QLabel(body());
  note_->setObjectName(QStringLiteral("fault"));
  note_->setWordWrap(true);
  layout->addWidget(note_);
  table_ = new QTableView(body());
  table_->setObjectName(QStringLiteral("differenceTable"));
  table_->setModel(model_);
  table_->setItemDelegate(new DifferenceDelegate(table_));
  QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
  // The application's font may name families of its own, which would win.
  fixed.setFamilies({fixed.family(), QStringLiteral("DejaVu Sans Mono"), QStringLiteral("monospace")});
  fixed.setPointSizeF(10.0);
  table_->setFont(fixed);
  table_->setShowGrid(false);
  table_->setWordWrap(false);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(kRowHeight);
  table_->horizontalHeader()->setStretchLastSection(true);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setColumnWidth(0, 70);
  table_->setColumnWidth(1, 380);
  table_->setColumnWidth(2, 400);
  layout->addWidget(table_, 1);
  auto* row = new QHBoxLayout;
  next_ = new QPushButton(tr("Next difference"), body());
  next_->setShortcut(QKeySequence(Qt::Key_F8));
  save_ = new QPushButton(tr("Save corrected program…"), body());
  save_->setObjectName(QStringLiteral("primary"));
  row->addWidget(next_);
  row->addStretch(1);
  row->addWidget(save_);
  layout->addLayout(row);
  connect(next_, &QPushButton::clicked, this, &ExportPage::goToChange);
  connect(save_, &QPushButton::clicked, this, &ExportPage::save);
  connect(&workspace(), &models::Workspace::outcomeChanged, this, &ExportPage::refresh);
  connect(&workspace(), &models::Workspace::changed, this, &ExportPage::refreshNote);
  refresh();
  refreshNote();
}

void ExportPage::refresh() {
  const jobs::OutcomePtr outcome = workspace().outcome();
  model_->setTexts(outcome ? workspace().outcomeDocument().program : nullptr,
                   outcome ? outcome->text : nullptr);
  save_->setEnabled(outcome != nullptr);
  next_->setEnabled(outcome != nullptr);
  if (outcome != nullptr) goToChange();
}

void ExportPage::refreshNote() {
  const QString note = workspace().explanation(models::Step::Export);
  note_->setText(note);
  note_->setVisible(!note.isEmpty());
}

void ExportPage::goToChange() {
  int row = model_->nextChange(table_->currentIndex().row());
  if (row < 0) row = model_->nextChange(-1);
  if (row < 0) return;
  table_->setCurrentIndex(model_->index(row, 1));
  table_->scrollTo(model_->index(row, 1), QAbstractItemView::PositionAtCenter);
}

void ExportPage::save() {
  const jobs::OutcomePtr outcome = workspace().outcome();
  if (outcome == nullptr) return;
  if (workspace().isOutcomeStale() &&
      QMessageBox::question(
          this, tr("Save corrected program"),
          tr("Something has changed since this program was corrected. Save it all the same?")) !=
          QMessageBox::Yes) {
    return;
  }
  const QFileInfo original(QString::fromStdString(workspace().outcomeDocument().program_name));
  const QString suffix = original.suffix().isEmpty() ? QStringLiteral("nc") : original.suffix();
  const QString path = askSave(tr("Save corrected program"),
                               QStringLiteral("%1-corrected.%2").arg(original.completeBaseName(), suffix),
                               tr("NC programs (*.%1);;All files (*)").arg(suffix));
  if (path.isEmpty()) return;
  const Result<void> written = writeFile(path.toStdString(), *outcome->text);
  if (!written) showError(tr("Save corrected program"), written.error());
}

}  // namespace nineline::pages
