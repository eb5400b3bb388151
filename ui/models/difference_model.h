#pragma once

#include <QAbstractTableModel>
#include <QString>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace nineline::models {

/// Two programs side by side: lines that belong together stand in one row; the third column says by how much
/// their words differ (µm for linear words, arc seconds for rotary ones). Compensation keeps the order of
/// lines, changes words and inserts lines; lines that share everything but numbers belong together.
class DifferenceModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Role { ChangedRole = Qt::UserRole + 1 };

  explicit DifferenceModel(QObject* parent = nullptr);
  void setTexts(std::shared_ptr<const std::string> original, std::shared_ptr<const std::string> corrected);
  /// The next changed row after `row`, −1 when there is none.
  [[nodiscard]] int nextChange(int row) const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  struct Row {
    std::int64_t original = -1;  // index of the line, −1: inserted
    std::int64_t corrected = -1;
    bool changed = false;
  };
  [[nodiscard]] QString line(const std::vector<std::string_view>& lines, std::int64_t index) const;
  [[nodiscard]] QString differenceText(const Row& row) const;
  std::shared_ptr<const std::string> original_, corrected_;
  std::vector<std::string_view> original_lines_, corrected_lines_;
  std::vector<Row> rows_;
};

/// The words of two lines that differ, "X +12.3 µm  C −4.1″"; empty when none differ.
[[nodiscard]] QString wordDifferences(std::string_view original, std::string_view corrected);

}  // namespace nineline::models
