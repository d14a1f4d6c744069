// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/workbench.h"
#include "widgets/start/listcard.h"
#include "widgets/start/story.h"

class QBoxLayout;
class QGridLayout;

namespace mb {

class DoctorCard;
class StoryCard;

/// What a user sees first, with nothing connected: why that is and what helps, something to try without hardware, what was
/// done before, and firmware that is on this computer.
class StartPage : public QWidget {
    Q_OBJECT
public:
    StartPage(Workbench &workbench, const ThemeSource &theme, QWidget *parent = nullptr);

    /// From the workbench's snapshot and listings.
    void follow();
    /// Sessions and recordings of before, newest first; `none` where there is none.
    void setRecent(std::vector<ListCard::Row> rows);
    void setFirmware(std::vector<ListCard::Row> rows);

Q_SIGNALS:
    void storyWanted(const mb::Story &story);
    void benchWanted();
    void addLinkRequested();
    void openRecordingRequested();
    void recentWanted(int row);
    void firmwareWanted(int row);
    void firmwareFolderWanted();
    void keysWanted();
    void guidesWanted();

protected:
    void resizeEvent(QResizeEvent *) override { arrange(); }

private:
    [[nodiscard]] QWidget *buildMain(Workbench &workbench);
    [[nodiscard]] QWidget *buildSide();
    [[nodiscard]] QWidget *buildFirst(QWidget *parent);
    void buildStories(QBoxLayout &column, QWidget &parent);
    void arrange();

    const ThemeSource &m_theme;
    QBoxLayout *m_row = nullptr;
    QBoxLayout *m_column = nullptr;
    QWidget *m_main = nullptr;
    QWidget *m_side = nullptr;
    DoctorCard *m_doctor = nullptr;
    QGridLayout *m_storyGrid = nullptr;
    std::vector<StoryCard *> m_stories;
    ListCard *m_recent = nullptr;
    ListCard *m_firmware = nullptr;
    int m_columns = 0;
};

} // namespace mb
