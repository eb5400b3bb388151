#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/smoothing/certificate.h"
#include "core/smoothing/piece_output.h"

namespace nineline::smoothing {

namespace {

constexpr double kShortest = 1e-3;  // mm: a block that must be shorter is not worth writing

/// A written end of a block.
struct Node {
  double u = 0.0;
  nc::AxisValues values{};  // as the control reads them
  CurvePoint point;         // tip and rotary axes of these values
  double error = 0.0;       // mm, from the curve
};

/// Cuts one curve into straight blocks.
class Discretisation {
 public:
  explicit Discretisation(const PieceContext& context)
      : context_(context),
        curve_(context.piece.fitted->curve),
        parameters_(context.piece.fitted->parameters),
        rest_(context.tolerance - context.piece.fitted->errors.bound),
        turn_rest_(context.turn_tolerance - context.piece.fitted->errors.turn_bound) {}

  Result<PieceText> run() {
    const auto count = static_cast<double>(parameters_.size());
    Node at = nodeOf(0.0, context_.section.points[context_.piece.first].values);
    double step = curve_.end() / (count - 1.0);
    while (at.u < curve_.end()) {
      Result<Node> next = advance(at, step);
      if (!next) return next.error();
      append(at, *next);
      at = *next;
    }
    return std::move(text_);
  }

 private:
  Node nodeOf(double u, const nc::AxisValues& exact) const {
    Node node;
    node.u = u;
    node.values = context_.writer.rounded(exact);
    const Vector3d tip = context_.motion.tipAt(node.values);
    const std::vector<int>& rotary = context_.motion.rotary();
    node.point.resize(3 + static_cast<Eigen::Index>(rotary.size()));
    node.point.head<3>() = tip;
    for (std::size_t k = 0; k < rotary.size(); ++k)
      node.point[3 + static_cast<Eigen::Index>(k)] = node.values[static_cast<std::size_t>(rotary[k])];
    node.error = (tip - curve_.at(u).head<3>()).norm();
    return node;
  }

  Result<Node> advance(const Node& from, double& step) {
    const double left = curve_.end() - from.u;
    step = std::min(step, left);
    if (left > step && left < 1.7 * step) step = 0.5 * left;
    while (true) {
      const double u = step >= left ? curve_.end() : from.u + step;
      Result<nc::AxisValues> exact = u == curve_.end() ? context_.section.points[context_.piece.last].values
                                                       : context_.motion.valuesAt(curve_.at(u), from.values);
      if (!exact) return exact.error();
      Node node = nodeOf(u, *exact);
      const double h = u - from.u;
      const double ends = std::max(from.error, node.error);
      const double between = (context_.motion.boundBend(from.values, node.values) +
                              h * h * largestSecondDerivative(curve_, from.u, u)) /
                             8.0;
      const double turn = boundTurn(curve_, from.u, u, from.point, node.point);
      const double load =
          std::max(between / std::max(rest_ - ends, 1e-12), turn / std::max(turn_rest_, 1e-12));
      if (load <= 1.0) {
        text_.bound = std::max(text_.bound, ends + between);
        text_.turn_bound = std::max(text_.turn_bound, turn);
        step = h * std::clamp(std::sqrt(0.8 / std::max(load, 1e-6)), 0.5, 2.0);
        return node;
      }
      step = h * std::clamp(std::sqrt(0.8 / load), 0.1, 0.9);
      if (step < kShortest) return tooTight();
    }
  }

  Error tooTight() const {
    return noAnswer("smoothing.digits",
                    fmt::format("The words have too few digits to write the smooth path within {:.3f} um.",
                                umFromMm(context_.tolerance)));
  }

  /// F word in force between two parameters: that of the programmed motion in their middle.
  std::optional<double> feedAt(double u, bool is_last) const {
    const auto above = std::upper_bound(parameters_.begin(), parameters_.end(), u);
    std::size_t j = static_cast<std::size_t>(above - parameters_.begin());
    if (is_last) j = parameters_.size() - 1;
    return context_.section.points[context_.piece.first + j].feed;
  }

  void append(const Node& from, const Node& to) {
    std::string line = text_.points == 0 ? "G01" : "";
    context_.writer.appendWords(line, to.values);
    const std::optional<double> feed = feedAt(0.5 * (from.u + to.u), to.u == curve_.end());
    if (feed && feed != last_feed_) {
      line += " F";
      context_.writer.appendNumber(line, *feed, 6);
      last_feed_ = feed;
    }
    text_.text += (text_.points == 0 ? line : line.substr(1)) + context_.section.line_end;
    ++text_.points;
  }

  const PieceContext& context_;
  const BSpline& curve_;
  const std::vector<double>& parameters_;
  double rest_;
  double turn_rest_;
  std::optional<double> last_feed_;
  PieceText text_;
};

}  // namespace

Result<PieceText> writeStraight(const PieceContext& context) { return Discretisation(context).run(); }

}  // namespace nineline::smoothing
