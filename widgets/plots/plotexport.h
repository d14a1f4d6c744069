// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"
#include "widgets/plots/plotreadings.h"

#include <functional>

class QMenu;

namespace mb {

/// What is seen of a stack of plots as a file or on the clipboard: pictures, drawings, tables, words. GUI thread.
class PlotExport : public QObject {
    Q_OBJECT
public:
    /// Its title and name are the drawing's; dialogs open above it.
    PlotExport(QWidget &owner, PlotFrame &plot, const PlotReadings &readings);

    /// Writes the picture, or the visible data as a table. The kind follows from the suffix: png, svg, pdf, csv.
    /// Fails when the file cannot be written or the suffix is another.
    Result<void> exportTo(const QString &path);
    /// The content of such a file of a picture: png, svg, pdf. Empty when it cannot be painted.
    [[nodiscard]] QByteArray pictureAs(const QString &kind);
    /// Adds what can be copied and exported.
    void fillMenu(QMenu &menu);
    /// What writes the table of what is seen, in place of what is drawn; nothing: the menu offers none, the page exports more.
    void setTable(std::function<void(const QString &path)> table) { m_table = std::move(table); }
    /// Called with true before a picture is made and with false after it: what stands beside the plot in the window is in the picture.
    void setDressing(std::function<void(bool dressed)> dress) { m_dress = std::move(dress); }

Q_SIGNALS:
    /// Every chosen export ends in one of these.
    void exported(const QString &path);
    /// In words, with the cause.
    void exportFailed(const QString &cause);

private:
    [[nodiscard]] QImage image();
    void choose(const QString &suffix, const QString &filter, std::function<void(const QString &)> write);

    QWidget &m_owner;
    PlotFrame &m_plot;
    const PlotReadings &m_readings;
    std::function<void(const QString &)> m_table{[this](const QString &path) { exportTo(path); }};
    std::function<void(bool)> m_dress = [](bool) {};
};

} // namespace mb
