// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/frequencyresponse.h"
#include "tuning/margins.h"
#include "widgets/common/theme.h"

#include <QWidget>

namespace mb {

class CurvePlot;
struct Curve;

/// Magnitude and phase of a loop over the same frequencies, beside the motor alone, with crossover and margins in words.
class BodePlot : public QWidget {
    Q_OBJECT
public:
    explicit BodePlot(const ThemeSource &theme, QWidget *parent = nullptr);

    void setLoop(Mode loop, const tuning::PlantModel &plant, const tuning::ContinuousGains &gains,
        const tuning::Margins &margins);
    /// What was measured of the motor, over its model: the points up to the first that may not be trusted, with the dead time of the
    /// model. Empty: nothing was. Holds for the next setLoop().
    void setMeasured(std::vector<tuning::FrequencyPoint> points);
    void clear();
    void setWatermark(const QString &text);
    [[nodiscard]] CurvePlot &magnitude() { return *m_magnitude; }
    [[nodiscard]] CurvePlot &phase() { return *m_phase; }

private:
    void addMeasured(
        Mode loop, const tuning::PlantModel &plant, std::vector<Curve> &magnitude, std::vector<Curve> &phase) const;

    std::vector<tuning::FrequencyPoint> m_measured;
    CurvePlot *m_magnitude = nullptr;
    CurvePlot *m_phase = nullptr;
};

/// "crossover 0.63 Hz, phase margin 67°, gain margin 11.9 dB, Ms 1.44".
[[nodiscard]] QString marginText(const tuning::Margins &margins);

} // namespace mb
