// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/workbench.h"

#include <QWidget>

class QComboBox;
class QHBoxLayout;
class QLabel;
class QSlider;

namespace mb {

class CommandButton;
class ThemeSource;

/// Plays a recording: play and pause, speed, where it stands. Hidden while its link is no recording.
class ReplayBar : public QWidget {
    Q_OBJECT
public:
    ReplayBar(Workbench &workbench, const ThemeSource &theme, QWidget *parent = nullptr);

    /// Address of the link that is shown; of a recording or not.
    void setLink(const std::string &link);

private:
    void buildSpeeds(QHBoxLayout &row);
    void buildPosition(QHBoxLayout &row);
    void follow();
    void show(const LinkView &link, const ReplayState &replay);
    void showSpeed(double pace);
    void showTime(Duration position, const ReplayState &replay);
    void playOrPause();
    void sliderMoved();
    void seek();
    [[nodiscard]] const ReplayState *replay() const;

    Workbench &m_workbench;
    const ThemeSource &m_theme;
    std::string m_link;
    QLabel *m_name = nullptr;
    CommandButton *m_play = nullptr;
    QComboBox *m_speed = nullptr;
    QSlider *m_position = nullptr;
    QLabel *m_time = nullptr;
};

} // namespace mb
