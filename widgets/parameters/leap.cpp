// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/leap.h"

#include "widgets/common/numberformat.h"
#include "widgets/parameters/valuetext.h"

#include <QCoreApplication>

#include <cmath>

namespace mb {
namespace {

struct LeapText {
    Q_DECLARE_TR_FUNCTIONS(LeapText)
};

/// A slider of one decade either way stays below it.
constexpr double usual = 10.05;

} // namespace

std::optional<double> leap(const Parameter &parameter, std::optional<std::int64_t> from, std::int64_t to)
{
    if (!isGain(parameter) || !from || *from == 0 || to == 0)
        return std::nullopt;
    const double factor = std::abs(static_cast<double>(to) / static_cast<double>(*from));
    return factor > usual || factor < 1.0 / usual ? std::optional(factor) : std::nullopt;
}

QString leapText(const Parameter &parameter, std::int64_t from, double factor)
{
    const auto times
        = [](double number) { return number < 100.0 ? formatSignificant(number, 2) : formatNumber(number); };
    const QString now = valueText(parameter, from);
    return factor > 1.0 ? LeapText::tr("%1 × as large as now, %2.").arg(times(factor), now)
                        : LeapText::tr("%1 × smaller than now, %2.").arg(times(1.0 / factor), now);
}

bool isSensibleFix(const Parameter &parameter, std::optional<std::int64_t> known, std::int64_t proposed)
{
    return !isGain(parameter) || (known && *known != 0 && !leap(parameter, known, proposed));
}

} // namespace mb
