#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/json.h"
#include "core/errors/error_model.h"

namespace nineline::discovery {

enum class Verdict { None, Explained, Partly, Unknown };
[[nodiscard]] std::string_view nameOf(Verdict verdict);

/// How far apart simulation and measurement are. Lengths in µm; angles in arcsec where only angles were read.
struct Gap {
  bool significant = false;
  double p_value = 1.0;
  double rms_before = 0.0;
  double rms_after = 0.0;
  double noise_floor = 0.0;
  double holdout_before = 0.0;  ///< on runs that the fit did not see
  double holdout_after = 0.0;
  std::optional<double> closed_pct;  ///< (before² − after²) / (before² − noise²) there, per cent
  std::vector<double> holdout_runs;
};

struct Condition {
  std::string variable;  ///< column name
  double low = 0.0;
  double high = 0.0;
};

struct Place {
  std::string text;
  std::string direction;
  std::vector<Condition> conditions;
  double share_pct = 0.0;
};

struct LookAlikeFound {
  std::string effect;
  std::string joint;
  std::string component;
  std::string why;
  double probability = 0.0;
  double likeness = 0.0;  ///< cosine between the columns: 1 identical on these data
};

struct FoundEffect {
  std::string effect;
  std::string joint;
  std::string component;
  std::string sensor;
  std::vector<std::string> covariates;  ///< of a nonparametric one
  double confidence = 0.0;
  std::vector<errors::Parameter> parameters;
  double share_pct = 0.0;
  double evidence = 0.0;        ///< −2 ln L that it is worth
  double rms_in_sigma = 0.0;    ///< on the instrument that sees it best
  bool is_measurement = false;  ///< reported, never compensated
  std::string detail_of;        ///< shape detail of this larger effect; empty: a cause of its own
  std::vector<LookAlikeFound> lookalikes;
  errors::EffectPtr model;  ///< as it enters the model; null for measurement effects
};

struct DataFault {
  std::string text;
  std::string file;
  std::size_t first_row = 0;  ///< from 1 over the samples, both ends included
  std::size_t last_row = 0;
};

/// Noise as found for one instrument.
struct NoiseFinding {
  std::string instrument;
  double level = 1.0;       ///< found over declared standard deviation
  double correlated = 0.0;  ///< share
  double length = 0.0;      ///< samples
  double offset = 0.0;      ///< share of the run offset
};

struct NotAccepted {
  std::string effect;
  std::string joint;
  std::string why;
  double evidence = 0.0;
};

struct DiscoveryReport {
  Verdict verdict = Verdict::None;
  std::string message = "discovery was not run";
  Gap gap;
  std::vector<Place> where;
  std::vector<FoundEffect> effects;
  std::vector<NotAccepted> suspected;
  std::vector<DataFault> data_quality;
  std::vector<NoiseFinding> noise;
  std::string next_experiment;
  std::vector<std::string> moved_parameters;  ///< of the present model, estimated anew
  std::size_t samples = 0;
  std::size_t outliers = 0;
  std::optional<errors::ErrorModel> model;  ///< with the found effects
};

/// As in contract.md, `discover --json`.
[[nodiscard]] Json reportToJson(const DiscoveryReport& report, const std::string& model_file);
/// A few lines for a person.
[[nodiscard]] std::string reportText(const DiscoveryReport& report);

}  // namespace nineline::discovery
