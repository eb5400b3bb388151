#include "core/discovery/where.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace nineline::discovery {

namespace {

constexpr double kPeel = 0.06;
constexpr double kLeastShare = 0.06;
constexpr double kCut = 0.15;  // of the range: less is not worth telling
constexpr double kWorthTelling = 0.1;
constexpr double kGrowth = 0.4;  // correlation with a condition inside the box

/// One variable over the readings looked at.
struct Variable {
  std::string name;
  std::vector<double> values;
  double low = 0.0;
  double high = 0.0;
};

std::vector<Index> bestGroup(const Campaign& campaign, const VectorXd& contribution) {
  std::map<std::pair<std::size_t, std::size_t>, std::vector<Index>> groups;  // file, channel
  for (std::size_t i = 0; i < campaign.readings().size(); ++i) {
    const Reading& reading = campaign.readings()[i];
    groups[{reading.file, reading.channel}].push_back(static_cast<Index>(i));
  }
  const std::vector<Index>* best = nullptr;
  double most = -1.0;
  for (const auto& [key, indices] : groups) {
    double sum = 0.0, squares = 0.0;
    for (const Index i : indices) sum += contribution[i], squares += contribution[i] * contribution[i];
    const auto n = static_cast<double>(indices.size());
    const bool zero = campaign.files()[key.first].measurement.instrument.hasZero();
    const double energy = (squares - (zero ? sum * sum / n : 0.0)) / std::sqrt(n);
    if (indices.size() >= 8 && energy > most) most = energy, best = &indices;
  }
  return best != nullptr ? *best : std::vector<Index>{};
}

std::vector<Variable> variablesOf(const Campaign& campaign, const std::vector<Index>& group) {
  std::vector<Variable> variables;
  const auto add = [&](const std::string& name, const auto& valueAt) {
    Variable variable{name, {}, 0.0, 0.0};
    for (const Index i : group) {
      const std::optional<double> value = valueAt(i);
      if (!value) return;
      variable.values.push_back(*value);
    }
    const auto [low, high] = std::minmax_element(variable.values.begin(), variable.values.end());
    if (*high - *low < 1e-9) return;
    variable.low = *low, variable.high = *high;
    variables.push_back(std::move(variable));
  };
  const kinematics::Machine& machine = campaign.model().machine();
  for (int j = 0; j < machine.jointCount(); ++j) {
    const auto at = static_cast<std::size_t>(j);
    const std::string axis = machine.joint(j).axis.text();
    const bool rotary = machine.isRotary(j);
    add(axis + (rotary ? "_deg" : "_mm"), [&](Index i) -> std::optional<double> {
      const double q = campaign.stateOf(i).q[at];
      return rotary ? degFromRad(q) : q;
    });
    add("approach_" + axis + "_1", [&](Index i) -> std::optional<double> {
      return static_cast<double>(campaign.stateOf(i).approach[at]);
    });
  }
  const CampaignFile& file = campaign.files()[campaign.readings()[static_cast<std::size_t>(group[0])].file];
  for (const measurement::Covariate& covariate : file.measurement.covariates) {
    const std::string& name = covariate.column;
    if (name == "run" || name.starts_with("approach_") || name.starts_with("sigma")) continue;
    add(name,
        [&](Index i) { return covariate.values[campaign.readings()[static_cast<std::size_t>(i)].sample]; });
  }
  return variables;
}

struct Box {
  std::vector<std::pair<double, double>> limits;
  double inside = 1.0;
  double share = 1.0;
  [[nodiscard]] double merit() const { return inside - share - 0.15 * (1.0 - inside); }
};

struct Face {
  std::size_t variable = 0;
  bool lower = true;
  double limit = 0.0;
  std::vector<bool> left;
  double gain = 0.0;
};

/// Takes the best slice off the box; false when none helps.
bool peel(const std::vector<Variable>& variables, const std::vector<double>& energy, std::vector<bool>& in,
          Box& box) {
  const auto count = static_cast<double>(std::count(in.begin(), in.end(), true));
  double total = 0.0;
  for (std::size_t i = 0; i < in.size(); ++i) total += in[i] ? energy[i] : 0.0;
  Face best;
  for (std::size_t v = 0; v < variables.size(); ++v) {
    std::vector<double> inside;
    for (std::size_t i = 0; i < in.size(); ++i) {
      if (in[i]) inside.push_back(variables[v].values[i]);
    }
    std::sort(inside.begin(), inside.end());
    if (inside.back() - inside.front() < 1e-9) continue;
    for (const bool lower : {true, false}) {
      const auto step = static_cast<std::size_t>(std::max(1.0, kPeel * count));
      const double edge = lower ? inside[std::min(step, inside.size() - 1)]
                                : inside[inside.size() - 1 - std::min(step, inside.size() - 1)];
      const double end = lower ? inside.front() : inside.back();
      double limit = edge;
      if (edge == end) {  // few distinct values: the whole slice of the outermost one goes
        const auto next = lower ? std::upper_bound(inside.begin(), inside.end(), end)
                                : std::lower_bound(inside.begin(), inside.end(), end);
        limit = lower ? *next : *(next - 1);
      }
      Face face{v, lower, limit, in, 0.0};
      double rest = 0.0, left = 0.0;
      for (std::size_t i = 0; i < in.size(); ++i) {
        const double value = variables[v].values[i];
        if (!in[i]) continue;
        face.left[i] = lower ? value >= limit : value <= limit;
        if (face.left[i]) rest += energy[i], left += 1.0;
      }
      if (left < 1.0 || left >= count) continue;
      face.gain = (rest / left - total / count) / std::sqrt(count - left);
      if (face.gain > best.gain) best = std::move(face);
    }
  }
  if (best.gain <= 0.0) return false;
  in = std::move(best.left);
  (best.lower ? box.limits[best.variable].first : box.limits[best.variable].second) = best.limit;
  return true;
}

Box bestBox(const std::vector<Variable>& variables, const std::vector<double>& energy) {
  Box box;
  for (const Variable& variable : variables) box.limits.emplace_back(variable.low, variable.high);
  double total = 1e-300;
  for (const double e : energy) total += e;
  std::vector<bool> in(energy.size(), true);
  Box best = box;
  const auto n = static_cast<double>(energy.size());
  while (static_cast<double>(std::count(in.begin(), in.end(), true)) > kLeastShare * n + 8.0) {
    if (!peel(variables, energy, in, box)) break;
    double inside = 0.0;
    for (std::size_t i = 0; i < in.size(); ++i) inside += in[i] ? energy[i] : 0.0;
    box.inside = inside / total;
    box.share = static_cast<double>(std::count(in.begin(), in.end(), true)) / n;
    if (box.merit() > best.merit() + 1e-12) best = box;
  }
  return best;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const auto n = static_cast<double>(a.size());
  double ma = 0.0, mb = 0.0, saa = 0.0, sbb = 0.0, sab = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) ma += a[i] / n, mb += b[i] / n;
  for (std::size_t i = 0; i < a.size(); ++i) {
    saa += (a[i] - ma) * (a[i] - ma), sbb += (b[i] - mb) * (b[i] - mb), sab += (a[i] - ma) * (b[i] - mb);
  }
  return saa > 0.0 && sbb > 0.0 ? sab / std::sqrt(saa * sbb) : 0.0;
}

std::string conditionText(const Condition& condition, double low, double high) {
  if (condition.variable.starts_with("approach_")) {
    const std::string axis = condition.variable.substr(9, condition.variable.size() - 11);
    return fmt::format("only in the {} direction of {}", condition.low > 0.0 ? "+" : "-", axis);
  }
  if (condition.low <= low + 1e-9) return fmt::format("{} below {:.4g}", condition.variable, condition.high);
  if (condition.high >= high - 1e-9) return fmt::format("{} above {:.4g}", condition.variable, condition.low);
  return fmt::format("{} {:.4g} to {:.4g}", condition.variable, condition.low, condition.high);
}

/// The condition that the size of the contribution follows most inside the box; empty when none does.
std::string growsWith(const std::vector<Variable>& variables, const std::vector<double>& size) {
  std::string best;
  double most = kGrowth;
  for (const Variable& variable : variables) {
    if (variable.name.starts_with("approach_")) continue;
    const double r = correlation(variable.values, size);
    if (r > most) most = r, best = variable.name;
  }
  return best;
}

}  // namespace

Place placeOf(const Campaign& campaign, const VectorXd& contribution) {
  Place place;
  const std::vector<Index> group = bestGroup(campaign, contribution);
  if (group.empty()) return place;
  const Reading& first = campaign.readings()[static_cast<std::size_t>(group[0])];
  const Measurement& file = campaign.files()[first.file].measurement;
  const std::string column = file.channels[first.channel].column();
  double mean = 0.0;
  for (const Index i : group) mean += contribution[i] / static_cast<double>(group.size());
  if (!file.instrument.hasZero()) mean = 0.0;
  std::vector<double> energy, size;
  for (const Index i : group) {
    energy.push_back((contribution[i] - mean) * (contribution[i] - mean));
    size.push_back(std::abs(contribution[i]));
  }
  const std::vector<Variable> variables = variablesOf(campaign, group);
  const Box box = bestBox(variables, energy);
  std::string text(measurement::nameOf(file.instrument.kind));
  if (file.instrument.axis) text += " " + file.instrument.axis->text();
  if (column.starts_with("dev_") && column.size() > 6 && column[5] == '_')
    place.direction = column.substr(4, 1);
  if (file.instrument.axis && place.direction.empty()) {
    place.direction = std::string(1, static_cast<char>(std::tolower(file.instrument.axis->letter)));
  }
  const bool worth = box.merit() > kWorthTelling;
  for (std::size_t v = 0; v < variables.size() && worth; ++v) {
    const auto [low, high] = box.limits[v];
    if (high - low > (1.0 - kCut) * (variables[v].high - variables[v].low)) continue;
    place.conditions.push_back({variables[v].name, low, high});
    text += ", " + conditionText(place.conditions.back(), variables[v].low, variables[v].high);
  }
  const std::string grows = growsWith(variables, size);
  if (!grows.empty()) text += ", growing with " + grows;
  place.share_pct = 100.0 * (worth ? box.inside : 1.0);
  place.text = fmt::format("{}: {:.0f} % of the gap there in {:.0f} % of the samples", text, place.share_pct,
                           100.0 * (worth ? box.share : 1.0));
  return place;
}

}  // namespace nineline::discovery
