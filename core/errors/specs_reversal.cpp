#include "core/errors/effect_specs.h"

namespace nineline::errors {

namespace {

EffectSpec backlash() {
  EffectSpec spec;
  spec.id = "backlash";
  spec.title = "Backlash";
  spec.rows = "10, 35";
  spec.formula = "-(w/2) s; along a program a dead band of width w";
  spec.parameters = {{.name = "width",
                      .linear = {{0.3, 100.0}, {0.3, 100.0}},
                      .arc = Plausible{{0.2, 100.0}, {0.2, 100.0}}}};
  spec.joints = JointChoice::Any;
  spec.sites = kOwn;
  spec.covariates = kApproach;
  spec.lookalikes = {
      {"reversal_spike", "both show right after a reversal",
       "let the axis stand after the reversal: a spike goes, play stays"},
      {"hysteresis", "both differ by the sense of motion", "sample from 0.01 to 50 mm after the reversal"},
      {"lost_motion", "the same at one load", "repeat with another load"}};
  spec.action_limit = {0.5, 3.0};
  spec.shop_floor = {
      "Play in the nut, the coupling, the thrust bearing or the worm.",
      "1 to 10 um on a ball screw, up to 50 um on a worn one; 2 to 60 arcsec on a worm.",
      "Check the axial play of the thrust bearing and the preload of the nut; adjust the worm's "
      "engagement. What remains goes into the control's backlash parameter or is compensated."};
  return spec;
}

}  // namespace

std::vector<EffectSpec> reversalSpecs() { return {backlash()}; }

}  // namespace nineline::errors
