#include "core/thread_grinding/program_moves.h"

#include <string>

#include "core/nc/interpreter.h"
#include "core/nc/text_source.h"
#include "core/thread_grinding/program_text.h"

namespace nineline::thread_grinding {
namespace {

constexpr std::size_t kX = 0;
constexpr std::size_t kZ = 1;
constexpr std::size_t kC = 2;
constexpr nc::AxisMask kAllAxes = nc::axisBit(0) | nc::axisBit(1) | nc::axisBit(2);

nc::InterpreterOptions optionsFor(const AxisConvention& axes) {
  nc::InterpreterOptions options;
  options.dialect = nc::Dialect::Fanuc;
  options.axes.count = 3;
  options.axes.axes[kX] = {AxisId{'X'}, false, axes.x_factor == 2.0};
  options.axes.axes[kZ] = {AxisId{'Z'}, false, false};
  options.axes.axes[kC] = {AxisId{'C'}, true, false};
  return options;
}

ThreadPoint pointAtAxes(const nc::AxisValues& position, const AxisConvention& axes) {
  return pointOf({axes.x_factor * position[kX], position[kZ], degFromRad(position[kC])}, axes);
}

}  // namespace

Result<void> forEachMove(std::string_view program, const AxisConvention& axes,
                         const std::function<void(const VirtualMove&)>& use) {
  nc::MemoryText text("thread program", std::string(program));
  nc::Interpreter interpreter(text, optionsFor(axes));
  nc::AxisMask known = 0;
  while (true) {
    const Result<const nc::ExecutedBlock*> block = interpreter.next();
    if (!block) return block.error();
    if (*block == nullptr) return {};
    for (const nc::Motion& motion : (*block)->motions) {
      const bool placed = known == kAllAxes;
      known = static_cast<nc::AxisMask>(known | (motion.established & kAllAxes));
      if (!placed) continue;
      use({pointAtAxes(motion.start, axes), pointAtAxes(motion.end, axes),
           motion.kind == nc::MotionKind::Rapid, motion.line});
    }
  }
}

}  // namespace nineline::thread_grinding
