// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "widgets/common/theme.h"

#include <QWidget>

class QLabel;

namespace mb {

class CommandButton;
class Recorder;
class Workbench;

/// The recording that runs, as a button and words about it; hidden without one. GUI thread.
class RecordingControl : public QWidget {
    Q_OBJECT
public:
    RecordingControl(Workbench &workbench, const ThemeSource &theme, QWidget *parent);

    /// Finished recordings go to the folder.
    void setRecorder(Recorder *recorder, const QString &folder);
    /// Begins to keep, or saves what was kept; nothing without a recorder.
    void toggle();
    void note(Instant time, const QString &text);
    /// Without room the numbers stand in the button's description only.
    void setWide(bool wide);
    /// Length and size may be others.
    void follow();

private:
    Workbench &m_workbench;
    Recorder *m_recorder = nullptr;
    QString m_folder;
    CommandButton *m_button;
    QLabel *m_words;
};

} // namespace mb
