// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"
#include "widgets/plots/plotreadings.h"

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
    /// Whether the menu offers a table of what is seen; a page that exports more says no.
    void setOwnTable(bool own) { m_ownTable = own; }

Q_SIGNALS:
    /// Every chosen export ends in one of these.
    void exported(const QString &path);
    /// In words, with the cause.
    void exportFailed(const QString &cause);

private:
    void choose(const QString &suffix, const QString &filter);

    QWidget &m_owner;
    PlotFrame &m_plot;
    const PlotReadings &m_readings;
    bool m_ownTable = true;
};

} // namespace mb
