// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/plots/tracesource.h"

namespace mb {

/// A finished trace in memory: a trial, a prediction, a file.
class FixedTrace : public TraceSource {
public:
    explicit FixedTrace(std::vector<PlotPoint> points, QString foot = {});
    void columns(double from, double to, int pixels, std::vector<PlotPoint> &points) const override;
    std::optional<double> latest() const override;
    QString foot() const override { return m_foot; }
    const std::vector<PlotPoint> &points() const { return m_points; }

private:
    std::vector<PlotPoint> m_points;
    QString m_foot;
};

} // namespace mb
