// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/stateglyph.h"

#include <QWidget>

#include <vector>

class QLabel;

namespace mb {

/// What must hold before firmware is written, each with its glyph and words, on as many lines as they need. GUI thread.
class UpdateChecks : public QWidget {
    Q_OBJECT
public:
    UpdateChecks(const ThemeSource &theme, int count, QWidget *parent);

    void set(int place, GlyphState state, const QString &text);
    void set(int place, bool holds, const QString &text)
    {
        set(place, holds ? GlyphState::Done : GlyphState::Fault, text);
    }
    [[nodiscard]] QString text(int place) const;
    [[nodiscard]] GlyphState state(int place) const;

private:
    struct Check {
        StateGlyph *glyph = nullptr;
        QLabel *text = nullptr;
    };
    std::vector<Check> m_checks;
};

} // namespace mb
