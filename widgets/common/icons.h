// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QIcon>
#include <QPixmap>

class QPainter;

namespace mb {

/// Our own line icons, 16 units square, drawn in one colour. One file each in resources/icons.
enum class Symbol {
    Add,
    Arm,
    Camera,
    ChevronDown,
    ChevronLeft,
    ChevronRight,
    ChevronUp,
    Chip,
    Clock,
    Close,
    Copy,
    Cursors,
    Delete,
    Document,
    Edit,
    Error,
    Export,
    Filter,
    Fit,
    Folder,
    FrameSend,
    Gap,
    Gauge,
    Help,
    Identify,
    Import,
    Information,
    Jog,
    Lock,
    Log,
    Mark,
    More,
    Motor,
    Nudge,
    Ok,
    Open,
    PageMap,
    Pause,
    Pin,
    Play,
    Plug,
    Preferences,
    Record,
    Redo,
    Refresh,
    Remove,
    Save,
    Search,
    Star,
    StarFilled,
    Stop,
    Swap,
    Trigger,
    Undo,
    Unlock,
    Wand,
    Warning,
    Wave
};
inline constexpr int SymbolCount = 58;

/// File name of a symbol without folder and suffix.
QString symbolFile(Symbol symbol);
/// Draws the symbol into the square in the middle of `box`. Sharp at every size and device pixel ratio.
void paintSymbol(QPainter &painter, const QRectF &box, Symbol symbol, const QColor &color);
/// An icon in a tone of the theme; its disabled state is faint, its checked state has full text colour.
/// The icon keeps its colours: make it anew when ThemeSource::changed() fires.
QIcon symbolIcon(Symbol symbol, const Theme &theme, Tone tone = Tone::Text);
QIcon symbolIcon(Symbol symbol, const QColor &color, const QColor &disabled);
/// The icon of the program (window, header, about).
QIcon applicationIcon();

} // namespace mb
