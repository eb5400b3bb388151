#include "core/nc/code_table.h"

#include <initializer_list>

namespace nineline::nc {
namespace {

using enum CodeAction;

void put(CodeTable& table, CodeAction action, std::uint8_t group, std::initializer_list<int> tenths) {
  for (const int code : tenths) table[static_cast<std::size_t>(code)] = {action, group};
}

constexpr std::uint8_t kMotion = 1, kPlane = 2, kDistance = 3, kArcDistance = 4, kFeed = 5, kUnits = 6,
                       kCutter = 7, kLength = 8, kReturn = 10, kOffset = 12, kPath = 13, kSpindle = 14,
                       kLathe = 15, kCycle = 9, kRotation = 16;

void putCommon(CodeTable& table) {
  put(table, Motion, kMotion, {0, 10, 20, 30});
  put(table, Thread, kMotion, {330});
  put(table, Dwell, 0, {40});
  put(table, Plane, kPlane, {170, 180, 190});
  put(table, CutterOff, kCutter, {400});
  put(table, CutterLeft, kCutter, {410});
  put(table, CutterRight, kCutter, {420});
  put(table, MachineCoordinates, 0, {530});
  put(table, WorkOffset, kOffset, {540, 550, 560, 570});
  put(table, Absolute, kDistance, {900});
  put(table, Incremental, kDistance, {910});
  put(table, InverseTime, kFeed, {930});
  put(table, PerMinute, kFeed, {940});
  put(table, PerRevolution, kFeed, {950});
  put(table, SurfaceSpeed, kSpindle, {960});
  put(table, SpindleSpeed, kSpindle, {970});
  put(table, Pass, kPath, {90, 640, 600});
}

/// What Fanuc and LinuxCNC have in common beyond that.
void putIso(CodeTable& table) {
  put(table, Inch, kUnits, {200});
  put(table, Millimetre, kUnits, {210});
  put(table, Data, 0, {100});
  put(table, ReferenceReturn, 0, {280, 300});
  put(table, LengthPlus, kLength, {430});
  put(table, LengthOff, kLength, {490});
  put(table, LocalOffset, 0, {520});
  put(table, WorkOffset, kOffset, {580, 590});
  put(table, ThreadOrCycle76, kCycle, {760});
  put(table, Cycle, kCycle, {730, 740, 810, 820, 830, 840, 850, 860, 870, 880, 890});
  put(table, CancelCycle, kCycle, {800});
  put(table, SetPosition, 0, {920});
  put(table, ClearPosition, 0, {921});
  put(table, ReturnInitial, kReturn, {980});
  put(table, ReturnPlane, kReturn, {990});
  put(table, Pass, kPath, {610});
  put(table, Refuse, 0, {700, 710, 720, 750, 50, 51, 52, 53, 60, 61, 62, 310, 380, 382, 383, 384, 385});
}

void putFanuc(CodeTable& table) {
  put(table, Thread, kMotion, {320, 340});
  put(table, LengthMinus, kLength, {440});
  put(table, TipControl, kLength, {434, 435});
  put(table, WorkOffsetExtended, kOffset, {541});
  put(table, SetPosition, 0, {500});
  put(table, Pass, 0,
      {50, 51, 81, 110, 131, 1130, 150, 220, 230, 250, 260, 270, 370, 501, 610, 620, 630, 640, 690, 691});
  put(table, PassWithAxes, 0, {220, 230});
  put(table, Rotate, kRotation, {680, 681});
  put(table, RotateOff, kRotation, {690, 691});
  put(table, Polar, 0, {160});
  put(table, MacroCall, 0, {650, 660});
  put(table, MacroModalEnd, 0, {670});
  put(table, Refuse, 0,
      {71, 1070, 120, 121, 1120, 130, 310, 360, 370, 410 + 1, 510, 511, 682, 683, 684, 770, 780, 790});
  put(table, Pass, 0, {401, 411, 421});
}

void putLinuxCnc(CodeTable& table) {
  put(table, RigidTap, kMotion, {331});
  put(table, DiameterOn, kLathe, {70});
  put(table, DiameterOff, kLathe, {80});
  put(table, PassWithAxes, 0, {281, 301});
  put(table, CutterLeft, kCutter, {411});
  put(table, CutterRight, kCutter, {421});
  put(table, LengthDynamic, kLength, {431});
  put(table, LengthAdd, kLength, {432});
  put(table, WorkOffset, kOffset, {591, 592, 593});
  put(table, Pass, kPath, {611});
  put(table, ArcAbsolute, kArcDistance, {901});
  put(table, ArcIncremental, kArcDistance, {911});
  put(table, SuspendPosition, 0, {922});
  put(table, RestorePosition, 0, {923});
  put(table, Refuse, 0, {171, 181, 191});
}

void putSiemens(CodeTable& table) {
  put(table, Inch, kUnits, {700, 7000});
  put(table, Millimetre, kUnits, {710, 7100});
  put(table, NoWorkOffset, kOffset, {5000});
  for (int g = 505; g <= 599; ++g) put(table, WorkOffset, kOffset, {g * 10});
  put(table, MachineCoordinates, 0, {1530});
  put(table, SpindleLimit, 0, {250, 260});
  put(table, Pass, 0,
      {600,  601,  602,  603,  641,  642, 6010, 6020, 6030, 6040, 6400, 6410, 6420, 6430, 6440, 6450, 80,
       4500, 4510, 4600, 4610, 4620, 630, 2900, 2910, 4200, 610,  620,  9600, 9610, 9620, 9710, 9720, 9730});
  put(table, PerRevolution, kFeed, {950});
  put(table, Refuse, 0,
      {730, 760, 810, 820, 830, 840,  850,  860,  870,  880,  890,  331,  332,  333,  50,   70,
       580, 590, 630, 740, 750, 1100, 1110, 1120, 1470, 1480, 2470, 2480, 3310, 3320, 3470, 3480});
  put(table, Pass, 0, {800});
}

CodeTable makeTable(Dialect dialect) {
  CodeTable table{};
  putCommon(table);
  if (dialect == Dialect::Siemens) {
    putSiemens(table);
    return table;
  }
  putIso(table);
  if (dialect == Dialect::Fanuc) putFanuc(table);
  if (dialect == Dialect::LinuxCnc) putLinuxCnc(table);
  return table;
}

}  // namespace

const CodeTable& codeTable(Dialect dialect) {
  static const CodeTable fanuc = makeTable(Dialect::Fanuc);
  static const CodeTable siemens = makeTable(Dialect::Siemens);
  static const CodeTable linux_cnc = makeTable(Dialect::LinuxCnc);
  return dialect == Dialect::Fanuc ? fanuc : dialect == Dialect::Siemens ? siemens : linux_cnc;
}

}  // namespace nineline::nc
