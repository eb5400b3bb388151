#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "core/kinematics/machine.h"
#include "core/simulation/deviation_statistics.h"

namespace nineline::models {

/// The figures of a compensation, one row for each axis and for the tool tip: mean, RMS and largest value
/// before and after, and how much of the RMS is gone.
class SummaryModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  explicit SummaryModel(QObject* parent = nullptr);
  void setSummaries(const kinematics::Machine& machine, const simulation::DeviationSummary& before,
                    const simulation::DeviationSummary& after);
  void clear();

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  /// The table as CSV.
  [[nodiscard]] QString toCsv() const;

 private:
  struct Row {
    QString name;
    bool angular = false;
    simulation::Figures before, after;
  };
  [[nodiscard]] QString value(const Row& row, int column) const;
  std::vector<Row> rows_;
};

/// A length in µm (an angle in arc seconds) with three significant digits where it is small.
[[nodiscard]] QString shownFigure(double value, bool angular);

}  // namespace nineline::models
