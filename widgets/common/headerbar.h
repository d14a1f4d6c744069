// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/chip.h"
#include "widgets/common/lamp.h"
#include "widgets/common/stopbutton.h"

class QHBoxLayout;
class QMenu;
class QToolButton;

namespace mb {

/// The top line: name and menu, links, notices, recording, lamp, STOP. Its lower edge is amber while energy may flow.
/// Never disable it: STOP lives here.
class HeaderBar : public QWidget {
    Q_OBJECT
public:
    explicit HeaderBar(const ThemeSource &theme, QWidget *parent = nullptr);

    Lamp &lamp() { return *m_lamp; }
    StopButton &stopButton() { return *m_stop; }
    /// The menu behind the name; not owned.
    void setMenu(QMenu *menu);
    void setLinks(const std::vector<LinkStatus> &links);
    /// 0 shows "no alarms"; a negative number hides the chip.
    void setNotices(int count);
    /// "REC 12:41" while recording, empty otherwise.
    void setRecording(const QString &text);
    void setLampStatus(const LampStatus &status);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

Q_SIGNALS:
    void linkActivated(const QString &address);
    /// The folded chip "4 links" was clicked.
    void linksActivated();
    void noticesActivated();
    void recordingActivated();

protected:
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *) override { updateFolding(); }
    bool event(QEvent *event) override;

private:
    void buildName(QHBoxLayout &row);
    void buildChips(QHBoxLayout &row);
    void buildSafety(QHBoxLayout &row);
    void updateFolding();
    void updateFolded();
    void restyle();

    const ThemeSource &m_theme;
    QToolButton *m_name = nullptr;
    QHBoxLayout *m_linkRow = nullptr;
    std::vector<LinkChip *> m_links;
    Chip *m_folded = nullptr;
    Chip *m_notices = nullptr;
    int m_noticeCount = -1;
    bool m_hasRecording = false;
    Chip *m_recording = nullptr;
    Lamp *m_lamp = nullptr;
    StopButton *m_stop = nullptr;
};

} // namespace mb
