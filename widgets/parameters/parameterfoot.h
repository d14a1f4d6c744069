// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/stateglyph.h"
#include "widgets/parameters/parameterfilter.h"
#include "widgets/parameters/readstatus.h"

class QLabel;

namespace mb {

/// Below the table: what the parameter under the cursor does, and how many values stand how.
class ParameterFoot : public QWidget {
    Q_OBJECT
public:
    ParameterFoot(const ThemeSource &theme, QWidget *parent);
    void showCounts(const ParameterCounts &counts);
    void showParameter(const Parameter *parameter);
    /// Without the counts, which the segments have too.
    void setCompact(bool compact);
    /// How well the values are known, for where it is said nowhere else.
    [[nodiscard]] ReadStatus &status() { return *m_status; }

private:
    struct Count {
        QWidget *box = nullptr;
        QLabel *text = nullptr;
    };
    void buildLegend();
    Count addCount(GlyphState state);
    static void setCount(const Count &count, int number, const QString &text);

    const ThemeSource &m_theme;
    ReadStatus *m_status = nullptr;
    QLabel *m_help = nullptr;
    QWidget *m_legend = nullptr;
    Count m_edited;
    Count m_illegal;
    Count m_unread;
    Count m_inRam;
    Count m_stored;
    Count m_assumed;
    Count m_notKept;
};

} // namespace mb
