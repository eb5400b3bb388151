#include "ui/pages/program_page.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QVBoxLayout>
#include <map>

#include "core/base/file.h"
#include "core/thread_grinding/thread_checks.h"
#include "core/thread_grinding/thread_generator.h"
#include "ui/models/messages.h"
#include "ui/models/quantities.h"
#include "ui/pages/camera_buttons.h"
#include "ui/pages/thread_fields.h"
#include "ui/views/path_view.h"
#include "ui/widgets/code_view.h"
#include "ui/widgets/message_list.h"
#include "ui/widgets/parameter_form.h"

namespace nineline::pages {

namespace {

constexpr qint64 kLargestProgram = 64 * 1024 * 1024;
constexpr int kMessageHeight = 100;

/// "thread.pitch" belongs to the key that begins so: "pitch_mm".
std::map<std::string, QString> faultsByKey(const std::vector<widgets::Field>& fields,
                                           const Diagnostics& findings) {
  std::map<std::string, QString> faults;
  for (const Diagnostic& one : findings.all()) {
    if (one.severity != Severity::Error) continue;
    const std::string parameter = one.code.substr(one.code.find('.') + 1);
    for (const widgets::Field& field : fields) {
      const bool same = field.key == parameter || field.key.starts_with(parameter + "_");
      if (!field.key.empty() && same) faults[field.key] = models::messageOf(one);
    }
  }
  return faults;
}

}  // namespace

ProgramPage::ProgramPage(Context context, QWidget* parent)
    : Page(context, tr("Open the NC program to correct, or generate one for a thread."), parent) {
  auto* layout = new QHBoxLayout(body());
  layout->setContentsMargins(0, 0, 0, 0);
  auto* splitter = new QSplitter(body());
  splitter->addWidget(makeThreadForm());
  splitter->addWidget(makeText());
  splitter->addWidget(makePath());
  splitter->setStretchFactor(2, 1);
  splitter->setSizes({390, 400, 460});
  layout->addWidget(splitter);
  connect(&workspace(), &models::Workspace::programChanged, this, &ProgramPage::refreshProgram);
  connect(&workspace(), &models::Workspace::threadChanged, this, &ProgramPage::refreshThread);
  connect(&workspace(), &models::Workspace::previewChanged, this, &ProgramPage::refreshPreview);
  refreshThread();
  refreshProgram();
  refreshPreview();
}

QWidget* ProgramPage::makeThreadForm() {
  auto* panel = new QWidget(this);
  auto* layout = new QVBoxLayout(panel);
  layout->setContentsMargins(0, 0, 0, 0);
  form_ = new widgets::ParameterForm(threadFields(), panel);
  form_->setObjectName(QStringLiteral("threadForm"));
  findings_ = new widgets::MessageList(panel);
  findings_->setMaximumHeight(kMessageHeight);
  auto* generate = new QPushButton(tr("Generate thread program"), panel);
  generate->setObjectName(QStringLiteral("generateThread"));
  layout->addWidget(form_, 1);
  layout->addWidget(findings_);
  layout->addWidget(generate);
  connect(form_, &widgets::ParameterForm::edited, this, &ProgramPage::changeThread);
  connect(generate, &QPushButton::clicked, this, &ProgramPage::generateThread);
  return panel;
}

QWidget* ProgramPage::makeText() {
  auto* panel = new QWidget(this);
  auto* layout = new QVBoxLayout(panel);
  layout->setContentsMargins(6, 0, 6, 0);
  auto* row = new QHBoxLayout;
  auto* open = new QPushButton(tr("Open NC program…"), panel);
  connect(open, &QPushButton::clicked, this, &ProgramPage::openProgram);
  name_ = new QLabel(panel);
  row->addWidget(open);
  row->addWidget(name_, 1);
  layout->addLayout(row);
  text_ = new widgets::CodeView(panel);
  text_->setObjectName(QStringLiteral("programText"));
  text_->setReadOnly(true);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  layout->addWidget(text_, 1);
  messages_ = new widgets::MessageList(panel);
  messages_->setMaximumHeight(kMessageHeight);
  layout->addWidget(messages_);
  connect(messages_, &widgets::MessageList::placeChosen, text_, &widgets::CodeView::goTo);
  return panel;
}

QWidget* ProgramPage::makePath() {
  auto* panel = new QWidget(this);
  auto* layout = new QVBoxLayout(panel);
  layout->setContentsMargins(0, 0, 0, 0);
  path_ = new views::PathView(panel);
  path_->setShown(true, false, false);
  facts_ = new QLabel(panel);
  facts_->setWordWrap(true);
  auto* cameras = new CameraButtons(panel);
  connect(cameras, &CameraButtons::chosen, path_, &views::PathView::setCamera);
  connect(text_, &widgets::CodeView::currentLineChanged, path_, &views::PathView::markLine);
  connect(path_, &views::PathView::picked, this, [this](const simulation::PathSample* sample) {
    if (sample != nullptr) text_->goTo(sample->line);
  });
  layout->addWidget(path_, 1);
  layout->addWidget(facts_);
  layout->addWidget(cameras);
  return panel;
}

void ProgramPage::openProgram() {
  const QString path =
      askOpen(tr("Open NC program"),
              tr("NC programs (*.nc *.ngc *.tap *.mpf *.txt *.iso *.eia *.gcode);;All files (*)"));
  if (path.isEmpty()) return;
  if (QFileInfo(path).size() > kLargestProgram) {
    return showError(tr("NC program"),
                     badInput("program.large",
                              "This file has more than 64 MB. The window shows smaller ones; nineline-cli "
                              "compensates programs of any size."));
  }
  Result<std::string> text = readFile(path.toStdString());
  if (!text) return showError(tr("NC program"), text.error());
  models::Document next = document();
  next.program_name = QFileInfo(path).fileName().toStdString();
  next.program = std::make_shared<const std::string>(std::move(*text));
  edit(tr("Open NC program"), std::move(next));
}

void ProgramPage::changeThread(const QString& key, const Json& value) {
  models::Document next = document();
  next.thread.set(key.toStdString(), value);
  edit(tr("Change thread"), std::move(next));
}

Diagnostics ProgramPage::checkThread() const {
  const auto job = thread_grinding::parseThreadJob(writeJson(document().thread), "");
  if (job) return thread_grinding::checkThread(job->parameters, job->limits);
  Diagnostics findings;
  findings.error(job.error().code, job.error().text);
  return findings;
}

void ProgramPage::generateThread() {
  const auto job = thread_grinding::parseThreadJob(writeJson(document().thread), "");
  if (!job) return showError(tr("Thread program"), job.error());
  auto program = thread_grinding::generateThread(job->parameters, job->limits);
  if (!program) return showError(tr("Thread program"), program.error());
  models::Document next = document();
  next.program_name = "thread.nc";
  next.program = std::make_shared<const std::string>(std::move(program->text));
  edit(tr("Generate thread program"), std::move(next));
}

void ProgramPage::refreshThread() {
  form_->setValues(document().thread);
  const Diagnostics findings = checkThread();
  form_->setFaults(faultsByKey(form_->fields(), findings));
  if (findings.all().empty()) return findings_->setFine(tr("The thread parameters are right."));
  findings_->setDiagnostics(findings.all());
}

void ProgramPage::refreshProgram() {
  const auto& program = document().program;
  name_->setText(program ? QString::fromStdString(document().program_name) : tr("No program yet"));
  text_->setTextKeepingPlace(program ? QString::fromStdString(*program) : QString());
}

void ProgramPage::refreshPreview() {
  const jobs::ProgramPreview* preview = workspace().preview();
  text_->markFault(preview != nullptr && preview->error ? preview->error->line : 0);
  if (preview == nullptr) {
    messages_->clear();
    facts_->clear();
    return path_->setPaths({}, {});
  }
  path_->setPaths(preview->samples, {});
  path_->markLine(text_->currentLine());
  if (preview->error) {
    facts_->clear();
    return messages_->setError(*preview->error);
  }
  facts_->setText(
      tr("%1 blocks · path %2 · %3")
          .arg(preview->report->blocks)
          .arg(models::lengthText(preview->report->path_length), models::timeText(preview->report->time)));
  if (preview->report->diagnostics.all().empty()) {
    return messages_->setFine(tr("The program can be read whole."));
  }
  messages_->setDiagnostics(preview->report->diagnostics.all());
}

}  // namespace nineline::pages
