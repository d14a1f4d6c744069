// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"
#include "widgets/common/workbench.h"

#include <QTimer>
#include <QWidget>

class QHBoxLayout;
class QLabel;
class QTableView;
class QVBoxLayout;

namespace mb {

class CommandButton;
class FrameDetail;
class FrameModel;
class SearchField;
class Segmented;

/// What passes on one link, decoded: filter, pause, detail. Scrolling back pauses the view, never the recording.
class BusPage : public QWidget {
    Q_OBJECT
public:
    BusPage(Workbench &workbench, const ThemeSource &theme, QWidget *parent = nullptr);
    [[nodiscard]] FrameModel &model() { return *m_model; }
    void setPaused(bool paused);

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    void buildBar(QVBoxLayout &column);
    void buildTable(QVBoxLayout &column);
    void followLinks();
    void tick();
    void applyFilter();

    Workbench &m_workbench;
    const ThemeSource &m_theme;
    FrameModel *m_model = nullptr;
    QTableView *m_table = nullptr;
    FrameDetail *m_detail = nullptr;
    SearchField *m_filter = nullptr;
    Segmented *m_direction = nullptr;
    Segmented *m_links = nullptr;
    QHBoxLayout *m_linkRow = nullptr;
    CommandButton *m_pause = nullptr;
    QLabel *m_state = nullptr;
    QLabel *m_problem = nullptr;
    std::vector<std::string> m_shownLinks;
    bool m_paused = false;
    Instant m_rateAt{};
    std::uint64_t m_rateFrames = 0;
    double m_rate = 0.0;
    QTimer m_tick;
};

} // namespace mb
