// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/metricwords.h"

#include "experiment/verdict.h"
#include "files/qttext.h"
#include "report/htmltext.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace mb {
namespace {

struct Row {
    std::string_view key;
    const char *name;
};

constexpr std::array<Row, 11> metricRows{{
    {"rise", QT_TRANSLATE_NOOP("mb::ReportText", "Rise, 10 to 90 %")},
    {"settle", QT_TRANSLATE_NOOP("mb::ReportText", "Settling to 2 %")},
    {"overshoot", QT_TRANSLATE_NOOP("mb::ReportText", "Overshoot")},
    {"undershoot", QT_TRANSLATE_NOOP("mb::ReportText", "Undershoot of the way back")},
    {"sse", QT_TRANSLATE_NOOP("mb::ReportText", "Error at rest")},
    {"iae", QT_TRANSLATE_NOOP("mb::ReportText", "IAE")},
    {"itae", QT_TRANSLATE_NOOP("mb::ReportText", "ITAE")},
    {"peak_current", QT_TRANSLATE_NOOP("mb::ReportText", "Peak current")},
    {"rms_duty", QT_TRANSLATE_NOOP("mb::ReportText", "Chatter of the duty, RMS")},
    {"saturated", QT_TRANSLATE_NOOP("mb::ReportText", "Time at the duty limit")},
    {"noise", QT_TRANSLATE_NOOP("mb::ReportText", "Noise of the measurement")},
}};

QString profileWord(tuning::Profile profile)
{
    switch (profile) {
    case tuning::Profile::Step: return ReportText::tr("step");
    case tuning::Profile::Square: return ReportText::tr("square wave");
    case tuning::Profile::Ramp: return ReportText::tr("ramp");
    case tuning::Profile::Sine: return ReportText::tr("sine");
    case tuning::Profile::Chirp: return ReportText::tr("chirp");
    case tuning::Profile::Prbs: return ReportText::tr("random steps");
    }
    return {};
}

} // namespace

MetricWords metricWords(std::string_view key)
{
    const tuning::MetricKey *const metric = tuning::findMetric(key);
    if (!metric)
        return {qt(key), 1.0, 3, {}};
    const auto *const row = std::ranges::find(metricRows, key, &Row::key);
    return {row == metricRows.end() ? qt(key) : ReportText::tr(row->name), metric->scale, metric->decimals,
        qt(metric->unit)};
}

QString metricText(std::string_view key, const std::optional<double> &value)
{
    const MetricWords words = metricWords(key);
    return value ? fixedFigure(*value * words.scale, words.decimals, words.unit) : figure(std::nullopt);
}

QString modeWord(Mode mode)
{
    switch (mode) {
    case Mode::Velocity: return ReportText::tr("velocity");
    case Mode::Position: return ReportText::tr("position");
    case Mode::Current: return ReportText::tr("current");
    case Mode::Duty: return ReportText::tr("duty");
    default: return qt(toString(mode));
    }
}

QString stimulusWords(const tuning::Trial &trial)
{
    const tuning::Stimulus &stimulus = trial.stimulus;
    const bool duty = trial.mode == Mode::Duty;
    const double scale = duty ? 100.0 : 1.0;
    QString text = profileWord(stimulus.profile) + QStringLiteral(" ") + figure(stimulus.from * scale, 6)
        + QStringLiteral(" → ") + figure(stimulus.to * scale, 6, duty ? QStringLiteral("%") : qt(unitOf(trial.mode)));
    if (trial.repeat > 1)
        text += QStringLiteral(", ") + ReportText::tr("%1 times").arg(trial.repeat);
    return text;
}

QString endingWords(const tuning::Trial &trial)
{
    if (trial.reason == tuning::EndReason::Done)
        return ReportText::tr("done");
    if (trial.reason == tuning::EndReason::None)
        return ReportText::tr("cut off");
    if (trial.reason == tuning::EndReason::Interrupted)
        return ReportText::tr("interrupted");
    const std::string label(tuning::endingLabel(trial.reason));
    return ReportText::tr("stopped by the guard “%1”").arg(QCoreApplication::translate("table", label.c_str()));
}

} // namespace mb
