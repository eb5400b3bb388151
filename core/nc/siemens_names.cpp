#include "core/nc/siemens_names.h"

#include <algorithm>
#include <iterator>

namespace nineline::nc {
namespace {

constexpr std::string_view kPassed[] = {
    "ACC",      "ADIS",      "ADISPOS",   "BRISK",    "CFC",      "CFIN",     "CFTCP",      "CDOF",
    "CDOF2",    "CDON",      "COMPCAD",   "COMPCURV", "COMPOF",   "COMPON",   "COMPSURF",   "CUT2D",
    "CUT2DF",   "CUT3DC",    "CUT3DF",    "CUT3DFF",  "CUT3DFS",  "CYCLE832", "DIAM90",     "DISPLOF",
    "DISPLON",  "DRIVE",     "DYNFINISH", "DYNNORM",  "DYNPOS",   "DYNROUGH", "DYNSEMIFIN", "FCUB",
    "FFWOF",    "FFWON",     "FGREF",     "FGROUP",   "FIFOCTRL", "FL",       "FLIN",       "FNORM",
    "FRC",      "FRCM",      "KONT",      "KONTC",    "KONTT",    "LIMS",     "M",          "MSG",
    "NORM",     "ORIAXES",   "ORIC",      "ORICURVE", "ORID",     "ORIEULER", "ORIMKS",     "ORIPATH",
    "ORIPLANE", "ORIRPY",    "ORIRPY2",   "ORIVECT",  "ORIVIRT1", "ORIVIRT2", "ORIWKS",     "OSC",
    "OSD",      "OSOF",      "OSSE",      "OST",      "OVR",      "OVRA",     "PUTFTOCF",   "RTLIOF",
    "RTLION",   "SAVE",      "SBLOF",     "SBLON",    "SCC",      "SETM",     "SETMS",      "SOFT",
    "SOFTA",    "SPATH",     "SPCOF",     "SPCON",    "SPOS",     "SPOSA",    "STARTFIFO",  "STOPFIFO",
    "STOPRE",   "SVC",       "TOWSTD",    "UPATH",    "WAITM",    "WAITMC",   "WAITS",      "WALIMOF",
    "WALIMON",  "WORKPIECE", "G"};

constexpr std::string_view kFrame[] = {"AMIRROR", "AROT",  "AROTS",   "ASCALE", "ATRANS", "CROTS",
                                       "MIRROR",  "PAROT", "PAROTOF", "ROT",    "ROTS",   "SCALE",
                                       "TOFRAME", "TOROT", "TOROTOF", "TRANS"};

constexpr std::string_view kCorner[] = {"ANG", "AP", "AR", "CHF", "CHR", "OFFN", "RND", "RNDM", "RP"};

template <std::size_t N>
bool isIn(const std::string_view (&names)[N], std::string_view name) {
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

}  // namespace

bool isPassedName(std::string_view name) { return isIn(kPassed, name); }
bool isFrameName(std::string_view name) { return isIn(kFrame, name); }
bool isCornerName(std::string_view name) { return isIn(kCorner, name); }

}  // namespace nineline::nc
