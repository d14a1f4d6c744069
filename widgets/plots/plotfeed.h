// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/plots/plotreadings.h"

namespace mb {

/// Brings what the sources have in the stretch that is shown into the strips: points, value axes, gaps, tags, foot line.
/// GUI thread.
class PlotFeed {
    Q_DECLARE_TR_FUNCTIONS(PlotFeed)
public:
    PlotFeed(const PlotStrips &strips, const PlotView &view, const ThemeSource &theme)
        : m_strips(strips)
        , m_view(view)
        , m_theme(theme)
    {
    }

    /// Points and axes, for the width that the strips have now. True when a value axis has changed.
    bool fetch(double pixelRatio);
    /// Numbers that somebody reads: tags, foot line, the box beside the cursors.
    void updateWords(const PlotReadings &readings);
    /// What changes while only time goes on.
    [[nodiscard]] QRegion movingPart() const;

    /// Left end of the foot line. Empty shows live or paused and the window.
    void setFootNote(const QString &text) { m_footNote = text; }
    /// Instead of "live" or "paused" in the foot line; true when it is another.
    bool setStateText(const QString &text);

private:
    void fetchTrace(const PlotTrace &trace, double pixelRatio);
    bool updateAxis(PlotStrip &strip, int index, bool second) const;
    void addGaps(PlotStrip &strip, const PlotTrace &trace) const;
    void updateTags(PlotStrip &strip, int index, const PlotReadings &readings) const;
    void updateFoot() const;

    const PlotStrips &m_strips;
    const PlotView &m_view;
    const ThemeSource &m_theme;
    std::vector<PlotPoint> m_scratch;
    QString m_footNote;
    QString m_stateText;
};

} // namespace mb
