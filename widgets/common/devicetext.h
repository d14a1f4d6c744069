// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "files/qttext.h"
#include "model/snapshot.h"
#include "widgets/common/stateglyph.h"
#include "widgets/common/tabletext.h"

#include <QString>
#include <QStringList>

#include <string_view>

namespace mb {

/// The one place where device states and faults become text and shape for people.

[[nodiscard]] QString errorText(const Error &error);
/// "over-current" for the key over_current.
[[nodiscard]] QString faultText(const Family &family, std::string_view key);
[[nodiscard]] QString modeText(Mode mode);

/// Several axes, each with a place of its own in tree, pages and plots.
[[nodiscard]] bool hasAxes(const Family &family);
/// "2 of 4 axes move", "4 axes"
[[nodiscard]] QString axesLine(const DeviceView &device);
[[nodiscard]] GlyphState glyphOf(const DeviceView &device);
/// Before what is kept of this unit (model/unit.h): empty, or that it may be of another one.
[[nodiscard]] QString placeCaveat(std::string_view unit);
/// Of a line of a log.
[[nodiscard]] GlyphState glyphOf(Severity severity);
/// "DMC60C #5"
[[nodiscard]] QString titleOf(const DeviceView &device);
/// What its user calls it; empty while it is still called as its maker calls all of them.
[[nodiscard]] QString givenName(const DeviceView &device);
/// "1 Mbit/s"; empty where it is not known.
[[nodiscard]] QString bitrateText(const LinkView &link);
/// Second line of the tree: name and what it does now.
[[nodiscard]] QString lineOf(const DeviceView &device);
/// What it says holds now, most important first: "forward limit switch holds", "halted".
[[nodiscard]] QStringList conditionsText(const DeviceView &device);
/// Those of them that keep a motor from what it is told. A halt is none: at rest every one is halted.
[[nodiscard]] QStringList alertsOf(const DeviceView &device);
/// The first of its faults or alerts, that it has none, or that it does not answer: what it said last is not true for ever.
struct HealthText {
    GlyphState glyph;
    Tone tone;
    QString words;
};
[[nodiscard]] HealthText healthOf(const DeviceView &device);
/// "Encoder pin A"; of an axis "axis 2: Input".
[[nodiscard]] QString stateLabel(const StateRow &row);
/// Of the whole board, or of this axis; every row with axis 0.
[[nodiscard]] bool isOfAxis(const StateRow &row, int axis);
/// Every limit and pin in a line of its own: "Encoder pin A: on".
[[nodiscard]] QString statesText(const DeviceView &device);
/// "boot", "2 ×", a dialect; empty when nothing is unusual.
[[nodiscard]] QString badgeOf(const DeviceView &device);
/// It keeps a move whose motion was stopped before it began; the next start of buffered moves on its line begins it.
[[nodiscard]] bool keepsStoppedMove(const DeviceView &device);
/// One sentence: state, cause, remedy.
[[nodiscard]] QString tooltipOf(const DeviceView &device);

} // namespace mb
