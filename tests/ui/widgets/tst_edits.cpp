#include <QTest>

#include "ui/widgets/edits.h"

using namespace nineline;

class TestEdits : public QObject {
  Q_OBJECT

 private slots:
  void undoAndRedoBringDocumentsBack() {
    models::Workspace workspace;
    widgets::Edits edits(&workspace);
    models::Document next = workspace.document();
    next.options.set("tolerance_um", 2.0);
    edits.apply(QStringLiteral("change"), next);
    QCOMPARE(*workspace.document().options.find("tolerance_um")->number(), 2.0);
    edits.stack().undo();
    QVERIFY(workspace.document().options.find("tolerance_um") == nullptr);
    edits.stack().redo();
    QCOMPARE(*workspace.document().options.find("tolerance_um")->number(), 2.0);
  }

  void typingIntoOneFieldIsOneStep() {
    models::Workspace workspace;
    widgets::Edits edits(&workspace);
    for (const char* text : {"a", "ab", "abc"}) {
      models::Document next = workspace.document();
      next.machine_text = text;
      edits.apply(QStringLiteral("type"), next, QStringLiteral("machine"));
    }
    QCOMPARE(edits.stack().count(), 1);
    edits.stack().undo();
    QVERIFY(workspace.document().machine_text.empty());
  }

  void nothingChangedIsNoStep() {
    models::Workspace workspace;
    widgets::Edits edits(&workspace);
    edits.apply(QStringLiteral("nothing"), workspace.document());
    QCOMPARE(edits.stack().count(), 0);
  }
};

QTEST_GUILESS_MAIN(TestEdits)
#include "tst_edits.moc"
