// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/session.h"
#include "widgets/common/theme.h"

#include <QCoreApplication>

#include <chrono>
#include <optional>

class QPainter;
class QSize;

namespace mb {

/// Whether energy may flow. Stopped means: was stopped, motion needs a new arming. Stopping: told, and not seen to stand yet.
/// MayTurn: told, nobody has seen it stand, and nothing of its own stops it.
enum class LampState { Safe, Armed, Moving, Stopped, Stopping, MayTurn };

/// What the Arm button says. `detail` is the small text behind the word ("#5 velocity", "4 motors", "nothing to arm");
/// empty gives the instruction "hold to arm"; of MayTurn it stands below the word. `remaining` is shown while armed, as m:ss.
struct LampStatus {
    LampState state = LampState::Safe;
    QString detail;
    std::optional<std::chrono::seconds> remaining;
    bool armable = true;     ///< false: holding does nothing, the Arm button is faint
    DeviceId candidate = {}; ///< what holding arms: a hold is for that device only

    friend bool operator==(const LampStatus &, const LampStatus &) = default;
};

/// Energy may flow.
[[nodiscard]] inline bool isLive(const LampStatus &status)
{
    return status.state == LampState::Armed || status.state == LampState::Moving;
}

/// The lamp as it is seen and read: its words, the room that they need, its picture. Made for one look; what it is given outlives it.
class LampFace {
    Q_DECLARE_TR_FUNCTIONS(mb::LampFace)
public:
    LampFace(const Theme &theme, const QFont &body, const LampStatus &status, bool holding);

    [[nodiscard]] QString word() const;
    /// What of the time remains; empty but while armed.
    [[nodiscard]] QString clock() const;
    [[nodiscard]] QString detail() const;
    /// Wide enough for the usual texts of every state, in one line; whatever it says, the Arm button keeps its place.
    [[nodiscard]] QSize preferred() const;
    /// For the word above, the detail below.
    [[nodiscard]] QSize least() const;
    /// `progress`: how much of the hold has passed, 0 … 1.
    void paint(QPainter &painter, const QSize &size, double progress) const;

private:
    [[nodiscard]] int textWidth(const QString &word, const QString &time, const QString &detail) const;
    [[nodiscard]] int contentWidth() const { return textWidth(word(), clock(), detail()); }
    /// "May still turn" is too long for one line beside its detail.
    [[nodiscard]] bool hasTwoLines() const { return m_status.state == LampState::MayTurn; }
    void paintPlate(QPainter &painter, const QSize &size, double progress) const;
    void paintMark(QPainter &painter, int x, int height, const QColor &color) const;
    void paintLines(QPainter &painter, const QSize &size, const QColor &color, const QColor &detailColor) const;
    void paintContent(QPainter &painter, const QSize &size, const QColor &color, const QColor &detailColor) const;

    const Theme &m_theme;
    QFont m_body;
    const LampStatus &m_status;
    bool m_holding;
};

} // namespace mb
