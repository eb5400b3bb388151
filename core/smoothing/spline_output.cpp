#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/smoothing/piece_output.h"
#include "core/smoothing/quintic.h"

namespace nineline::smoothing {

namespace {

constexpr int kKnotDecimals = 4;  // of the grid of knots
constexpr int kPolynomialDecimals = 9;

using Index = Eigen::Index;

/// Control points as axis values. The way from tip to axis values is affine here, so that they are the
/// control points of the axes.
Result<std::vector<nc::AxisValues>> controlValues(const PieceContext& context) {
  const BSpline& curve = context.piece.fitted->curve;
  std::vector<nc::AxisValues> values{context.section.points[context.piece.first].values};
  for (Index i = 1; i + 1 < curve.control().rows(); ++i) {
    Result<nc::AxisValues> next = context.motion.valuesAt(curve.control().row(i).transpose(), values.back());
    if (!next) return next.error();
    values.push_back(*next);
  }
  values.push_back(context.section.points[context.piece.last].values);
  return values;
}

/// How far written values move the tip and the rotary axes.
void addRounding(const PieceContext& context, const nc::AxisValues& exact, const nc::AxisValues& written,
                 PieceText& text) {
  const double off = (context.motion.tipAt(written) - context.motion.tipAt(exact)).norm();
  double turn = 0.0;
  for (const int axis : context.motion.rotary()) {
    const auto k = static_cast<std::size_t>(axis);
    turn += std::abs(written[k] - exact[k]);
  }
  text.bound = std::max(text.bound, off);
  text.turn_bound = std::max(text.turn_bound, turn);
}

Result<PieceText> checked(const PieceContext& context, PieceText text) {
  const FitErrors& errors = context.piece.fitted->errors;
  if (errors.bound + text.bound <= context.tolerance &&
      errors.turn_bound + text.turn_bound <= context.turn_tolerance)
    return text;
  return noAnswer("smoothing.digits",
                  fmt::format("The words have too few digits to write the smooth path within {:.3f} um.",
                              umFromMm(context.tolerance)));
}

void appendFeed(const PieceContext& context, std::string& line) {
  const std::optional<double> feed = context.section.points[context.piece.first + 1].feed;
  if (!feed) return;
  line += " F";
  context.writer.appendNumber(line, *feed, 6);
}

/// The control points in the words of the program, one column for each axis of the writer.
BSpline wordCurve(const PieceContext& context, const std::vector<nc::AxisValues>& values,
                  const std::vector<int>& axes) {
  PointRows rows(static_cast<Index>(values.size()), static_cast<Index>(axes.size()));
  for (std::size_t i = 0; i < values.size(); ++i) {
    const nc::AxisValues words = context.writer.wordsOf(values[i]);
    for (std::size_t k = 0; k < axes.size(); ++k)
      rows(static_cast<Index>(i), static_cast<Index>(k)) = words[static_cast<std::size_t>(axes[k])];
  }
  return {context.piece.fitted->curve.knots(), std::move(rows)};
}

/// Writes the polynomial blocks of one curve in words.
class PolynomialText {
 public:
  PolynomialText(const PieceContext& context, std::vector<int> axes, BSpline curve)
      : context_(context), axes_(std::move(axes)), curve_(std::move(curve)) {}

  PieceText run() {
    for (std::size_t span = kDegree; span < kDegree + curve_.spanCount(); ++span) appendSpan(span);
    text_.text += "G01" + context_.section.line_end;
    return std::move(text_);
  }

 private:
  void appendSpan(std::size_t span) {
    const double a = curve_.knots()[span];
    const double length = curve_.knots()[span + 1] - a;
    const BezierPiece piece = curve_.bezier(span, a, curve_.knots()[span + 1]);
    std::string line = text_.points == 0 ? "POLY" : "";
    double squares = 0.0;
    double turn = 0.0;
    for (std::size_t k = 0; k < axes_.size(); ++k) {
      const auto row = static_cast<Index>(k);
      const SpanPolynomial polynomial =
          spanPolynomial({piece[0][row], piece[1][row], piece[2][row], piece[3][row]}, length);
      const double off = appendAxis(line, axes_[k], polynomial, length);
      if (context_.writer.axes().axes[static_cast<std::size_t>(axes_[k])].rotary) {
        turn += off;
      } else {
        squares += off * off;
      }
    }
    line += " PL=";
    context_.writer.appendNumber(line, length, kKnotDecimals);
    if (text_.points == 0) appendFeed(context_, line);
    text_.text += (text_.points == 0 ? line : line.substr(1)) + context_.section.line_end;
    text_.bound = std::max(text_.bound, std::sqrt(squares));
    text_.turn_bound = std::max(text_.turn_bound, turn);
    ++text_.points;
  }

  /// One PO[..]; gives how far its rounding moves the axis, mm or rad: ends by half a digit, a2 by a quarter
  /// of length², a3 by 2/(3√3) length³ of half a digit, because a1 is implied by the ends.
  double appendAxis(std::string& line, int axis, const SpanPolynomial& polynomial, double length) const {
    const int decimals = context_.writer.decimalsOf(axis);
    line += fmt::format(" PO[{}]=(", context_.writer.axes().axes[static_cast<std::size_t>(axis)].id.text());
    context_.writer.appendNumber(line, polynomial.end, decimals);
    line += ", ";
    context_.writer.appendNumber(line, polynomial.a2, kPolynomialDecimals);
    line += ", ";
    context_.writer.appendNumber(line, polynomial.a3, kPolynomialDecimals);
    line += ")";
    const double half_digit = 0.5 * std::pow(10.0, -decimals);
    const double half_coefficient = 0.5 * std::pow(10.0, -kPolynomialDecimals);
    const double off =
        half_digit + half_coefficient * (0.25 * length * length + 0.385 * length * length * length);
    return off * std::abs(context_.writer.frame().factor[static_cast<std::size_t>(axis)]);
  }

  const PieceContext& context_;
  std::vector<int> axes_;
  BSpline curve_;
  PieceText text_;
};

}  // namespace

Result<PieceText> writeNurbs(const PieceContext& context) {
  const Result<std::vector<nc::AxisValues>> values = controlValues(context);
  if (!values) return values.error();
  const std::vector<double>& knots = context.piece.fitted->curve.knots();
  PieceText text;
  const auto knot = [&](std::string& line, std::size_t i) {
    line += "K";
    context.writer.appendNumber(line, knots[i], kKnotDecimals);
  };
  for (std::size_t i = 0; i < knots.size(); ++i) {
    std::string line = i == 0 ? "G06.2 P4 " : "";
    knot(line, i);
    if (i < values->size()) {
      context.writer.appendWords(line, (*values)[i]);
      addRounding(context, (*values)[i], context.writer.rounded((*values)[i]), text);
    }
    if (i == 0) appendFeed(context, line);
    text.text += line + context.section.line_end;
  }
  text.text += "G01" + context.section.line_end;
  text.points = values->size();
  return checked(context, std::move(text));
}

Result<PieceText> writeBspline(const PieceContext& context) {
  const Result<std::vector<nc::AxisValues>> values = controlValues(context);
  if (!values) return values.error();
  const BSpline& curve = context.piece.fitted->curve;
  PieceText text;
  for (std::size_t i = 1; i < values->size(); ++i) {  // the first control point is where the tool stands
    std::string line = i == 1 ? "BSPLINE SD=3" : "";
    context.writer.appendWords(line, (*values)[i]);
    addRounding(context, (*values)[i], context.writer.rounded((*values)[i]), text);
    if (i <= curve.spanCount()) {  // as many intervals as spans
      line += " PL=";
      context.writer.appendNumber(line, curve.knots()[i + 3] - curve.knots()[i + 2], kKnotDecimals);
    }
    if (i == 1) appendFeed(context, line);
    text.text += (i == 1 ? line : line.substr(1)) + context.section.line_end;
  }
  text.text += "G01" + context.section.line_end;
  text.points = values->size();
  return checked(context, std::move(text));
}

Result<PieceText> writePolynomials(const PieceContext& context) {
  const Result<std::vector<nc::AxisValues>> values = controlValues(context);
  if (!values) return values.error();
  const std::vector<int> axes = context.writer.wordOrder();
  return checked(context, PolynomialText(context, axes, wordCurve(context, *values, axes)).run());
}

}  // namespace nineline::smoothing
