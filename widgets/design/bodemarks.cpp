// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/design/bodemarks.h"

#include "widgets/common/numberformat.h"

#include <QCoreApplication>

#include <cmath>
#include <limits>
#include <numbers>

namespace mb {
namespace {

using Kind = CurveMark::Kind;

struct BodeText {
    Q_DECLARE_TR_FUNCTIONS(mb::BodeText)
};

constexpr double halfTurn = 180.0; ///< degrees
constexpr double topOfPlot = std::numeric_limits<double>::max();

double inDecibel(double ratio)
{
    return 20.0 * std::log10(ratio);
}

CurveMark markWords(double x, double y, const QString &text, Qt::Alignment side)
{
    return {Kind::Words, x, y, 0.0, text, side, true};
}

void markCrossover(const tuning::Margins &margins, BodeMarks &into)
{
    const double hertz = margins.crossover / (2.0 * std::numbers::pi);
    const QString at = formatSignificant(hertz, 3);
    for (std::vector<CurveMark> *marks : {&into.magnitude, &into.phase})
        marks->push_back({Kind::Upright, hertz});
    into.magnitude.push_back({Kind::Ring, hertz, 0.0});
    into.magnitude.push_back(
        markWords(hertz, 0.0, BodeText::tr("crossover %1 Hz").arg(at), Qt::AlignRight | Qt::AlignTop));
    into.phase.push_back({Kind::Span, hertz, -halfTurn, margins.phase - halfTurn});
    into.phase.push_back(markWords(hertz, margins.phase / 2.0 - halfTurn,
        BodeText::tr("PM %1° at %2 Hz").arg(formatNumber(margins.phase), at), Qt::AlignLeft | Qt::AlignVCenter));
}

/// Of the loop nothing is known beyond what was measured.
void markTurnover(const tuning::Margins &margins, double usable, BodeMarks &into)
{
    const double hertz = margins.turnover / (2.0 * std::numbers::pi);
    const double gap = inDecibel(margins.gain);
    const bool isKnown = usable == 0.0 || hertz <= usable;
    for (std::vector<CurveMark> *marks : {&into.magnitude, &into.phase})
        marks->push_back({Kind::Upright, hertz});
    into.phase.push_back({Kind::Ring, hertz, -halfTurn});
    into.magnitude.push_back({Kind::Span, hertz, -gap, 0.0});
    into.magnitude.push_back(markWords(hertz, -gap / 2.0,
        isKnown ? BodeText::tr("GM %1 dB at %2 Hz").arg(formatNumber(gap, 1), formatSignificant(hertz, 3))
                : BodeText::tr("GM –, beyond what was measured"),
        Qt::AlignLeft | Qt::AlignBottom));
}

} // namespace

BodeMarks bodeMarks(const tuning::Margins &margins, double usable)
{
    BodeMarks marks;
    if (usable > 0.0) {
        for (std::vector<CurveMark> *both : {&marks.magnitude, &marks.phase})
            both->push_back({Kind::Beyond, usable});
        marks.magnitude.push_back(markWords(usable, topOfPlot,
            BodeText::tr("usable up to %1 Hz").arg(formatSignificant(usable, 2)), Qt::AlignLeft | Qt::AlignBottom));
    }
    marks.phase.push_back({Kind::Level, 0.0, -halfTurn});
    if (margins.crossover > 0.0)
        markCrossover(margins, marks);
    if (margins.turnover > 0.0)
        markTurnover(margins, usable, marks);
    if (!margins.isStable()) {
        marks.magnitude.push_back(markWords(
            margins.crossover / (2.0 * std::numbers::pi), 0.0, marginText(margins), Qt::AlignRight | Qt::AlignBottom));
        marks.magnitude.back().tone = Tone::Danger;
    }
    return marks;
}

QString marginText(const tuning::Margins &margins)
{
    if (!margins.isStable())
        return BodeText::tr("unstable");
    QStringList parts{
        BodeText::tr("crossover %1 Hz").arg(formatSignificant(margins.crossover / (2.0 * std::numbers::pi), 3)),
        BodeText::tr("phase margin %1°").arg(formatNumber(margins.phase))};
    if (std::isfinite(margins.gain))
        parts << BodeText::tr("gain margin %1 dB").arg(formatNumber(inDecibel(margins.gain), 1));
    parts << BodeText::tr("Ms %1").arg(formatNumber(margins.ms, 2));
    return parts.join(QStringLiteral(" · "));
}

} // namespace mb
