// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/stateglyph.h"

#include <QWidget>

namespace mb {

class ElidedLabel;

/// What a page that moves a motor says above everything else, and whether its order does something now.
struct PageStatus {
    GlyphState glyph = GlyphState::Gone;
    QString cause;
    QString remedy;
    bool mayRun = false;
};

/// The status in one line: its shape, the cause, and behind it what helps.
class StatusLine : public QWidget {
    Q_OBJECT
public:
    explicit StatusLine(const ThemeSource &theme, QWidget *parent = nullptr);

    /// `compact`: cause and remedy are one text, which is cut together.
    void say(const PageStatus &status, bool compact = false);

private:
    StateGlyph *m_glyph = nullptr;
    ElidedLabel *m_cause = nullptr;
    ElidedLabel *m_remedy = nullptr;
};

} // namespace mb
