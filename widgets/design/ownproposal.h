// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/autotune.h"
#include "tuning/proposals.h"
#include "widgets/common/card.h"

class QLabel;
class QSlider;

namespace mb {

class ChoiceMark;
class LogSlider;
class SliderScale;

/// The set between the three proposals: how quick the closed loop shall be and how robust, by two sliders in the units of the plant,
/// and what came of it, with every bound that held it back. Tells each move; whoever listens designs and shows.
class OwnProposal : public Card {
    Q_OBJECT
public:
    OwnProposal(const ThemeSource &theme, QWidget *parent);

    /// Where the sliders stand without telling anybody; `usual` is the response, s, at the tick of Speed,
    /// `usualMs` the sensitivity at that of Damping.
    void setWish(double response, double ms, double usual, double usualMs);
    [[nodiscard]] double response() const; ///< s, as asked
    [[nodiscard]] double ms() const;
    /// What the wish gives, or why the device cannot have it.
    void show(const Result<tuning::Proposal> &proposal);
    void setChosen(bool chosen);
    /// What is said of what held the set back.
    [[nodiscard]] QString boundText() const;

    static constexpr double leastMs = 1.2;
    static constexpr double mostMs = tuning::largestMs;

Q_SIGNALS:
    /// By hand; many while dragging.
    void wished();

private:
    void addSliders();
    void addSlider(const QString &name, QSlider *slider, SliderScale *scale);
    void showFigures();
    void sayWish();
    void tellWish();

    const ThemeSource &m_theme;
    ChoiceMark *m_mark = nullptr;
    QVBoxLayout *m_sliders = nullptr;
    SliderScale *m_speedScale = nullptr;
    SliderScale *m_dampingScale = nullptr;
    bool m_isPossible = false;
    LogSlider *m_speed = nullptr; ///< of 1/response: to the right is quicker
    QSlider *m_damping = nullptr; ///< hundredths of Ms
    QLabel *m_response = nullptr;
    QLabel *m_ms = nullptr;
    QLabel *m_gains = nullptr;
    QLabel *m_figures = nullptr;
    QLabel *m_bounds = nullptr;
};

} // namespace mb
