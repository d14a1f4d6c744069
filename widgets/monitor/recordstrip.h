// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/workbench.h"

#include <QWidget>

class QLabel;
class QPushButton;

namespace mb {

class CommandButton;
class ElidedLabel;
class StateGlyph;
class ThemeSource;

/// Records the frames of one CAN link into a file. The button asks for the file, or ends the recording; the strip is shown while one
/// runs (time, frames, what is missing), and after one that failed.
class RecordStrip : public QWidget {
    Q_OBJECT
public:
    RecordStrip(Workbench &workbench, const ThemeSource &theme, QWidget *parent = nullptr);

    /// Stands wherever the page wants it; hidden for links that cannot be recorded.
    [[nodiscard]] CommandButton &button() { return *m_button; }
    /// Address of the link.
    void setLink(const std::string &link);
    /// Begins at once, with the link that is set. Reports failure to the log.
    void recordTo(const QString &path) { record(m_link, path); }
    /// What the button does; nothing for a link that cannot be recorded.
    void toggle();

private:
    void build();
    void askWhereTo();
    void record(const std::string &address, const QString &path);
    void follow();
    void show(const RecordingState &recording);
    void dismiss();

    Workbench &m_workbench;
    const ThemeSource &m_theme;
    std::string m_link;
    QString m_dismissed; ///< the problem that was read
    CommandButton *m_button = nullptr;
    StateGlyph *m_glyph = nullptr;
    ElidedLabel *m_text = nullptr;
    QPushButton *m_dismiss = nullptr;
};

/// A recording that is being written, not one that has failed or ended.
[[nodiscard]] bool isRunning(const RecordingState &recording);

} // namespace mb
