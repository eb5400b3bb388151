#include "ui/models/gap_text.h"

#include <QCoreApplication>

#include "ui/models/catalogue_texts.h"
#include "ui/models/component_names.h"
#include "ui/models/found_effects_model.h"

namespace nineline::models {

namespace {

/// Texts of the model gap in the user's language.
struct Gap {
  Q_DECLARE_TR_FUNCTIONS(Gap)
};

QString escaped(const std::string& text) { return QString::fromStdString(text).toHtmlEscaped(); }

QString number(double value) { return QString::number(value, 'f', value < 10.0 ? 2 : 1); }

QString item(const QString& text) { return QStringLiteral("<li>%1</li>").arg(text); }

QString section(const QString& heading, const QString& items) {
  if (items.isEmpty()) return {};
  return QStringLiteral("<p style='margin:6px 0 0 0'><b>%1</b></p><ul style='margin:0'>%2</ul>")
      .arg(heading.toHtmlEscaped(), items);
}

QString whereText(const discovery::DiscoveryReport& report) {
  QString items;
  for (const discovery::Place& place : report.where) {
    items += item(Gap::tr("%1 (%2 % of the gap)").arg(escaped(place.text)).arg(place.share_pct, 0, 'f', 0));
  }
  return section(Gap::tr("Where"), items);
}

QString faultsText(const discovery::DiscoveryReport& report) {
  QString items;
  for (const discovery::DataFault& fault : report.data_quality) {
    items += item(Gap::tr("%1, rows %2 to %3: %4")
                      .arg(escaped(fault.file))
                      .arg(fault.first_row)
                      .arg(fault.last_row)
                      .arg(escaped(fault.text)));
  }
  return section(Gap::tr("Look at the data"), items);
}

QString effectText(const discovery::FoundEffect& effect) {
  QString text =
      QStringLiteral("<p style='margin:0'><b>%1</b>, %2: %3</p>")
          .arg(effectName(effect.effect).toHtmlEscaped(), escaped(effect.joint + " · " + effect.component),
               parametersText(effect.parameters).toHtmlEscaped());
  if (const errors::EffectSpec* spec = errors::findEffectSpec(effect.effect)) text += shopFloorText(*spec);
  QString items;
  for (const discovery::LookAlikeFound& other : effect.lookalikes) {
    items += item(QStringLiteral("%1 · %2: %3")
                      .arg(effectName(other.effect).toHtmlEscaped(), escaped(other.joint),
                           catalogueText(other.why).toHtmlEscaped()));
  }
  return text + section(Gap::tr("Looks alike on these data"), items);
}

QString suspectedText(const discovery::DiscoveryReport& report) {
  QString items;
  for (const discovery::NotAccepted& one : report.suspected) {
    items += item(QStringLiteral("%1 · %2: %3")
                      .arg(effectName(one.effect).toHtmlEscaped(), escaped(one.joint), escaped(one.why)));
  }
  return section(Gap::tr("Suspected, not added"), items);
}

}  // namespace

QString verdictText(const discovery::DiscoveryReport& report) {
  switch (report.verdict) {
    case discovery::Verdict::None:
      return report.gap.significant
                 ? Gap::tr("Nothing is missing: what differs lies within the present parameters.")
                 : Gap::tr("Nothing is missing: no gap beyond the repeatability.");
    case discovery::Verdict::Explained:
      return Gap::tr("Named effects explain the gap.");
    case discovery::Verdict::Partly:
      return Gap::tr("Part of the gap has a name; a structured rest remains.");
    case discovery::Verdict::Unknown:
      return Gap::tr("Something is missing, and no known effect explains it.");
  }
  return {};
}

bool addsSomething(const discovery::DiscoveryReport& report) {
  if (!report.model) return false;
  for (const discovery::FoundEffect& effect : report.effects) {
    if (effect.model != nullptr) return true;
  }
  return !report.moved_parameters.empty();
}

QString shrinkText(const jobs::GapOutcome& gap) {
  QString rows;
  for (const jobs::GapStage& stage : gap.stages) {
    const QString name =
        stage.effect.empty()
            ? Gap::tr("present model")
            : QStringLiteral("+ %1 · %2").arg(effectName(stage.effect), QString::fromStdString(stage.joint));
    rows += QStringLiteral("<tr><td>%1</td><td align='right'>&nbsp;&nbsp;<b>%2 σ</b></td></tr>")
                .arg(name.toHtmlEscaped(), number(stage.rms_in_sigma));
  }
  const discovery::Gap& figures = gap.report.gap;
  QString text = QStringLiteral("<table>%1</table>").arg(rows);
  text +=
      Gap::tr("On runs not seen by the search: %1 → %2 µm, repeatability %3 µm")
          .arg(number(figures.holdout_before), number(figures.holdout_after), number(figures.noise_floor));
  if (figures.closed_pct) {
    text +=
        QStringLiteral("<br>") + Gap::tr("<b>%1 %</b> of the gap closed").arg(*figures.closed_pct, 0, 'f', 1);
  }
  return text;
}

QString detailsText(const discovery::DiscoveryReport& report, const discovery::FoundEffect* effect) {
  QString text = effect == nullptr ? QString() : effectText(*effect);
  text += whereText(report) + faultsText(report) + suspectedText(report);
  if (!report.next_experiment.empty()) {
    text += section(Gap::tr("Next measurement"), item(escaped(report.next_experiment)));
  }
  return text;
}

}  // namespace nineline::models
