// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"
#include "widgets/common/workbench.h"
#include "widgets/monitor/framefilter.h"
#include "widgets/monitor/linkframerate.h"

#include <QTimer>
#include <QWidget>

class QSplitter;
class QStackedWidget;

namespace mb {

class Arming;
class BusBar;
class BusSide;
class BusTables;
class FrameModel;
class IdModel;
class RecordStrip;
class ReplayBar;
class SendPanel;

/// What passes on one link, decoded: every frame in order, every identifier with its rate, the selected frame in detail, the load;
/// frames are sent by hand here too. Scrolling back pauses the view, never the recording.
class BusPage : public QWidget {
    Q_OBJECT
public:
    BusPage(Workbench &workbench, Arming &arming, const ThemeSource &theme, QWidget *parent = nullptr);
    [[nodiscard]] FrameModel &model() { return *m_model; }
    [[nodiscard]] IdModel &ids() { return *m_ids; }
    [[nodiscard]] BusBar &bar() { return *m_bar; }
    [[nodiscard]] RecordStrip &recordStrip() { return *m_record; }
    /// Address of a link, which may be about to be opened.
    void showLink(const std::string &address);
    void setPaused(bool paused);
    /// Takes what came since the last time; the page does this by itself twenty times a second while it is shown.
    void tick();
    /// The selected frames as lines of candump -L; without one the frame that the detail shows.
    [[nodiscard]] QString selectedText() const;
    /// Writes the frames that are shown, or all that are kept. Reports success or failure to the log.
    void exportTo(const QString &path, bool all);

    /// The least, as the lists scroll by themselves.
    [[nodiscard]] int heightForWidth(int width) const override;

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *) override { m_tick.stop(); }
    void resizeEvent(QResizeEvent *) override { arrange(); }

private:
    void buildContent();
    void buildColumn();
    void buildKeys();
    void followLinks();
    void nameLinks();
    void chooseLink(int place);
    void showState(const LinkView &link);
    void showSelected();
    void applyFilter(const FrameFilter &filter, const FrameFilter &search);
    void find(bool forward);
    void askWhereTo(bool all);
    void arrange();
    [[nodiscard]] const LinkView *link() const { return m_workbench.snapshot().link(m_address); }
    [[nodiscard]] WallClock exportClock() const;

    Workbench &m_workbench;
    const ThemeSource &m_theme;
    FrameModel *m_model = nullptr;
    IdModel *m_ids = nullptr;
    BusBar *m_bar = nullptr;
    SendPanel *m_send = nullptr;
    RecordStrip *m_record = nullptr;
    ReplayBar *m_replay = nullptr;
    std::string m_address;              ///< of the link that is looked at, which may be closed or not open yet
    std::vector<std::string> m_offered; ///< addresses, as the bar has them
    struct {
        std::string name;
        bool simulated = false;
        WallClock clock;
    } m_source;                        ///< of what the lists show
    QStackedWidget *m_lists = nullptr; ///< or that there is no link
    QSplitter *m_outer = nullptr;
    BusTables *m_tables = nullptr;
    BusSide *m_side = nullptr;
    bool m_paused = false;
    Instant m_idsAt{};
    LinkFrameRate m_rate;
    QTimer m_tick;
};

} // namespace mb
