#include "core/postprocessing/cl_reader.h"

#include "core/postprocessing/cl_apt.h"

namespace nineline::postprocessing {

Result<ClProgram> readClData(std::string_view text, const std::string& source, const ClOptions& options,
                             Diagnostics* all_faults) {
  ClProgram program;
  Diagnostics own;
  Diagnostics& faults = all_faults != nullptr ? *all_faults : own;
  std::string_view content = text;
  if (content.starts_with("\xEF\xBB\xBF")) content.remove_prefix(3);
  if (isClTable(content)) {
    readClTable(content, program, faults);
  } else {
    readApt(text, options, program, faults);
  }
  if (faults.hasErrors()) return faults.firstError(source);
  if (program.goto_count == 0)
    return badInput("post.cl-empty", "No GOTO stands in the file, expected cutter location data.", source);
  for (const ClPoint& point : program.points) {
    if (point.kind != ClPoint::Kind::From && !point.rapid && !point.feed)
      return badInput("post.cl-feed", "The tool cuts before any FEDRAT states a feed.", source, point.line);
  }
  return program;
}

}  // namespace nineline::postprocessing
