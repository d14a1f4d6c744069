// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/wallclock.h"
#include "widgets/plots/qcustomplotkeywords.h"

#include <optional>
#include <utility>

namespace mb {

/// Tick labels with a true minus and grouped thousands.
class NumberTicker : public QCPAxisTicker {
public:
    NumberTicker() { setTickCount(4); }
    /// No label touches the next: how high one is, and how long the axis, px. false: they were as far apart already.
    bool spaceLabels(int label, int axis);

protected:
    /// Finer where a round step would leave fewer than two labels, but never so fine that they touch.
    double getTickStep(const QCPRange &range) override;
    QString getTickLabel(double tick, const QLocale &locale, QChar formatChar, int precision) override;
    [[nodiscard]] double leastStep(const QCPRange &range) const { return m_labelShare * range.size(); }

private:
    double m_labelShare = 0.0;
};

/// A logarithmic axis: 1 of each decade, of few also 2 and 5.
class DecadeTicker : public QCPAxisTickerLog {
protected:
    QVector<double> createTickVector(double tickStep, const QCPRange &range) override;
    QString getTickLabel(double tick, const QLocale &locale, QChar formatChar, int precision) override;
};

/// Time as seconds from an origin, or as the time of day when there is a clock for its keys and no event to count from.
class TimeTicker : public QCPAxisTicker {
public:
    TimeTicker() { setTickCount(8); }
    void setClock(std::optional<WallClock> clock) { m_clock = std::move(clock); }
    [[nodiscard]] const std::optional<WallClock> &clock() const { return m_clock; }
    /// The key that is 0 and has a tick; empty: there is none.
    void setEvent(std::optional<double> key);
    QString text(double key, double step) const;
    /// Labels are seconds, from an origin or of the minute, and need that unit: as they were made last.
    [[nodiscard]] bool showsSeconds() const { return !m_clock || m_event || m_step < 1.0; }

protected:
    double getTickStep(const QCPRange &range) override;
    QString getTickLabel(double tick, const QLocale &locale, QChar formatChar, int precision) override;

private:
    std::optional<WallClock> m_clock;
    std::optional<double> m_event;
    double m_step = 1.0;
};

} // namespace mb
