// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/kepttrial.h"
#include "model/snapshot.h"
#include "widgets/common/theme.h"

#include <QWidget>

#include <array>
#include <vector>

namespace mb {

/// What is known of one loop of one motor, on the way from an unknown motor to gains that stay.
struct TuneKnowledge {
    const DeviceView *device = nullptr;
    int axis = 0;                      ///< 0: it has one motor
    std::vector<ParameterIndex> gains; ///< of the loop, in the slot that runs
    QString missing;                   ///< what the envelope lacks; empty: nothing
    std::int64_t identified = 0;       ///< the last trial that pushed the motor without a loop; 0: none
    bool staged = false;               ///< gains that are not written
    const KeptTrial *newest = nullptr; ///< of this loop
};

/// From the direction of the motor to gains that stay: what is done, what is next, what comes after it. A row of six; narrow, only the
/// step that is next has its word. Each tells in its tooltip what it rests on. GUI thread.
class TuneSteps : public QWidget {
    Q_OBJECT
public:
    enum Step { Direction, Envelope, Identify, Gains, Verify, Store, StepCount };

    explicit TuneSteps(const ThemeSource &theme, QWidget *parent = nullptr);
    /// Hidden where no loop is tuned.
    void show(const TuneKnowledge &known);
    void setFolded(bool folded);
    [[nodiscard]] bool isDone(Step step) const { return m_done.at(step); }
    /// The first that is not done; StepCount: all are.
    [[nodiscard]] int next() const;
    [[nodiscard]] QString toolTipOf(Step step) const { return m_tips.at(step); }
    /// With all its words.
    [[nodiscard]] int unfoldedWidth() const { return widthOf(false); }
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;

private:
    [[nodiscard]] static QString wordOf(int step);
    [[nodiscard]] int widthOf(bool folded) const;
    [[nodiscard]] int widthOfStep(int step, bool folded) const;
    [[nodiscard]] QFont fontOf(int step) const;
    void paintDisc(QPainter &painter, const QRect &box, int step) const;
    void tell();

    const ThemeSource &m_theme;
    std::array<bool, StepCount> m_done{};
    std::array<QString, StepCount> m_tips;
    bool m_folded = false;
};

} // namespace mb
