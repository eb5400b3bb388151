#include "core/discovery/smooth_library.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace nineline::discovery {

namespace {

using errors::SmoothForm;

/// Range of a condition over the readings; absent where it is not known throughout half of them.
struct Range {
  double low = 0.0;
  double high = 0.0;
};

std::optional<Range> rangeOf(const Campaign& campaign, const std::string& column) {
  std::vector<double> values;
  for (const Reading& reading : campaign.readings()) {
    const std::optional<double> value =
        campaign.files()[reading.file].measurement.value(column, reading.sample);
    if (value) values.push_back(*value);
  }
  if (2 * values.size() < campaign.readings().size()) return std::nullopt;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  if (*high - *low < 1e-6) return std::nullopt;
  return Range{*low, *high};
}

std::optional<Range> travelOf(const Campaign& campaign, int joint) {
  const bool rotary = campaign.model().machine().isRotary(joint);
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (std::size_t i = 0; i < campaign.readings().size(); ++i) {
    const double q = campaign.stateOf(static_cast<Index>(i)).q[static_cast<std::size_t>(joint)];
    low = std::min(low, q), high = std::max(high, q);
  }
  if (rotary) low = degFromRad(low), high = degFromRad(high);
  if (!(high - low > 1e-3)) return std::nullopt;
  return Range{low, high};
}

std::string positionColumn(const kinematics::Machine& machine, int joint) {
  return machine.joint(joint).axis.text() + (machine.isRotary(joint) ? "_deg" : "_mm");
}

/// Conditions that a structure may follow: temperatures, load, time, pass, feed.
std::map<std::string, Range> conditionsOf(const Campaign& campaign) {
  std::set<std::string> names;
  for (const CampaignFile& file : campaign.files()) {
    for (const measurement::Covariate& covariate : file.measurement.covariates) {
      const std::string& name = covariate.column;
      const bool temperature = name.starts_with("temp_");
      if (temperature || name == "load_kg" || name == "t_s" || name == "pass_1" || name == "feed_mm_min") {
        names.insert(name);
      }
    }
  }
  std::map<std::string, Range> found;
  for (const std::string& name : names) {
    if (const std::optional<Range> range = rangeOf(campaign, name)) found[name] = *range;
  }
  return found;
}

SmoothForm form(const std::string& covariate, Range range, std::size_t intervals) {
  SmoothForm one;
  one.covariates = {covariate};
  one.start = range.low;
  one.spacing = (range.high - range.low) / static_cast<double>(intervals);
  one.intervals = intervals;
  return one;
}

SmoothForm times(SmoothForm one, const std::string& second, const std::optional<Range>& range) {
  one.covariates.push_back(second);
  if (range) {
    one.centre = 0.5 * (range->low + range->high);
    one.second = errors::Bounds{range->low, range->high};
  }
  return one;
}

class Maker {
 public:
  Maker(const Campaign& campaign, double typical_size)
      : campaign_(&campaign), size_(typical_size), conditions_(conditionsOf(campaign)) {}

  void addJoint(int joint) {
    const kinematics::Machine& machine = campaign_->model().machine();
    const std::optional<Range> travel = travelOf(*campaign_, joint);
    if (!travel) return;
    for (int row = 0; row < 6; ++row) {
      site_ = {.joint = joint, .component = {machine.joint(joint).axis, row, false}};
      addPositions(positionColumn(machine, joint), "approach_" + machine.joint(joint).axis.text() + "_1",
                   *travel);
      if (row < 3)
        addWindows(positionColumn(machine, joint), "approach_" + machine.joint(joint).axis.text() + "_1",
                   *travel);
      if (row == errors::positioningOf(machine.joint(joint)).row || row < 3) addConditions();
    }
  }
  [[nodiscard]] std::vector<SmoothStructure> take() { return std::move(found_); }

 private:
  void add(const std::string& what, std::vector<SmoothForm> forms) {
    found_.push_back({fmt::format("{} at {}", what, site_.component.text()), site_, std::move(forms), size_});
  }

  void addPositions(const std::string& q, const std::string& direction, Range travel) {
    for (const std::size_t knots : {std::size_t{6}, std::size_t{14}}) {
      const SmoothForm f = form(q, travel, knots);
      const std::string text = fmt::format("f({})/{}", q, knots);
      add(text, {f});
      add(text + " by direction", {times(f, direction, std::nullopt)});
      add(text + " in one direction", {f, times(f, direction, std::nullopt)});
    }
    const SmoothForm f = form(q, travel, 6);
    for (const auto& [name, range] : conditions_) {
      if (name == "pass_1" || name == "feed_mm_min") continue;
      add(fmt::format("f({}) times {}", q, name), {times(f, name, range)});
      add(fmt::format("f({}) changing with {}", q, name), {f, times(f, name, range)});
    }
  }

  void addWindows(const std::string& q, const std::string& direction, Range travel) {
    const double length = travel.high - travel.low;
    for (const double width : {0.05, 0.16, 0.3}) {
      const double step = 0.5 * width;
      for (double at = step; at < 1.0; at += step) {
        const Range window{travel.low + std::max(0.0, at - 0.5 * width) * length,
                           travel.low + std::min(1.0, at + 0.5 * width) * length};
        const SmoothForm f = form(q, window, 4);
        const std::string text = fmt::format("f({}) from {:.4g} to {:.4g}", q, window.low, window.high);
        add(text, {f});
        add(text + " in one direction", {f, times(f, direction, std::nullopt)});
      }
    }
  }

  void addConditions() {
    for (const auto& [name, range] : conditions_) add(fmt::format("f({})", name), {form(name, range, 5)});
  }

  const Campaign* campaign_;
  double size_;
  std::map<std::string, Range> conditions_;
  errors::Placement site_;
  std::vector<SmoothStructure> found_;
};

}  // namespace

std::vector<SmoothStructure> smoothStructures(const Campaign& campaign, double typical_size) {
  Maker maker(campaign, typical_size);
  for (int joint = 0; joint < campaign.model().machine().jointCount(); ++joint) maker.addJoint(joint);
  return maker.take();
}

RowMatrix columnsOf(const Campaign& campaign, const SmoothStructure& structure) {
  std::vector<VectorXd> columns;
  for (const SmoothForm& form : structure.forms) {
    const Result<std::vector<errors::EffectPtr>> basis =
        errors::smoothBasis(campaign.model().machine(), structure.placement, form);
    if (!basis) return {campaign.residual().size(), 0};
    for (const errors::EffectPtr& one : *basis)
      columns.push_back(structure.unit * campaign.effectColumn(one));
  }
  RowMatrix all(campaign.residual().size(), static_cast<Index>(columns.size()));
  for (std::size_t c = 0; c < columns.size(); ++c) all.col(static_cast<Index>(c)) = columns[c];
  return all;
}

Candidate candidateOf(const Campaign& campaign, const SmoothStructure& structure) {
  Candidate candidate;
  candidate.name = structure.name;
  candidate.group = campaign.model().machine().joint(structure.placement.joint).axis.text();
  candidate.largest = 3.0;
  candidate.generic = true;
  candidate.columns = [&campaign, structure](std::span<const double>) {
    return columnsOf(campaign, structure);
  };
  return candidate;
}

}  // namespace nineline::discovery
