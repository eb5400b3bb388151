#pragma once

#include <QAbstractTableModel>

#include "ui/models/workspace.h"

namespace nineline::models {

/// The files of readings of the open project, one row each: name, instrument, axis, runs, readings, and
/// whether it can be used.
class ReadingsModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  explicit ReadingsModel(const Workspace& workspace, QObject* parent = nullptr);

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  [[nodiscard]] QVariant text(const LoadedReadings& readings, int column) const;
  const Workspace& workspace_;
};

/// "laser-linear" in the user's language.
[[nodiscard]] QString instrumentName(measurement::InstrumentKind kind);

}  // namespace nineline::models
