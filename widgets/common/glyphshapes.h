// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QColor;
class QPainter;
class QRectF;

namespace mb {

/// The states of devices, values and steps. Each has one shape, one word and one colour everywhere in the program.
enum class GlyphState {
    // of a device
    Online,
    Moving,
    Bootloader,
    Duplicate,
    Unassigned,
    Fault,
    Gone,
    // of a value
    Stored,
    InRam,
    Edited,
    OutOfRange,
    Assumed,
    Volatile,
    Busy,
    // of a step
    Done,
    Waiting,
    Warning,
    Recording
};
inline constexpr int GlyphStateCount = 18;

/// Draws the shape into the square in the middle of `box`; made for 12 units, sharp from 8 upwards.
void paintGlyph(QPainter &painter, const QRectF &box, GlyphState state, const QColor &color);

} // namespace mb
