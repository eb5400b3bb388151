#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/diagnostics.h"
#include "core/measurement/delimited_text.h"
#include "core/measurement/measurement.h"

namespace nineline::measurement {

/// What a column of a measurement file is for.
enum class Role { Position, Reading, Sigma, AngularSigma, Covariate, Ignored };

struct Column {
  std::string name;
  std::size_t place = 1;  ///< column in the line of names, from 1
  Role role = Role::Covariate;
  std::size_t index = 0;  ///< of the joint, channel or covariate
  bool is_rotary = false;
};

/// Gives every column its role; channels and covariates are entered into the measurement, whose head is
/// known. Reports double columns, positions in the wrong unit and the absence of readings. The machine may be
/// null.
[[nodiscard]] std::vector<Column> assignColumns(const std::vector<Cell>& names, std::size_t line,
                                                const Machine* machine, Measurement& measurement,
                                                Diagnostics& diagnostics);

/// A machine whose joints are the position columns (`X_mm` linear, `C_deg` rotary), all on the tool's side.
/// Fails when there is none.
[[nodiscard]] Result<Machine> standInMachine(const std::vector<Cell>& names, const std::string& id);

}  // namespace nineline::measurement
