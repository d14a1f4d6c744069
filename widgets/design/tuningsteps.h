// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/snapshot.h"
#include "tuning/autotune.h"
#include "tuning/proofcourse.h"
#include "widgets/common/theme.h"

#include <QWidget>

class QLabel;
class QVBoxLayout;

namespace mb {

class StateGlyph;

/// What an order will do, step by step, before; what it is doing, meanwhile; what came of it, after.
class TuningSteps : public QWidget {
    Q_OBJECT
public:
    explicit TuningSteps(const ThemeSource &theme, QWidget *parent = nullptr);

    /// A set that may be put to the proof.
    struct Ahead {
        const Family &family;
        const tuning::Proposal &proposal;
        tuning::ProofCourse course;
        int slot = 0;      ///< that the result is for
        int gainSlots = 1; ///< of the device
        Mode loop = Mode::Velocity;
        bool isFoundAnew = false; ///< for other limits than those that it is shown for, or elsewhere
    };
    /// `running` while it runs; else the last report and what may come next, each nullptr where there is none. `inForce` bounds whatever
    /// is ordered.
    void show(
        const OperationView *running, const tuning::TuneReport *report, const Ahead *ahead, const Envelope &inForce);
    /// What is the same of every set stands in tooltips.
    void setBrief(bool brief);
    /// Why a result is good stands below the steps; why one is not, never.
    void setEvidenceLast(bool last);

Q_SIGNALS:
    /// Other steps take more or less room.
    void rebuilt();

private:
    struct Step {
        QString head;
        QString always; ///< is so, whatever the set
        QString words;
        friend bool operator==(const Step &, const Step &) = default;
    };
    QWidget *buildHead();
    void showState(const OperationView *running, const tuning::TuneReport *report);
    [[nodiscard]] static std::vector<Step> stepsOf(const OperationView &running);
    [[nodiscard]] static std::vector<Step> stepsOf(const Ahead &ahead, const tuning::TuneReport *report);
    [[nodiscard]] static std::vector<Step> stepsFromTheBeginning(const QString &bounds);
    void say(std::vector<Step> steps, bool numbered);
    [[nodiscard]] QWidget *lineOf(const Step &step, int number);
    void placeEvidence();

    const ThemeSource &m_theme;
    QWidget *m_time = nullptr; ///< beside the head, below it where it is narrow
    QLabel *m_seconds = nullptr;
    StateGlyph *m_glyph = nullptr;
    QLabel *m_head = nullptr;
    QLabel *m_words = nullptr;
    QVBoxLayout *m_state = nullptr; ///< what came of it
    QVBoxLayout *m_lines = nullptr;
    QLabel *m_pushes = nullptr; ///< what the orders that push may make of the motor
    std::vector<Step> m_said;
    std::vector<QLabel *> m_always;
    bool m_isBrief = false;
    bool m_isGood = false;
    bool m_isEvidenceLast = false;
};

/// "kept", "rolled back" …, in front of people.
[[nodiscard]] QString resultText(const tuning::TuneReport &report);

} // namespace mb
