// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plotexport.h"

#include "widgets/common/devicetext.h"
#include "widgets/plots/picturefile.h"

#include <QApplication>
#include <QClipboard>
#include <QFileInfo>
#include <QMenu>
#include <QScopeGuard>

namespace mb {
namespace {

constexpr double PictureScale = 2.0;

const QLatin1String csv("csv");

QString kindOf(const QString &path)
{
    return QFileInfo(path).suffix().toLower();
}

/// Under the name that is chosen later, as it is seen now.
FileChosen writing(const QString &kind, const ContentOf &content, const Written &written)
{
    return [=, made = content(kind)](const QString &path) {
        written(path, savePlot(path, kindOf(path) == kind ? made : content(kindOf(path))));
    };
}

void ask(QWidget &owner, const QString &filter, FileChosen write)
{
    askWhereToSave(owner, PlotExport::tr("Export plot"), filter, {}, std::move(write));
}

} // namespace

void addPictures(QMenu &menu, QWidget &owner, const ContentOf &content, const Written &written)
{
    const auto add = [&](const QString &text, const QString &filter, const char *kind) {
        menu.addAction(text, &owner,
            [=, &owner, kind = QString::fromLatin1(kind)] { ask(owner, filter, writing(kind, content, written)); });
    };
    add(PlotExport::tr("Export PNG…"), PlotExport::tr("PNG picture (*.png)"), "png");
    add(PlotExport::tr("Export SVG…"), PlotExport::tr("SVG drawing (*.svg)"), "svg");
    add(PlotExport::tr("Export PDF…"), PlotExport::tr("PDF document (*.pdf)"), "pdf");
}

PlotExport::PlotExport(QWidget &owner, PlotFrame &plot, const PlotReadings &readings)
    : QObject(&owner)
    , m_owner(owner)
    , m_plot(plot)
    , m_readings(readings)
    , m_table([this] { return writing(csv, m_content, m_written); })
{
}

Result<void> PlotExport::exportTo(const QString &path)
{
    const Result<void> written = savePlot(path, contentAs(kindOf(path)));
    tell(path, written);
    return written;
}

void PlotExport::tell(const QString &path, const Result<void> &written)
{
    if (written)
        Q_EMIT exported(path);
    else
        Q_EMIT exportFailed(errorText(written.error()));
}

QByteArray PlotExport::contentAs(const QString &kind)
{
    if (kind == csv)
        return m_readings.table();
    if (kind == QLatin1String("png"))
        return pngOf(image());
    const QSize size = m_plot.size();
    m_dress(true);
    const auto bare = qScopeGuard([this] { m_dress(false); });
    return drawingAs(kind,
        {size, m_owner.windowTitle().isEmpty() ? m_owner.accessibleName() : m_owner.windowTitle(), m_readings.summary(),
            [&](QCPPainter &painter) { m_plot.toPainter(&painter, size.width(), size.height()); }});
}

QImage PlotExport::image()
{
    m_dress(true);
    const auto bare = qScopeGuard([this] { m_dress(false); });
    return m_plot.picture(m_plot.size(), PictureScale);
}

void PlotExport::fillMenu(QMenu &menu)
{
    const auto add = [&](const QString &text, auto &&act) { menu.addAction(text, this, act); };
    add(tr("Copy picture"), [this] { QApplication::clipboard()->setImage(image()); });
    add(tr("Copy numbers"), [this] { QApplication::clipboard()->setText(m_readings.numbers()); });
    add(tr("Copy summary"), [this] { QApplication::clipboard()->setText(m_readings.summary()); });
    menu.addSeparator();
    addPictures(menu, m_owner, m_content, m_written);
    if (m_table)
        add(tr("Export CSV…"), [this] { ask(m_owner, tr("Table (*.csv)"), m_table()); });
}

} // namespace mb
