#pragma once

#include <QAbstractTableModel>
#include <optional>
#include <vector>

#include "core/base/json.h"
#include "core/errors/component.h"
#include "core/kinematics/machine.h"

namespace nineline::models {

/// The values of one error table, one row for each position. What a person types does not change the model:
/// `entryEdited` carries the new entry to whoever keeps the document, and setEntry brings it back.
class ErrorTableModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  static constexpr std::size_t kMostValues = 10000;

  explicit ErrorTableModel(QObject* parent = nullptr);
  void setEntry(const kinematics::Machine& machine, const errors::Component& component, Json entry);
  void clear();

  [[nodiscard]] const Json& entry() const { return entry_; }
  [[nodiscard]] const std::optional<errors::Component>& component() const { return component_; }
  [[nodiscard]] std::optional<double> start() const;    ///< mm or deg
  [[nodiscard]] std::optional<double> spacing() const;  ///< mm or deg
  [[nodiscard]] std::size_t count() const { return values_.size(); }
  /// Positions (mm, deg) and values (µm, arcsec) of the rows that hold numbers.
  [[nodiscard]] std::vector<std::pair<double, double>> points() const;

  /// Puts pasted cells in, from `row` on: one column of values, or positions and values. The table grows as
  /// needed. Returns what is wrong with them, empty when nothing is.
  QString paste(const std::vector<QStringList>& cells, int row);
  /// Empties rows.
  void clearRows(int first, int last);

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 signals:
  void entryEdited(const nineline::Json& entry);

 private:
  [[nodiscard]] QString fault(const Json& cell) const;
  [[nodiscard]] std::optional<double> number(const std::string& key) const;
  void emitValues(Json::Array values, Json entry);
  std::optional<errors::Component> component_;
  std::string start_key_, spacing_key_, values_key_;
  QString position_unit_, value_unit_;
  Json entry_;
  Json::Array values_;
};

}  // namespace nineline::models
