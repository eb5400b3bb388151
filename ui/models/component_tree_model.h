#pragma once

#include <QAbstractItemModel>
#include <optional>

#include "core/errors/component.h"
#include "core/kinematics/machine.h"

namespace nineline {
class Json;
}

namespace nineline::models {

/// The measured errors as a tree: axis → its six motion errors and its location errors; then the other
/// effects. Second column: what is there.
class ComponentTreeModel : public QAbstractItemModel {
  Q_OBJECT

 public:
  /// What a row stands for.
  enum class Kind { Axis, Component, Location, OtherEffects };
  enum Role { KindRole = Qt::UserRole + 1, JointRole, RowRole, FilledRole };

  explicit ComponentTreeModel(QObject* parent = nullptr);
  void setMachine(const kinematics::Machine* machine);
  void setEffects(const Json& effects);

  /// The component of a row of that kind.
  [[nodiscard]] std::optional<errors::Component> component(const QModelIndex& index) const;
  [[nodiscard]] QModelIndex indexOf(const errors::Component& component) const;

  [[nodiscard]] QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  [[nodiscard]] QModelIndex parent(const QModelIndex& child) const override;
  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  [[nodiscard]] Kind kind(const QModelIndex& index) const;
  [[nodiscard]] QString text(const QModelIndex& index) const;
  [[nodiscard]] QString content(const QModelIndex& index) const;
  [[nodiscard]] std::size_t locationCount(int joint) const;
  std::optional<kinematics::Machine> machine_;
  std::vector<std::array<std::size_t, 6>> counts_;  // values of each joint's tables
  std::vector<std::array<bool, 6>> locations_;
  std::size_t others_ = 0;
};

}  // namespace nineline::models
