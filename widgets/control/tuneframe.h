// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QWidget>

class QGridLayout;

namespace mb {

class Segmented;
class TrialsView;

/// Where the parts of the Tune page stand. With room: commands and stimulus above, the column of gains at the left, what the
/// trials did at the right. Without (large fonts, small screens): one part at a time below the commands, chosen in a row of
/// tabs, so that the plot keeps at least a third of the page. GUI thread.
class TuneFrame : public QWidget {
    Q_OBJECT
public:
    /// Tabs of the compact arrangement.
    enum class Part { Setup, Response, Metrics, Trials, Live };
    struct Parts {
        QWidget *commands = nullptr;
        QWidget *stimulus = nullptr;
        QWidget *column = nullptr;
        QWidget *work = nullptr;      ///< a stack of the trials and the live view
        TrialsView *trials = nullptr; ///< inside `work`
    };

    explicit TuneFrame(const ThemeSource &theme, QWidget *parent = nullptr);
    /// Takes them; once.
    void setParts(const Parts &parts);
    /// The live view is shown instead of the experiments.
    void setLive(bool live);
    [[nodiscard]] bool isCompact() const { return m_compact; }
    /// Nothing happens where all parts are in sight.
    void show(Part part);
    /// Little: it arranges itself into what it gets.
    [[nodiscard]] QSize minimumSizeHint() const override;
    [[nodiscard]] bool hasHeightForWidth() const override { return false; }

Q_SIGNALS:
    void compactChanged(bool compact);
    /// Somebody chose the live view, or the experiments, in the compact row.
    void liveChosen(bool live);

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    void arrange();
    void fitColumn();
    void chosen(int tab);

    const ThemeSource &m_theme;
    Parts m_parts;
    QGridLayout *m_grid = nullptr;
    QWidget *m_tabsRow = nullptr;
    Segmented *m_tabs = nullptr;
    QWidget *m_stimulusLine = nullptr;
    QWidget *m_columnLine = nullptr;
    bool m_compact = false;
    bool m_live = false;
};

} // namespace mb
