#include <QSignalSpy>
#include <QTest>
#include <QThread>
#include <atomic>
#include <stdexcept>

#include "core/base/result.h"
#include "ui/jobs/job_runner.h"

using nineline::Progress;
using nineline::Result;
using nineline::jobs::JobRunner;

class TestJobRunner : public QObject {
  Q_OBJECT

 private slots:
  void runsElsewhereAndDeliversHere() {
    JobRunner runner;
    QSignalSpy finished(&runner, &JobRunner::finished);
    QThread* worker = nullptr;
    QThread* delivered = nullptr;
    int value = 0;
    runner.run(
        [&worker](Progress&) {
          worker = QThread::currentThread();
          return 42;
        },
        [&](int result) {
          delivered = QThread::currentThread();
          value = result;
        });
    QVERIFY(runner.isRunning());
    QVERIFY(finished.wait());
    QCOMPARE(value, 42);
    QVERIFY(worker != QThread::currentThread());
    QCOMPARE(delivered, QThread::currentThread());
    QVERIFY(!runner.isRunning());
  }

  void cancelEndsTheWorkWithItsError() {
    JobRunner runner;
    QSignalSpy finished(&runner, &JobRunner::finished);
    std::atomic<bool> begun{false};
    std::string code;
    runner.run(
        [&begun](Progress& progress) -> Result<int> {
          begun = true;
          while (!progress.isCancelled()) QThread::msleep(1);
          return nineline::cancelled();
        },
        [&code](const Result<int>& result) { code = result ? "finished" : result.error().code; });
    QTRY_VERIFY(begun.load());
    runner.cancel();
    QVERIFY(finished.wait());
    QCOMPARE(code, std::string("cancelled"));
  }

  void anExceptionBecomesASignalAndNoResult() {
    JobRunner runner;
    QSignalSpy failed(&runner, &JobRunner::failed);
    bool delivered = false;
    runner.run([](Progress&) -> int { throw std::runtime_error("broken invariant"); },
               [&delivered](int) { delivered = true; });
    QVERIFY(failed.wait());
    QCOMPARE(failed.first().first().toString(), QStringLiteral("broken invariant"));
    QVERIFY(!delivered);
    QVERIFY(!runner.isRunning());
  }

  void aReplacedJobDeliversNothing() {
    JobRunner runner;
    QSignalSpy finished(&runner, &JobRunner::finished);
    std::vector<int> results;
    const auto take = [&results](int result) { results.push_back(result); };
    runner.run(
        [](Progress& progress) {
          while (!progress.isCancelled()) QThread::msleep(1);
          return 1;
        },
        take);
    runner.run([](Progress&) { return 2; }, take);
    QVERIFY(finished.wait());
    QCOMPARE(results, std::vector<int>{2});
    QCOMPARE(finished.size(), 1);
  }

  void aRunnerThatGoesTakesItsJobAlong() {
    std::atomic<bool> over{false};
    bool delivered = false;
    {
      JobRunner runner;
      runner.run(
          [&over](Progress& progress) {
            while (!progress.isCancelled()) QThread::msleep(1);
            over = true;
            return 1;
          },
          [&delivered](int) { delivered = true; });
    }
    QVERIFY(over.load());
    QCoreApplication::processEvents();
    QVERIFY(!delivered);
  }

  void progressTellsTimeLeft() {
    JobRunner runner;
    QSignalSpy progressed(&runner, &JobRunner::progressed);
    QSignalSpy finished(&runner, &JobRunner::finished);
    runner.run(
        [](Progress& progress) {
          QThread::msleep(80);
          progress.report(0.5, "half");
          return 0;
        },
        [](int) {});
    QVERIFY(finished.wait());
    QCOMPARE(progressed.size(), 1);
    QCOMPARE(progressed.first().at(0).toDouble(), 0.5);
    QCOMPARE(progressed.first().at(1).toString(), QStringLiteral("half"));
    QVERIFY(progressed.first().at(2).toDouble() >= 0.08);
  }
};

QTEST_GUILESS_MAIN(TestJobRunner)
#include "tst_job_runner.moc"
