#pragma once

#include <QPlainTextEdit>
#include <cstddef>

namespace nineline::widgets {

/// A text with line numbers; the line of the cursor is highlighted.
class CodeView : public QPlainTextEdit {
  Q_OBJECT

 public:
  explicit CodeView(QWidget* parent = nullptr);
  [[nodiscard]] std::size_t currentLine() const;  ///< from 1
  void goTo(std::size_t line, std::size_t column = 0);
  /// Marks a line as faulty; 0 marks none.
  void markFault(std::size_t line);
  /// Replaces the text and keeps the cursor's place as well as that is possible.
  void setTextKeepingPlace(const QString& text);

  [[nodiscard]] int numberAreaWidth() const;
  void paintNumbers(QPaintEvent* event);

 signals:
  void currentLineChanged(std::size_t line);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void highlight();
  void updateMargin();
  QWidget* numbers_;
  std::size_t fault_ = 0;
  std::size_t last_line_ = 0;
};

}  // namespace nineline::widgets
