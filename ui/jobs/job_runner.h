#pragma once

#include <QObject>
#include <QString>
#include <QThreadPool>
#include <atomic>
#include <functional>
#include <memory>
#include <type_traits>

#include "core/base/progress.h"

namespace nineline::jobs {

/// Runs one verb at a time off the GUI thread. Work never touches a widget; its result arrives on the thread
/// that the runner lives on. A job that is replaced or whose runner is gone delivers nothing.
class JobRunner : public QObject {
  Q_OBJECT

 public:
  explicit JobRunner(QObject* parent = nullptr);
  ~JobRunner() override;

  /// Starts `work(Progress&)` on another thread; `done(result)` is called here. A job that still runs is
  /// cancelled and its result dropped.
  template <typename Work, typename Done>
  void run(Work work, Done done) {
    using Value = std::invoke_result_t<Work, Progress&>;
    start([work = std::move(work), done = std::move(done)](Progress& progress) mutable -> Delivery {
      auto value = std::make_shared<Value>(work(progress));
      return [value, done = std::move(done)]() mutable { done(std::move(*value)); };
    });
  }

  [[nodiscard]] bool isRunning() const { return running_; }
  /// Asks the running job to stop; it ends with the error `cancelled()`.
  void cancel();
  /// Cancels and waits for the thread; nothing is delivered.
  void stop();

 signals:
  void started();
  /// `seconds_left` is below 0 while nothing can be said.
  void progressed(double fraction, const QString& what, double seconds_left);
  /// The job is over: delivered, failed or cancelled.
  void finished();
  /// A mistake of the program itself inside the job; no result was delivered.
  void failed(const QString& text);

 private:
  using Delivery = std::function<void()>;
  class Task;
  struct Ticket {
    std::atomic<bool> cancelled{false};
    std::atomic<bool> abandoned{false};
  };
  void start(std::function<Delivery(Progress&)> job);
  void deliver(const std::shared_ptr<Ticket>& ticket, const Delivery& delivery, const QString& failure);

  QThreadPool pool_;
  std::shared_ptr<Ticket> ticket_;
  bool running_ = false;
};

}  // namespace nineline::jobs
