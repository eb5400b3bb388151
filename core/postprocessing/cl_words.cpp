#include "core/postprocessing/cl_words.h"

#include <algorithm>
#include <array>

namespace nineline::postprocessing {

namespace {

constexpr std::array<std::string_view, 16> kSilent = {
    "CUTTER", "INTOL",  "OUTTOL", "TOLER",  "TPRINT", "FINI",  "END",    "MACHIN",
    "ISN",    "CLPRNT", "PAINT",  "DISPLY", "LEADER", "UNITS", "MULTAX", "CATPROCESS"};

constexpr std::array<std::string_view, 49> kMotion = {
    "GO",     "GOFWD",  "GOLFT",  "GORGT",  "GOBACK", "GOUP",   "GODOWN", "GOHOME", "GOCLER", "GOCLEAR",
    "INDIRV", "INDIRP", "TLON",   "TLLFT",  "TLRGT",  "TLONPS", "TLOFPS", "TRACUT", "TRANS",  "ORIGIN",
    "COPY",   "INDEX",  "ROTABL", "ROTHED", "ROTATE", "ROTAXS", "RETRCT", "CLEARP", "THREAD", "ARC",
    "MOVARC", "MOVETO", "MOVE",   "CONT",   "AUTOPS", "PSIS",   "CUTCOM", "CALL",   "MACRO",  "LOOPST",
    "JUMPTO", "IF",     "POCKET", "PLUNGE", "SCURV",  "NURBS",  "SPLINE", "TURN",   "HELIX"};

}  // namespace

bool isSilentClWord(std::string_view word) { return std::ranges::find(kSilent, word) != kSilent.end(); }
bool mayMoveTool(std::string_view word) { return std::ranges::find(kMotion, word) != kMotion.end(); }

}  // namespace nineline::postprocessing
