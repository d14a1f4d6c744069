// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/loadrecording.h"
#include "widgets/plots/plotstack.h"

#include <QTimer>

class QLabel;
class QListWidget;

namespace mb {

class ExportJob;

/// A recording of samples (.mcap, .csv; of this program or another) in a window of its own: every channel with its switch,
/// zoom, cursors and export: pictures, and every sample as a table. It is read in the background; closing the window gives that up. GUI thread.
class SamplesWindow : public QWidget {
    Q_OBJECT
public:
    /// Whether a file of this name holds samples rather than frames.
    [[nodiscard]] static bool isFor(const QString &path);

    SamplesWindow(const QString &path, const ThemeSource &theme, QWidget *parent);

    [[nodiscard]] PlotStack &stack() { return *m_stack; }
    [[nodiscard]] bool isLoaded() const { return m_recording != nullptr; }
    /// Cause and remedy where it could not be read; empty else.
    [[nodiscard]] QString failure() const { return m_failure; }

Q_SIGNALS:
    void loaded();

private:
    void build(const QString &path, const ThemeSource &theme);
    void addKeys();
    void connectExports();
    void say(const QString &text, Tone tone);
    void read(const QString &path);
    void take(const Result<std::shared_ptr<const LoadedRecording>> &read);
    void listChannels(const std::vector<int> &traces);
    void showExports(const QPoint &at);
    void exportTable(const QString &path);

    PlotStack *m_stack = nullptr;
    QListWidget *m_channels = nullptr;
    QLabel *m_state = nullptr; ///< of the file
    QLabel *m_said = nullptr;  ///< of an export
    ExportJob *m_job = nullptr;
    std::shared_ptr<const LoadedRecording> m_recording;
    QString m_failure;
    QTimer m_tick;
};

} // namespace mb
