// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/frequencyresponse.h"
#include "tuning/margins.h"
#include "widgets/common/theme.h"

#include <QWidget>

#include <optional>

namespace mb {

class CurveLegend;
class CurvePlot;
struct Curve;

/// Magnitude and phase of a loop over the same frequencies, below each other, beside the motor alone, with crossover and margins in
/// words at their places.
class BodePlot : public QWidget {
    Q_OBJECT
public:
    explicit BodePlot(const ThemeSource &theme, QWidget *parent = nullptr);

    void setLoop(Mode loop, const tuning::PlantModel &plant, const tuning::ContinuousGains &gains,
        const tuning::Margins &margins);
    /// What was measured of the motor, over its model, with the dead time of the model: as lines the points up to the first that may not
    /// be trusted, faint what is beyond. Empty: nothing was. Holds for the next setLoop().
    void setMeasured(std::vector<tuning::FrequencyPoint> points) { m_measured = std::move(points); }
    /// Other gains to compare with, and their name: the same loop, dashed. Holds for the next setLoop().
    void setCompared(const std::optional<tuning::ContinuousGains> &gains, const QString &name);
    void clear();
    void setWatermark(const QString &text);
    [[nodiscard]] CurvePlot &magnitude() { return *m_magnitude; }
    [[nodiscard]] CurvePlot &phase() { return *m_phase; }
    /// Hz, up to which every point that was measured is to be trusted; 0: nothing was.
    [[nodiscard]] double usableUpTo() const;

private:
    void addMeasured(
        Mode loop, const tuning::PlantModel &plant, std::vector<Curve> &magnitude, std::vector<Curve> &phase) const;
    void showBehind(Mode loop, const tuning::PlantModel &plant, double middle);
    void name();

    std::vector<tuning::FrequencyPoint> m_measured;
    std::optional<tuning::ContinuousGains> m_compared;
    QString m_comparedName;
    CurveLegend *m_legend = nullptr;
    CurvePlot *m_magnitude = nullptr;
    CurvePlot *m_phase = nullptr;
};

} // namespace mb
