#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "core/discovery/report.h"

namespace nineline::models {

/// The effects that a search found, one row each: name, axis and error, size with uncertainty, confidence,
/// share of the gap.
class FoundEffectsModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  explicit FoundEffectsModel(QObject* parent = nullptr);
  void setEffects(std::vector<discovery::FoundEffect> effects);
  [[nodiscard]] const discovery::FoundEffect* effect(int row) const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  std::vector<discovery::FoundEffect> effects_;
};

/// "width 3.20 ± 0.20 µm, length 4 mm"
[[nodiscard]] QString parametersText(const std::vector<errors::Parameter>& parameters);

}  // namespace nineline::models
