// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QWidget>

#include <cstdint>

namespace mb {

/// How finely a gain can still be set: four bars, filled above 10, 50, 500 and 5000 steps of the device's integer, and
/// the number of steps. Under 50 it is coarse (caution), under 10 next to useless (danger); 0 means off.
class ResolutionMeter : public QWidget {
    Q_OBJECT
public:
    explicit ResolutionMeter(const ThemeSource &theme, QWidget *parent = nullptr);

    void setSteps(std::int64_t steps);
    [[nodiscard]] static int barsOf(std::int64_t steps);
    [[nodiscard]] static Tone toneOf(std::int64_t steps);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    [[nodiscard]] QString words() const;

    const ThemeSource &m_theme;
    std::int64_t m_steps = 0;
};

} // namespace mb
