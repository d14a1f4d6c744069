// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"
#include "widgets/common/filechoice.h"
#include "widgets/plots/plotreadings.h"

class QMenu;

namespace mb {

/// The bytes of what is seen as a file of a kind: "png". Empty when it cannot be made, or there is no such kind.
using ContentOf = std::function<QByteArray(const QString &kind)>;
using Written = std::function<void(const QString &path, const Result<void> &result)>;

/// Adds the pictures and drawings that can be written of a plot; the name is asked for above `owner`. What is written is what was seen
/// when it was ordered: time goes on while a name is chosen. Only under a name of another kind it is made anew.
void addPictures(QMenu &menu, QWidget &owner, const ContentOf &content, const Written &written);

/// What is seen of a stack of plots as a file or on the clipboard: pictures, drawings, tables, words. GUI thread.
class PlotExport : public QObject {
    Q_OBJECT
public:
    /// Its title and name are the drawing's; dialogs open above it.
    PlotExport(QWidget &owner, PlotFrame &plot, const PlotReadings &readings);

    /// Writes the picture, or the visible data as a table. The kind follows from the suffix: png, svg, pdf, csv.
    /// Fails when the file cannot be written or the suffix is another.
    Result<void> exportTo(const QString &path);
    /// The content of such a file. Empty when it cannot be painted.
    [[nodiscard]] QByteArray contentAs(const QString &kind);
    /// Adds what can be copied and exported.
    void fillMenu(QMenu &menu);
    /// Called when a table is ordered, and yields what writes it, in place of what is drawn; nothing: the menu offers none, the
    /// page exports more.
    void setTable(std::function<FileChosen()> table) { m_table = std::move(table); }
    /// Called with true before a picture is made and with false after it: what stands beside the plot in the window is in the picture.
    void setDressing(std::function<void(bool dressed)> dress) { m_dress = std::move(dress); }

Q_SIGNALS:
    /// Every chosen export ends in one of these.
    void exported(const QString &path);
    /// In words, with the cause.
    void exportFailed(const QString &cause);

private:
    [[nodiscard]] QImage image();
    void tell(const QString &path, const Result<void> &written);

    QWidget &m_owner;
    PlotFrame &m_plot;
    const PlotReadings &m_readings;
    ContentOf m_content{[this](const QString &kind) { return contentAs(kind); }};
    Written m_written{[this](const QString &path, const Result<void> &result) { tell(path, result); }};
    std::function<FileChosen()> m_table;
    std::function<void(bool)> m_dress = [](bool) {};
};

} // namespace mb
