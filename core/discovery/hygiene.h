#pragma once

#include "core/discovery/campaign.h"
#include "core/discovery/report.h"

namespace nineline::discovery {

/// A part of a file that is wrong in itself: a run with the wrong sign or unit or with two channels
/// exchanged, a sensor that stands still. Told and left out, never repaired silently.
struct HygieneFinding {
  DataFault fault;
  std::size_t file = 0;
};

/// Compares every run with the model's prediction and with the other runs of its file, and every temperature
/// with the others.
[[nodiscard]] std::vector<HygieneFinding> checkData(const Campaign& campaign);

/// True where a finding covers the sample.
[[nodiscard]] bool isFaulty(const std::vector<HygieneFinding>& findings, std::size_t file,
                            std::size_t sample);

}  // namespace nineline::discovery
