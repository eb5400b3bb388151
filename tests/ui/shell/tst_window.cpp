#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QStackedWidget>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeView>
#include <memory>

#include "ui/pages/compensate_page.h"
#include "ui/shell/application.h"
#include "ui/shell/main_window.h"
#include "ui/shell/project_store.h"
#include "ui/views/scene_view.h"

using namespace nineline;
using models::Step;
using models::StepState;

namespace {

constexpr int kCompensation_ms = 120000;
constexpr int kGapSearch_ms = 120000;
constexpr double kLeftAtMost = 0.02;  // of the RMS, at the 1 µm words of the example's program

template <typename T>
T* child(const QWidget& parent, const char* name) {
  return parent.findChild<T*>(QString::fromLatin1(name));
}

}  // namespace

/// The real window on the worked example, from the machine to the corrected program.
class TestWindow : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    QVERIFY(folder_.isValid());
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder_.path());
    window_ = std::make_unique<shell::MainWindow>();
    window_->setLanguage(QStringLiteral("en"));
    window_->resize(1280, 800);
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    window_->openExample();
  }
  void cleanupTestCase() { window_.reset(); }

  void fitsItsScreen() {
    QVERIFY2(window_->minimumSizeHint().width() <= 1280,
             qPrintable(QString::number(window_->minimumSizeHint().width())));
    QVERIFY2(window_->minimumSizeHint().height() <= 800,
             qPrintable(QString::number(window_->minimumSizeHint().height())));
  }

  void everyViewHasOpenGl() {
    for (int step = 0; step < models::kStepCount; ++step) {
      window_->goTo(static_cast<Step>(step));
      QTest::qWait(200);
      const auto views = window_->findChildren<views::SceneView*>();
      for (const views::SceneView* view : views) {
        if (view->isVisible()) QVERIFY2(view->isValid(), qPrintable(QString::number(step)));
      }
    }
    window_->goTo(Step::Machine);
    QTest::qWait(100);
    for (const views::SceneView* view : window_->findChildren<views::SceneView*>()) {
      if (!view->isVisible()) continue;
      const QImage picture = view->picture();
      QVERIFY(!picture.isNull());
      QVERIFY(differentColours(picture) > 10);  // something was drawn
    }
  }

  void theExampleIsReadyToRun() {
    QTRY_VERIFY(window_->workspace().preview() != nullptr);
    QCOMPARE(window_->workspace().state(Step::Machine), StepState::Ready);
    QCOMPARE(window_->workspace().state(Step::Measurements), StepState::Ready);
    QCOMPARE(window_->workspace().state(Step::Program), StepState::Ready);
    QCOMPARE(window_->workspace().state(Step::Compensate), StepState::Missing);
  }

  void theButtonCompensatesTheExample() {
    window_->goTo(Step::Compensate);
    QSignalSpy done(&window_->workspace(), &models::Workspace::outcomeChanged);
    QTest::mouseClick(child<QPushButton>(*compensatePage(), "primary"), Qt::LeftButton);
    QVERIFY(done.wait(kCompensation_ms));
    const auto outcome = window_->workspace().outcome();
    QVERIFY(outcome != nullptr);
    const auto& report = outcome->report;
    QVERIFY(report.before.norm.rms > 0.1);
    QVERIFY(report.after.norm.rms < kLeftAtMost * report.before.norm.rms);
    QCOMPARE(outcome->before.size(), outcome->after.size());
    QCOMPARE(window_->workspace().state(Step::Results), StepState::Ready);
    QCOMPARE(child<QLabel>(*compensatePage(), "headline")->text(), QStringLiteral("NC program corrected"));
  }

  void resultsAndDifferenceAreShown() {
    window_->goTo(Step::Results);
    QTest::qWait(100);
    const auto* summary = child<QTableView>(*window_, "summaryTable");
    QVERIFY(summary->model()->rowCount() >= 3 + 5);
    QVERIFY(summary->model()->index(0, 7).data().toString().startsWith(QStringLiteral("9")));
    window_->goTo(Step::Export);
    const auto* difference = child<QTableView>(*window_, "differenceTable");
    QVERIFY(difference->model()->rowCount() > 1000);
  }

  void theGapIsNamedAddedAndTakenBack() {
    window_->goTo(Step::ModelGap);
    QSignalSpy done(&window_->workspace(), &models::Workspace::gapChanged);
    window_->startGapSearch();
    QVERIFY(done.wait(kGapSearch_ms));
    const auto gap = window_->workspace().gap();
    QVERIFY(gap != nullptr);
    QStringList found;
    for (const auto& effect : gap->report.effects) {
      found << QString::fromStdString(effect.effect + " " + effect.joint);
    }
    const int count = static_cast<int>(found.size());
    QVERIFY2(found.contains(QStringLiteral("backlash X")), qPrintable(found.join(QStringLiteral(", "))));
    QVERIFY2(found.contains(QStringLiteral("thermal_screw Z")), qPrintable(found.join(QStringLiteral(", "))));
    QCOMPARE(child<QTableView>(*window_, "foundEffects")->model()->rowCount(), count);
    QVERIFY(gap->stages.back().rms_in_sigma < 0.3 * gap->stages.front().rms_in_sigma);
    const std::size_t before = window_->workspace().document().effects.items()->size();
    QTest::mouseClick(child<QPushButton>(*window_, "addToModel"), Qt::LeftButton);
    QVERIFY(window_->workspace().document().effects.items()->size() >= before + 2);
    QCOMPARE(window_->workspace().state(Step::ModelGap), StepState::Stale);
    window_->edits().stack().undo();
    QCOMPARE(window_->workspace().document().effects.items()->size(), before);
    QCOMPARE(window_->workspace().state(Step::ModelGap), StepState::Ready);
  }

  void typingIntoTheTableMakesTheResultStaleAndUndoBringsItBack() {
    window_->goTo(Step::Measurements);
    auto* table = child<QTableView>(*window_, "errorTable");
    const QModelIndex cell = table->model()->index(0, 1);
    const QString before = cell.data(Qt::EditRole).toString();
    table->setCurrentIndex(cell);
    table->setFocus();
    QTest::keyClick(table, '7');
    auto* editor = table->viewport()->findChild<QLineEdit*>();
    QVERIFY(editor != nullptr);
    QTest::keyClicks(editor, QStringLiteral(",5"));
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_COMPARE(table->currentIndex().row(), 1);
    QCOMPARE(table->model()->index(0, 1).data().toString(), QStringLiteral("7.5"));
    QCOMPARE(window_->workspace().state(Step::Results), StepState::Stale);
    window_->edits().stack().undo();
    QCOMPARE(table->model()->index(0, 1).data(Qt::EditRole).toString(), before);
    QCOMPARE(window_->workspace().state(Step::Results), StepState::Ready);
  }

  void aBadValueIsExplained() {
    auto* table = child<QTableView>(*window_, "errorTable");
    QVERIFY(table->model()->setData(table->model()->index(1, 1), QStringLiteral("12o"), Qt::EditRole));
    QCOMPARE(window_->workspace().state(Step::Measurements), StepState::Faulty);
    QVERIFY(window_->workspace().explanation(Step::Measurements).contains(QStringLiteral("12o")));
    QVERIFY(!window_->workspace().compensationInput());
    window_->edits().stack().undo();
    QCOMPARE(window_->workspace().state(Step::Measurements), StepState::Ready);
  }

  void chineseWithoutRestart() {
    window_->setLanguage(QStringLiteral("zh_CN"));
    window_->goTo(Step::Compensate);
    QCOMPARE(child<QPushButton>(*compensatePage(), "primary")->text(), QStringLiteral("开始补偿"));
    QCOMPARE(window_->workspace().state(Step::Results), StepState::Ready);
    window_->setLanguage(QStringLiteral("en"));
    QCOMPARE(child<QPushButton>(*compensatePage(), "primary")->text(), QStringLiteral("Start compensation"));
  }

  void everyBuiltInMachineIsDrawn() {
    window_->goTo(Step::Machine);
    auto* list = child<QListWidget>(*window_, "machineList");
    QCOMPARE(list->count(), 8);
    for (int row = 0; row < list->count(); ++row) {
      emit list->itemClicked(list->item(row));
      QTest::qWait(30);
      QVERIFY(window_->workspace().machine().has_value());
      for (const views::SceneView* view : window_->findChildren<views::SceneView*>()) {
        if (view->isVisible()) QVERIFY(differentColours(view->picture()) > 20);
      }
      window_->edits().stack().undo();
    }
    QCOMPARE(window_->workspace().state(Step::Results), StepState::Ready);
  }

  void aBadMachineFileKeepsItsText() {
    models::Document next = window_->workspace().document();
    next.machine_text = "{\"format\": 3}";
    window_->edits().apply(QStringLiteral("type"), next);
    QCOMPARE(window_->workspace().state(Step::Machine), StepState::Faulty);
    QVERIFY(!window_->workspace().explanation(Step::Machine).isEmpty());
    window_->edits().stack().undo();
    QCOMPARE(window_->workspace().state(Step::Machine), StepState::Ready);
  }

  void theThreadFormGeneratesAndExplains() {
    window_->goTo(Step::Program);
    auto* pitch = child<QLineEdit>(*window_, "pitch_mm");
    const auto type = [pitch](const char* text) {
      pitch->clear();
      QTest::keyClicks(pitch, QString::fromLatin1(text));
      QTest::keyClick(pitch, Qt::Key_Return);
    };
    type("0");
    QVERIFY(pitch->property("bad").toBool());
    QVERIFY(!pitch->toolTip().isEmpty());
    type("2,0");
    QVERIFY(!pitch->property("bad").toBool());
    QTest::mouseClick(child<QPushButton>(*window_, "generateThread"), Qt::LeftButton);
    QVERIFY(window_->workspace().document().program->find("48 X 2") != std::string::npos);
    for (int step = 0; step < 3; ++step) window_->edits().stack().undo();
    QCOMPARE(pitch->text(), QStringLiteral("1.5"));
    QCOMPARE(window_->workspace().state(Step::Results), StepState::Ready);
  }

  void aProjectComesBack() {
    const QString path = folder_.filePath(QStringLiteral("example.nineline"));
    shell::ProjectStore store;
    const Result<void> saved =
        store.saveAs(path, window_->workspace().document(), window_->workspace().outcome());
    QVERIFY2(saved.has_value(), saved ? "" : saved.error().text.c_str());
    const models::Document before = window_->workspace().document();
    store.close();
    QVERIFY(window_->openProject(path));
    QVERIFY(!models::differences(before, window_->workspace().document()).any());
  }

  void aDamagedProjectIsRefused() {
    const QString path = folder_.filePath(QStringLiteral("broken.nineline"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(QByteArray(5000, 'x'));
    file.close();
    shell::ProjectStore store;
    const auto opened = store.open(path);
    QVERIFY(!opened);
    QVERIFY(QString::fromStdString(opened.error().code).startsWith(QStringLiteral("project.")));
  }

 private:
  [[nodiscard]] QWidget* compensatePage() const { return window_->findChild<pages::CompensatePage*>(); }
  static int differentColours(const QImage& picture) {
    QSet<QRgb> colours;
    for (int y = 0; y < picture.height(); y += 3) {
      for (int x = 0; x < picture.width(); x += 3) colours.insert(picture.pixel(x, y));
    }
    return static_cast<int>(colours.size());
  }
  QTemporaryDir folder_;
  std::unique_ptr<shell::MainWindow> window_;
};

int main(int argc, char** argv) {
  shell::Application application(argc, argv);
  TestWindow test;
  return QTest::qExec(&test, argc, argv);
}
#include "tst_window.moc"
