// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/stateglyph.h"

#include <QWidget>

#include <vector>

class QLabel;

namespace mb {

/// What must hold before something is done, each with its glyph and words, on as many lines as they need. GUI thread.
class CheckRow : public QWidget {
    Q_OBJECT
public:
    CheckRow(const ThemeSource &theme, const QString &heading, int count, QWidget *parent);

    /// A place without words is not in sight.
    void set(int place, GlyphState state, const QString &words);
    void set(int place, bool holds, const QString &words)
    {
        set(place, holds ? GlyphState::Done : GlyphState::Fault, words);
    }
    [[nodiscard]] QString text() const;

private:
    struct Check {
        StateGlyph *glyph = nullptr;
        QLabel *words = nullptr;
    };
    std::vector<Check> m_checks;
};

} // namespace mb
