#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/diagnostics.h"
#include "core/errors/effect.h"
#include "core/measurement/measurement.h"

namespace nineline::measurement {

/// One answer that a question may have.
struct Choice {
  std::string id;    ///< "alternate"
  std::string text;  ///< for a dialog, English
};

/// A convention that a foreign file leaves open. Nothing is assumed: the caller answers, by a command line
/// option or a dialog, and imports again.
struct Question {
  std::string id;                        ///< key of the answer, "direction"
  std::string text;                      ///< English
  std::vector<Choice> choices;           ///< empty: free text as `expected` says
  std::string expected;                  ///< for free text: "three numbers x y z in mm"
  std::optional<std::string> likeliest;  ///< what the data themselves suggest; shown, never taken
};

/// Answers by question id.
using Answers = std::map<std::string, std::string>;

/// The instrument recorded this against time; commanded positions are not in the file.
struct Recording {
  double step = 0.0;           ///< s
  std::vector<double> values;  ///< mm
  std::string axis;            ///< as the file names it
};

/// A figure that the instrument's own software computed, as its file states it.
struct StatedFigure {
  std::string name;
  std::string text;             ///< as it stands
  std::optional<double> value;  ///< in `unit`
  std::string unit;             ///< "" when the file does not say it
};

/// What a foreign file holds. Complete when there are neither errors nor open questions.
struct Import {
  std::string format;  ///< "renishaw-rtl", "renishaw-rtx", "renishaw-b5r", "etalon", "isg-csv"
  std::vector<std::pair<std::string, std::string>> head;  ///< machine, serial number, date … as they stand
  std::vector<Measurement> measurements;
  std::vector<errors::EffectPtr> effects;  ///< error tables and location errors
  std::optional<Recording> recording;
  std::vector<StatedFigure> figures;
  std::vector<Question> questions;
  Diagnostics diagnostics;

  [[nodiscard]] bool isComplete() const { return questions.empty() && !diagnostics.hasErrors(); }
};

/// The format of a file by its content: one of Import::format, "nineline", "table" for other delimited text
/// (read by a ColumnMapping), "" for none.
[[nodiscard]] std::string formatOf(std::string_view bytes);

/// Reads a foreign file. The machine says which axes there are. Fails through the diagnostics.
[[nodiscard]] Import importFile(std::string_view bytes, const std::string& source, const Machine& machine,
                                const Answers& answers);

/// The readers behind importFile.
[[nodiscard]] Import importRtl(std::string_view bytes, const std::string& source, const Machine& machine,
                               const Answers& answers);
[[nodiscard]] Import importRtx(std::string_view bytes, const Answers& answers);
[[nodiscard]] Import importB5r(std::string_view bytes, const std::string& source);
[[nodiscard]] Import importEtalon(std::string_view bytes, const std::string& source, const Machine& machine,
                                  const Answers& answers);
[[nodiscard]] Import importIsg(std::string_view bytes, const std::string& source, const Machine& machine,
                               const Answers& answers);

/// The answer to a question where it is one of its choices (any text for free ones); else the question is put
/// into `import`, with a fault when the answer was none of them.
[[nodiscard]] std::optional<std::string> answerTo(Question question, const Answers& answers, Import& import);

}  // namespace nineline::measurement
