#include "ui/pages/page.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QMessageBox>
#include <QVBoxLayout>

#include "ui/models/messages.h"

namespace nineline::pages {

Page::Page(Context context, const QString& advice, QWidget* parent)
    : QWidget(parent), context_(context), advice_(new QLabel(advice, this)), body_(new QWidget(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(12, 8, 12, 8);
  layout->setSpacing(6);
  advice_->setObjectName(QStringLiteral("advice"));
  advice_->setWordWrap(true);
  layout->addWidget(advice_);
  layout->addWidget(body_, 1);
}

void Page::edit(const QString& text, models::Document next, const QString& key) const {
  context_.edits->apply(text, std::move(next), key);
}

void Page::setAdvice(const QString& text) { advice_->setText(text); }

QString Page::askOpen(const QString& title, const QString& filter) {
  const QString path = QFileDialog::getOpenFileName(this, title, workspace().folder, filter);
  if (!path.isEmpty()) workspace().folder = QFileInfo(path).absolutePath();
  return path;
}

QString Page::askSave(const QString& title, const QString& name, const QString& filter) {
  const QString start = workspace().folder.isEmpty() ? name : workspace().folder + QLatin1Char('/') + name;
  const QString path = QFileDialog::getSaveFileName(this, title, start, filter);
  if (!path.isEmpty()) workspace().folder = QFileInfo(path).absolutePath();
  return path;
}

void Page::showError(const QString& title, const Error& error) {
  QMessageBox box(QMessageBox::Warning, title, models::messageOf(error), QMessageBox::Ok, this);
  box.exec();
}

}  // namespace nineline::pages
