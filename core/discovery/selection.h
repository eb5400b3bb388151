#pragma once

#include <memory>

#include "core/base/progress.h"
#include "core/discovery/effect_library.h"
#include "core/discovery/existing_parameters.h"
#include "core/discovery/gates.h"
#include "core/discovery/hypothesis.h"

namespace nineline::discovery {

/// The state of a search: everything that the steps of the procedure share.
class Selection {
 public:
  Selection(const Campaign& campaign, const GateOptions& gates);

  /// Passes of search and noise, then the decisions by likelihood, then the gates.
  [[nodiscard]] Result<void> run(Progress& progress);

  [[nodiscard]] const Campaign& campaign() const { return *campaign_; }
  [[nodiscard]] const NoiseModel& noiseModel() const { return model_; }
  [[nodiscard]] const Noise& noise() const { return noise_; }
  [[nodiscard]] const ExistingPart& existing() const { return existing_; }
  [[nodiscard]] EffectLibrary& library() { return library_; }
  [[nodiscard]] const EffectLibrary& library() const { return library_; }
  [[nodiscard]] Dictionary& dictionary() { return *dictionary_; }
  [[nodiscard]] const Dictionary& dictionary() const { return *dictionary_; }
  [[nodiscard]] const OptionSet& set() const { return set_; }
  void setSet(OptionSet set) { set_ = std::move(set); }
  [[nodiscard]] Hypotheses hypotheses() const;
  [[nodiscard]] Gates gates() const;
  [[nodiscard]] const std::vector<Evidence>& suspected() const { return suspected_; }
  [[nodiscard]] std::vector<Refusal>& refused() { return refused_; }
  [[nodiscard]] const std::vector<Refusal>& refused() const { return refused_; }

  /// Noise of the present set, and a dictionary whitened by it.
  void whitenAnew(bool optimistic = false);

 private:
  void searchAndScan();
  void flagOutliers();
  /// Leaves out options that could not gain anything, alone or beside the present set.
  void prune();

  const Campaign* campaign_;
  GateOptions gate_options_;
  NoiseModel model_;
  Noise noise_;
  ExistingPart existing_;
  EffectLibrary library_;
  std::unique_ptr<Dictionary> dictionary_;
  OptionSet set_;
  std::vector<Evidence> suspected_;
  std::vector<Refusal> refused_;
};

}  // namespace nineline::discovery
