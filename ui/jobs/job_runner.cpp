#include "ui/jobs/job_runner.h"

#include <QElapsedTimer>
#include <QMetaObject>
#include <QRunnable>
#include <exception>

namespace nineline::jobs {

namespace {

constexpr qint64 kReportInterval_ms = 50;
constexpr double kFractionBeforeGuess = 0.02;

}  // namespace

/// One job on the pool's thread; it is its own Progress.
class JobRunner::Task final : public QRunnable, public Progress {
 public:
  Task(JobRunner* runner, std::shared_ptr<Ticket> ticket, std::function<Delivery(Progress&)> job)
      : runner_(runner), ticket_(std::move(ticket)), job_(std::move(job)) {
    clock_.start();
  }

  void run() override {
    Delivery delivery;
    QString failure;
    try {
      delivery = job_(*this);
    } catch (const std::exception& fault) {
      failure = QString::fromUtf8(fault.what());
    }
    if (ticket_->abandoned) return;
    JobRunner* const runner = runner_;
    QMetaObject::invokeMethod(
        runner,
        [runner, ticket = ticket_, delivery, failure]() { runner->deliver(ticket, delivery, failure); },
        Qt::QueuedConnection);
  }

  void report(double fraction, const std::string& what) override {
    const qint64 now_ms = clock_.elapsed();
    if (now_ms - last_ms_ < kReportInterval_ms || ticket_->abandoned) return;
    last_ms_ = now_ms;
    const double spent = static_cast<double>(now_ms) / 1000.0;
    const double left = fraction > kFractionBeforeGuess ? spent * (1.0 - fraction) / fraction : -1.0;
    JobRunner* const runner = runner_;
    QMetaObject::invokeMethod(
        runner,
        [runner, ticket = ticket_, fraction, text = QString::fromStdString(what), left]() {
          if (!ticket->abandoned) emit runner->progressed(fraction, text, left);
        },
        Qt::QueuedConnection);
  }

  [[nodiscard]] bool isCancelled() const override { return ticket_->cancelled; }

 private:
  JobRunner* runner_;
  std::shared_ptr<Ticket> ticket_;
  std::function<Delivery(Progress&)> job_;
  QElapsedTimer clock_;
  qint64 last_ms_ = -kReportInterval_ms;
};

JobRunner::JobRunner(QObject* parent) : QObject(parent) { pool_.setMaxThreadCount(1); }

JobRunner::~JobRunner() { stop(); }

void JobRunner::start(std::function<Delivery(Progress&)> job) {
  if (ticket_) {
    ticket_->cancelled = true;
    ticket_->abandoned = true;
  }
  ticket_ = std::make_shared<Ticket>();
  running_ = true;
  pool_.start(new Task(this, ticket_, std::move(job)));
  emit started();
}

void JobRunner::cancel() {
  if (ticket_) ticket_->cancelled = true;
}

void JobRunner::stop() {
  if (ticket_) {
    ticket_->cancelled = true;
    ticket_->abandoned = true;
  }
  pool_.waitForDone();
  running_ = false;
}

void JobRunner::deliver(const std::shared_ptr<Ticket>& ticket, const Delivery& delivery,
                        const QString& failure) {
  if (ticket->abandoned || ticket != ticket_) return;
  running_ = false;
  if (delivery) delivery();
  emit finished();
  if (!failure.isEmpty()) emit failed(failure);
}

}  // namespace nineline::jobs
