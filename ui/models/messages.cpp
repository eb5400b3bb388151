#include "ui/models/messages.h"

#include <QCoreApplication>
#include <QtGlobal>
#include <array>
#include <string_view>

namespace nineline::models {

namespace {

struct Sentence {
  std::string_view prefix;
  const char* text;
};

/// The longest matching prefix of a code counts; so the special ones come first.
constexpr std::array kSentences = {
    Sentence{"cancelled", QT_TRANSLATE_NOOP("messages", "Cancelled.")},
    Sentence{"workspace.empty", QT_TRANSLATE_NOOP("messages", "There is nothing here yet.")},
    Sentence{"workspace.program", QT_TRANSLATE_NOOP("messages", "There is no program yet.")},
    Sentence{"setup.", QT_TRANSLATE_NOOP("messages", "A value of the machine state cannot be used.")},
    Sentence{"options.", QT_TRANSLATE_NOOP("messages", "A compensation option cannot be used.")},
    Sentence{"machine.", QT_TRANSLATE_NOOP("messages", "The machine description is not right.")},
    Sentence{"json.", QT_TRANSLATE_NOOP("messages", "The text is not as expected.")},
    Sentence{"model.", QT_TRANSLATE_NOOP("messages", "A measured error or effect is not right.")},
    Sentence{"table.", QT_TRANSLATE_NOOP("messages", "An error table is not right.")},
    Sentence{"nc.BadNumber", QT_TRANSLATE_NOOP("messages", "A word of the program needs a number.")},
    Sentence{"nc.NoSuchAxis",
             QT_TRANSLATE_NOOP("messages", "The program names an axis that the machine lacks.")},
    Sentence{
        "nc.UnknownCode",
        QT_TRANSLATE_NOOP("messages", "The program has a code that could be motion and is not understood.")},
    Sentence{
        "nc.NotConstant",
        QT_TRANSLATE_NOOP("messages", "The program depends on something that is known at run time only.")},
    Sentence{"nc.BadArc", QT_TRANSLATE_NOOP("messages", "Centre, radius and end of an arc do not fit.")},
    Sentence{"nc.", QT_TRANSLATE_NOOP("messages", "The program cannot be read here.")},
    Sentence{"simulation.travel",
             QT_TRANSLATE_NOOP("messages", "A command lies outside the travel of an axis.")},
    Sentence{"simulation.condition",
             QT_TRANSLATE_NOOP("messages", "The model needs a temperature or condition that is not given.")},
    Sentence{"simulation.",
             QT_TRANSLATE_NOOP("messages", "The program cannot be simulated on this machine.")},
    Sentence{"travel", QT_TRANSLATE_NOOP("messages", "A command lies outside the travel of an axis.")},
    Sentence{"kinematics.",
             QT_TRANSLATE_NOOP("messages", "The axes cannot reach a pose that the program asks for.")},
    Sentence{"state.missing",
             QT_TRANSLATE_NOOP("messages", "The model needs a temperature or condition that is not given.")},
    Sentence{"compensation.limit", QT_TRANSLATE_NOOP("messages", "A correction is larger than its limit.")},
    Sentence{"compensation.", QT_TRANSLATE_NOOP("messages", "The program cannot be compensated.")},
    Sentence{"thread.", QT_TRANSLATE_NOOP("messages", "A thread parameter needs attention.")},
    Sentence{"project.newer",
             QT_TRANSLATE_NOOP("messages", "The project was saved by a newer version of Nineline.")},
    Sentence{"project.damaged", QT_TRANSLATE_NOOP("messages", "The project file is damaged.")},
    Sentence{"project.", QT_TRANSLATE_NOOP("messages", "The project file cannot be used.")},
    Sentence{"file.", QT_TRANSLATE_NOOP("messages", "The file cannot be read or written.")},
    Sentence{"document.", QT_TRANSLATE_NOOP("messages", "The project file cannot be used.")},
};

/// Sentences for warnings; others show core's text alone.
constexpr std::array kWarnings = {
    Sentence{"table.outside",
             QT_TRANSLATE_NOOP("messages", "Outside the range of an error table its end value is used.")},
    Sentence{"compensation.unpositioned",
             QT_TRANSLATE_NOOP("messages",
                               "An axis is not corrected before the program has stated its position.")},
    Sentence{"compensation.start",
             QT_TRANSLATE_NOOP("messages",
                               "An axis is not corrected before the program has stated its position.")},
    Sentence{"compensation.cutter",
             QT_TRANSLATE_NOOP("messages", "The control's cutter compensation acts on the corrected path.")},
    Sentence{"compensation.cycle", QT_TRANSLATE_NOOP("messages", "A canned cycle is not corrected inside.")},
    Sentence{"compensation.tolerance",
             QT_TRANSLATE_NOOP("messages", "Somewhere the path stays outside the tolerance.")},
    Sentence{"compensation.remains",
             QT_TRANSLATE_NOOP("messages", "Some errors cannot be corrected by the axes that may move.")},
    Sentence{"thread.", QT_TRANSLATE_NOOP("messages", "A thread parameter needs attention.")},
    Sentence{"nc.PassedCode", QT_TRANSLATE_NOOP("messages", "A code that moves nothing was passed through.")},
    Sentence{"nc.Assumed",
             QT_TRANSLATE_NOOP("messages", "A value that the program does not state was assumed.")},
};

template <typename Sentences>
const char* find(const Sentences& sentences, const std::string& code) {
  for (const Sentence& sentence : sentences) {
    if (code.starts_with(sentence.prefix)) return sentence.text;
  }
  return nullptr;
}

QString place(std::size_t line, std::size_t column) {
  if (line == 0) return {};
  if (column == 0) return QCoreApplication::translate("messages", "Line %1:").arg(line) + QLatin1Char(' ');
  return QCoreApplication::translate("messages", "Line %1, column %2:").arg(line).arg(column) +
         QLatin1Char(' ');
}

QString message(const std::string& code, const std::string& text, std::size_t line, std::size_t column) {
  const QString sentence = sentenceFor(code);
  const QString detail = place(line, column) + QString::fromStdString(text);
  if (sentence.isEmpty()) return detail;
  return code == "cancelled" || code.starts_with("workspace.") ? sentence
                                                               : sentence + QLatin1Char('\n') + detail;
}

}  // namespace

QString sentenceFor(const std::string& code) {
  const char* source = find(kSentences, code);
  return source == nullptr ? QString() : QCoreApplication::translate("messages", source);
}

QString messageOf(const Error& error) { return message(error.code, error.text, error.line, error.column); }

QString messageOf(const Diagnostic& diagnostic) {
  const QString detail = place(diagnostic.line, diagnostic.column) + QString::fromStdString(diagnostic.text);
  QString message = detail;
  if (diagnostic.count > 1) {
    message = QCoreApplication::translate("messages", "%1 (%2 times)").arg(detail).arg(diagnostic.count);
  }
  const char* source = diagnostic.severity == Severity::Error ? find(kSentences, diagnostic.code)
                                                              : find(kWarnings, diagnostic.code);
  if (source == nullptr) return message;
  const QString sentence = QCoreApplication::translate("messages", source);
  // In English the detail says it all.
  return sentence == QString::fromUtf8(source) ? message : sentence + QLatin1Char('\n') + message;
}

}  // namespace nineline::models
