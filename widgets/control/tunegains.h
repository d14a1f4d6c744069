// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/control/arming.h"
#include "widgets/control/statusline.h"
#include "widgets/control/tunechoices.h"

#include <functional>
#include <optional>

namespace mb {

struct KeptTrial;
class TuneColumn;

/// The gains of the motor that is shown: read once, staged from where somebody finds good ones, written as a set, taken back.
class TuneGains : public QObject {
    Q_OBJECT
public:
    TuneGains(Workbench &workbench, Arming &arming, TuneChoices &choices, TuneColumn &column);

    /// Shows the rows of mode and slot, anew where anything of them is different.
    void follow(const DeviceView &view);
    /// Whether they can be written now, and where to.
    void showWriteRow(const DeviceView &view);
    /// What of the gains keeps the motor from a run; nothing: nothing.
    [[nodiscard]] std::optional<PageStatus> obstacle(const DeviceView &view) const;
    /// Writes what is staged, in an order that is never livelier than before and after; then `next`, where that worked and the
    /// same motor is still shown and was armed all the time.
    void write(std::function<void()> next = {});
    /// The last edit is taken back, or made again; without one the last write to the unit.
    void undo(bool again);

    /// The gains of a trial become edits of the slot that is edited: seen, and written like any other.
    void stageTrial(const KeptTrial &kept);
    /// The same of an adviser: parameter keys and numbers. Staged, never written: one key runs it.
    void stageAdvice(const std::vector<std::pair<std::string, double>> &values);
    /// Those of another axis of the board.
    void stageAxis(int from);

Q_SIGNALS:
    /// A write has ended.
    void changed();

private:
    /// What the rows show, and what they show of it.
    struct Shown {
        DeviceId device;
        std::uint64_t parameters = 0; ///< DeviceView::parameterRevision
        bool reading = false;
        std::uint64_t edits = 0; ///< TuneChoices::editRevision()
        Mode mode = Mode::Off;
        int slot = 0;
        double countsPerRevolution = 0.0;
        int axis = 0;

        friend bool operator==(const Shown &, const Shown &) = default;
    };
    template <class Values> void stage(const Values &values, const QString &title);
    [[nodiscard]] const OperationView *operation(const DeviceView &view) const;
    void written(const TuneMotor &motor, const std::vector<ParameterChange> &changes, const Result<void> &result);

    Workbench &m_workbench;
    Arming &m_arming;
    TuneChoices &m_choices;
    TuneColumn &m_column;
    bool m_writing = false;
    std::optional<Shown> m_shown;
};

} // namespace mb
