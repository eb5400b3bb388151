#include "core/smoothing/smoothing.h"

#include <algorithm>

#include "core/smoothing/piece_output.h"
#include "core/smoothing/quality.h"

namespace nineline::smoothing {

namespace {

constexpr double kFitShareStraight = 0.6;  // of the tolerance; the rest is for chords and digits
constexpr double kFitShareSpline = 0.9;
constexpr int kSamplesPerChord = 4;
constexpr int kLeastLinearDecimals = 4;
constexpr int kLeastRotaryDecimals = 5;

/// The lines of a text with their ends.
std::vector<std::string_view> linesOf(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    const std::size_t size = end == std::string_view::npos ? text.size() : end + 1;
    lines.push_back(text.substr(0, size));
    text.remove_prefix(size);
  }
  return lines;
}

nc::NumberStyle finer(nc::NumberStyle style, const SmoothingOptions& options) {
  const int least = style.inch ? kLeastLinearDecimals + 1 : kLeastLinearDecimals;
  style.linear_decimals = options.linear_decimals.value_or(std::max(style.linear_decimals, least));
  style.rotary_decimals =
      options.rotary_decimals.value_or(std::max(style.rotary_decimals, kLeastRotaryDecimals));
  style.trailing_zeros = false;
  style.keep_point = true;  // a number without a point may count the least increment
  return style;
}

/// Smooths the sections of one program.
class Smoother {
 public:
  Smoother(const Machine& machine, const nc::InterpreterOptions& setup, const SmoothingOptions& options,
           const nc::NumberStyle& style, std::string_view text, const CurveSink& sink)
      : machine_(machine),
        axes_(setup.axes),
        options_(options),
        style_(style),
        lines_(linesOf(text)),
        sink_(sink),
        jumps_(machine) {}

  Result<void> add(const PathSection& section) {
    copyLines(section.first_line - 1);
    const Result<AxisMotion> motion = AxisMotion::make(machine_, section);
    if (!motion) {
      warn(motion.error(), section.first_line);
      copyLines(section.last_line);
      return {};
    }
    if (Result<void> carried = requireCarried(section, *motion); !carried) return carried;
    const WordWriter writer(axes_, section.frame, style_, motion->words());
    const PointRows rows = motion->rowsOf(section);
    for (const auto& [from, to] : runs(section)) {
      const auto first = static_cast<Eigen::Index>(from);
      const auto count = static_cast<Eigen::Index>(to - from + 1);
      std::vector<PathPiece> pieces = fitPath(rows.middleRows(first, count), fitTolerances());
      const bool none = std::none_of(pieces.begin(), pieces.end(),
                                     [](const PathPiece& piece) { return piece.fitted.has_value(); });
      if (none && count > 3) warnUnfitted(section.points[from + 1].line);
      for (PathPiece& piece : pieces) {
        piece.first += from;
        piece.last += from;
        addPiece({section, piece, *motion, writer, options_.tolerance, options_.turn_tolerance});
      }
    }
    return {};
  }

  SmoothedText finish(const ToolPath& path) {
    copyLines(lines_.size());
    report_.points_in = path.motions;
    report_.points_out += path.motions - report_.points_smoothed;
    report_.jumps = jumps_.result();
    Diagnostics all = path.diagnostics;
    all.append(report_.diagnostics);
    report_.diagnostics = std::move(all);
    return {std::move(text_), std::move(report_)};
  }

 private:
  [[nodiscard]] FitTolerances fitTolerances() const {
    const double share = options_.format == Format::G01 ? kFitShareStraight : kFitShareSpline;
    FitTolerances tolerances;
    tolerances.position = share * options_.tolerance;
    tolerances.turn = share * options_.turn_tolerance;
    tolerances.criterion = options_.criterion;
    tolerances.chord = options_.chord;
    tolerances.corner = options_.corner;
    return tolerances;
  }

  /// Splines stand for whole motions of one feed.
  [[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> runs(const PathSection& section) const {
    std::vector<std::pair<std::size_t, std::size_t>> result;
    std::size_t from = 0;
    const std::size_t last = section.points.size() - 1;
    for (std::size_t j = 1; j < last && options_.format != Format::G01; ++j) {
      if (section.points[j + 1].feed == section.points[j].feed) continue;
      result.emplace_back(from, j);
      from = j;
    }
    result.emplace_back(from, last);
    return result;
  }

  /// What a format cannot carry is said (theory.md, 5.7).
  Result<void> requireCarried(const PathSection& section, const AxisMotion& motion) const {
    if (options_.format == Format::G01 || !motion.hasRotary() || section.tool_centre_point) return {};
    return badInput(
        "smoothing.format",
        "Rotary axes move here without tool-centre-point control: the paths of the linear axes are "
        "then no splines, and this format cannot carry them. Expected G43.4 or TRAORI, or --format "
        "g01.",
        {}, section.first_line);
  }

  Result<PieceText> write(const PieceContext& context) const {
    switch (options_.format) {
      case Format::FanucNurbs:
        return writeNurbs(context);
      case Format::SiemensBspline:
        return writeBspline(context);
      case Format::SiemensPoly:
        return writePolynomials(context);
      default:
        return writeStraight(context);
    }
  }

  void addPiece(const PieceContext& context) {
    const std::vector<PathPoint>& points = context.section.points;
    const std::size_t from_line =
        context.piece.first == 0 ? context.section.first_line - 1 : points[context.piece.first].line;
    const std::size_t to_line = points[context.piece.last].line;
    ++segment_;
    if (!context.piece.fitted) {
      copyLines(to_line);
      showPoints(context);
      return;
    }
    const Result<PieceText> written = write(context);
    if (!written) {
      warn(written.error(), from_line + 1);
      copyLines(to_line);
      showPoints(context);
      return;
    }
    if (context.piece.first == 0 && !context.section.label.empty()) text_ += context.section.label + ' ';
    text_ += written->text;
    next_line_ = to_line;
    count(context, *written);
  }

  void count(const PieceContext& context, const PieceText& written) {
    const FittedCurve& fitted = *context.piece.fitted;
    ++report_.segments;
    report_.points_out += written.points;
    report_.points_smoothed += context.piece.last - context.piece.first;
    report_.control_points += static_cast<std::size_t>(fitted.curve.control().rows());
    report_.max_position_error = std::max(report_.max_position_error, fitted.errors.position);
    report_.max_turn_error = std::max(report_.max_turn_error, fitted.errors.turn);
    report_.bound = std::max(report_.bound, fitted.errors.bound + written.bound);
    report_.turn_bound = std::max(report_.turn_bound, fitted.errors.turn_bound + written.turn_bound);
    compare(context);
  }

  /// Samples the programmed and the smooth motion of each axis, several places for each programmed point.
  void compare(const PieceContext& context) {
    const FittedCurve& fitted = *context.piece.fitted;
    std::vector<double> places;
    std::vector<nc::AxisValues> before;
    std::vector<nc::AxisValues> after;
    for (std::size_t j = 0; j < fitted.parameters.size(); ++j) {
      const nc::AxisValues& start = context.section.points[context.piece.first + j].values;
      const bool is_last = j + 1 == fitted.parameters.size();
      for (int part = 0; part < (is_last ? 1 : kSamplesPerChord); ++part) {
        const double share = static_cast<double>(part) / kSamplesPerChord;
        nc::AxisValues values = start;
        double u = fitted.parameters[j];
        if (part > 0) {
          u += share * (fitted.parameters[j + 1] - u);
          const nc::AxisValues& end = context.section.points[context.piece.first + j + 1].values;
          for (std::size_t k = 0; k < values.size(); ++k) values[k] += share * (end[k] - start[k]);
        }
        const CurvePoint point = fitted.curve.at(u);
        const Result<nc::AxisValues> smooth = context.motion.valuesAt(point, values);
        places.push_back(u);
        before.push_back(values);
        after.push_back(smooth ? *smooth : values);
        if (sink_ && part == 0) sink_({segment_, true, after.back(), point.head<3>()});
      }
    }
    jumps_.add(places, before, after);
  }

  void showPoints(const PieceContext& context) const {
    if (!sink_) return;
    for (std::size_t j = context.piece.first; j <= context.piece.last; ++j)
      sink_({segment_, false, context.section.points[j].values, context.section.points[j].tip});
  }

  /// Copies what is left of the program up to this line, byte for byte.
  void copyLines(std::size_t last) {
    for (; next_line_ < std::min(last, lines_.size()); ++next_line_) text_ += lines_[next_line_];
  }

  void warnUnfitted(std::size_t line) {
    report_.diagnostics.countedWarning(
        "smoothing.unfitted",
        options_.criterion == Criterion::Polyline
            ? "No smooth curve stays so near to the straight lines: they bulge by more than the tolerance "
              "allows. These lines stay as programmed; --criterion points refers to the points."
            : "No smooth curve meets the tolerance here. These lines stay as programmed.",
        line);
  }

  void warn(const Error& error, std::size_t line) {
    report_.diagnostics.countedWarning(error.code, error.text + " These lines stay as programmed.", line);
  }

  const Machine& machine_;
  const nc::AxisLayout& axes_;
  const SmoothingOptions& options_;
  const nc::NumberStyle& style_;
  std::vector<std::string_view> lines_;
  const CurveSink& sink_;
  JumpStatistics jumps_;
  std::size_t next_line_ = 0;  // lines copied or replaced so far
  std::size_t segment_ = 0;
  std::string text_;
  SmoothingReport report_;
};

void sayWhatIsUnproven(const SmoothingOptions& options, const ToolPath& path, Diagnostics& diagnostics) {
  const bool siemens = options.format == Format::SiemensBspline || options.format == Format::SiemensPoly;
  if (options.format == Format::G01) return;
  if (siemens != (path.dialect == nc::Dialect::Siemens))
    diagnostics.warning("smoothing.dialect", "The splines are written for another control than the program.");
  if (options.format == Format::SiemensBspline)
    diagnostics.warning(
        "smoothing.bspline",
        "How BSPLINE counts its PL intervals was not tried on a control: check the path there.");
}

}  // namespace

Result<SmoothedText> smoothText(const Machine& machine, const std::string& name, std::string text,
                                const nc::InterpreterOptions& setup, const SmoothingOptions& options,
                                Progress& progress, const CurveSink& sink) {
  nc::MemoryText source(name, text);
  const Result<ToolPath> path = readToolPath(machine, source, setup);
  if (!path) return path.error();
  const Result<nc::NumberStyle> learned = nc::learnNumberStyle(source, path->dialect, setup.axes);
  if (!learned) return learned.error();
  const nc::NumberStyle style = finer(*learned, options);
  Smoother smoother(machine, setup, options, style, text, sink);
  for (std::size_t k = 0; k < path->sections.size(); ++k) {
    if (progress.isCancelled()) return cancelled();
    progress.report(static_cast<double>(k) / static_cast<double>(path->sections.size()), "smooth");
    if (Result<void> added = smoother.add(path->sections[k]); !added) {
      Error error = added.error();
      error.source = name;
      return error;
    }
  }
  SmoothedText smoothed = smoother.finish(*path);
  sayWhatIsUnproven(options, *path, smoothed.report.diagnostics);
  return smoothed;
}

Json reportToJson(const SmoothingReport& report) {
  Json json = Json::object();
  json.set("points_in", report.points_in).set("points_out", report.points_out);
  json.set("segments", report.segments);
  json.set("max_position_error_um", umFromMm(report.max_position_error));
  json.set("max_orientation_error_deg", degFromRad(report.max_turn_error));
  json.set("bound_um", umFromMm(report.bound)).set("bound_orientation_deg", degFromRad(report.turn_bound));
  json.set("continuity", 2);
  json.set("control_points", report.control_points).set("points_smoothed", report.points_smoothed);
  Json jumps = Json::object();
  for (const AxisJumps& one : report.jumps) {
    const double unit = one.rotary ? degFromRad(1.0) : 1.0;
    Json axis = Json::object();
    axis.set("before_max", unit * one.before_max).set("after_max", unit * one.after_max);
    axis.set("before_rms", unit * one.before_rms).set("after_rms", unit * one.after_rms);
    jumps.set(one.axis.text(), std::move(axis));
  }
  json.set("second_difference_jumps", std::move(jumps));
  Json warnings = Json::array();
  for (const Diagnostic& one : report.diagnostics.all()) {
    Json warning = Json::object();
    warning.set("code", one.code).set("text", one.text).set("line", one.line).set("count", one.count);
    warnings.push(std::move(warning));
  }
  return json.set("warnings", std::move(warnings));
}

}  // namespace nineline::smoothing
