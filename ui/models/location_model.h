#pragma once

#include <QAbstractTableModel>
#include <optional>
#include <vector>

#include "core/base/json.h"
#include "core/errors/component.h"
#include "core/kinematics/machine.h"

namespace nineline::models {

/// The location errors of one joint: three shifts and three angles (squareness). An empty value means that
/// there is none. Edits leave as `valueEdited`; see ErrorTableModel.
class LocationModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  explicit LocationModel(QObject* parent = nullptr);
  void setEffects(const kinematics::Machine& machine, int joint, const Json& effects);

  [[nodiscard]] const errors::Component& component(int row) const {
    return components_[static_cast<std::size_t>(row)];
  }

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 signals:
  void valueEdited(const nineline::errors::Component& component, const nineline::Json& value);

 private:
  std::optional<kinematics::Machine> machine_;
  std::vector<errors::Component> components_;
  Json::Array values_;
};

}  // namespace nineline::models
