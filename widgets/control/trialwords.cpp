// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/trialwords.h"

#include "experiment/verdict.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/numberformat.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>

namespace mb {
namespace {

struct TrialWords {
    Q_DECLARE_TR_FUNCTIONS(mb::TrialWords)
};

struct Row {
    std::string_view key;
    const char *name;
    double same;
    const char *less;
    const char *more;
};

constexpr auto better = QT_TRANSLATE_NOOP("mb::TrialWords", "better");
constexpr auto worse = QT_TRANSLATE_NOOP("mb::TrialWords", "worse");
constexpr auto faster = QT_TRANSLATE_NOOP("mb::TrialWords", "faster");
constexpr auto slower = QT_TRANSLATE_NOOP("mb::TrialWords", "slower");

const std::array<Row, 11> rows{{
    {"rise", QT_TRANSLATE_NOOP("mb::TrialWords", "Rise 10–90"), 1.0, faster, slower},
    {"settle", QT_TRANSLATE_NOOP("mb::TrialWords", "Settle 2 %"), 1.0, better, worse},
    {"overshoot", QT_TRANSLATE_NOOP("mb::TrialWords", "Overshoot"), 0.1, better, worse},
    {"undershoot", QT_TRANSLATE_NOOP("mb::TrialWords", "Undershoot"), 0.1, better, worse},
    {"sse", QT_TRANSLATE_NOOP("mb::TrialWords", "Steady error"), 0.02, better, worse},
    {"iae", QT_TRANSLATE_NOOP("mb::TrialWords", "IAE"), 1.0, better, worse},
    {"itae", QT_TRANSLATE_NOOP("mb::TrialWords", "ITAE"), 0.1, better, worse},
    {"peak_current", QT_TRANSLATE_NOOP("mb::TrialWords", "Peak current"), 0.1, better, worse},
    {"rms_duty", QT_TRANSLATE_NOOP("mb::TrialWords", "Duty chatter"), 0.02, better, worse},
    {"saturated", QT_TRANSLATE_NOOP("mb::TrialWords", "Saturated"), 0.1, better, worse},
    {"noise", QT_TRANSLATE_NOOP("mb::TrialWords", "Noise σ"), 0.02, better, worse},
}};

} // namespace

QString profileText(tuning::Profile profile)
{
    switch (profile) {
    case tuning::Profile::Step: return TrialWords::tr("Step and back");
    case tuning::Profile::Square: return TrialWords::tr("Square");
    case tuning::Profile::Ramp: return TrialWords::tr("Ramp");
    case tuning::Profile::Sine: return TrialWords::tr("Sine");
    case tuning::Profile::Chirp: return TrialWords::tr("Chirp");
    case tuning::Profile::Prbs: return TrialWords::tr("PRBS");
    }
    return {};
}

QString guardText(tuning::EndReason reason)
{
    return tableText(tuning::endingLabel(reason));
}

QString flagText(const std::string &flag, const tuning::Trial &trial)
{
    if (flag == tuning::flag::aborted)
        return TrialWords::tr("stopped: %1")
            .arg(trial.reason == tuning::EndReason::None ? TrialWords::tr("nobody saw its end")
                                                         : guardText(trial.reason));
    if (flag == tuning::flag::lostSamples)
        return TrialWords::tr("%1 samples lost").arg(formatCount(static_cast<qint64>(trial.lost)));
    if (flag == tuning::flag::saturated && trial.metrics.saturated)
        return TrialWords::tr("saturated %1 %").arg(formatNumber(*trial.metrics.saturated * 100.0, 0));
    return tableText(tuning::flagLabel(flag));
}

QString stimulusText(const tuning::Trial &trial, const DisplayUnits &units)
{
    const ShownUnit unit = shownUnit(trial.mode, units);
    const auto number = [&unit](double value) {
        const double shown = value * unit.scale;
        return shown == std::round(shown) ? formatNumber(shown) : formatNumber(shown, 2);
    };
    QString text = QStringLiteral("%1 ▸ %2").arg(number(trial.stimulus.from), number(trial.stimulus.to));
    if (trial.stimulus.profile != tuning::Profile::Step)
        text = profileText(trial.stimulus.profile) + QLatin1Char(' ') + text;
    if (trial.repeat > 1)
        text += QStringLiteral(" ×%1").arg(trial.repeat);
    return text;
}

MetricWord metricWord(std::string_view key)
{
    const tuning::MetricKey *const metric = tuning::findMetric(key);
    const auto *const row = std::ranges::find(rows, key, &Row::key);
    if (!metric || row == rows.end())
        return {};
    return {TrialWords::tr(row->name), metric->scale, metric->decimals, qt(metric->unit), true, row->same,
        TrialWords::tr(row->less), TrialWords::tr(row->more)};
}

} // namespace mb
