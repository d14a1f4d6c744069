// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plotexport.h"

#include "widgets/common/devicetext.h"
#include "widgets/plots/picturefile.h"

#include <QApplication>
#include <QClipboard>
#include <QFileDialog>
#include <QMenu>
#include <QScopeGuard>

namespace mb {
namespace {

constexpr double PictureScale = 2.0;

} // namespace

PlotExport::PlotExport(QWidget &owner, PlotFrame &plot, const PlotReadings &readings)
    : QObject(&owner)
    , m_owner(owner)
    , m_plot(plot)
    , m_readings(readings)
{
}

Result<void> PlotExport::exportTo(const QString &path)
{
    const QString kind = QFileInfo(path).suffix().toLower();
    const QByteArray content = kind == QLatin1String("csv") ? m_readings.table() : pictureAs(kind);
    const Result<void> written = savePlot(path, content);
    if (written)
        Q_EMIT exported(path);
    else
        Q_EMIT exportFailed(errorText(written.error()));
    return written;
}

QByteArray PlotExport::pictureAs(const QString &kind)
{
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

void PlotExport::choose(const QString &suffix, const QString &filter, std::function<void(const QString &)> write)
{
    auto *dialog = new QFileDialog(&m_owner, tr("Export plot"), QString(), filter);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(suffix);
    connect(dialog, &QFileDialog::fileSelected, this, write);
    dialog->open();
}

void PlotExport::fillMenu(QMenu &menu)
{
    const auto add = [&](const QString &text, auto &&act) { menu.addAction(text, this, act); };
    add(tr("Copy picture"), [this] { QApplication::clipboard()->setImage(image()); });
    add(tr("Copy numbers"), [this] { QApplication::clipboard()->setText(m_readings.numbers()); });
    add(tr("Copy summary"), [this] { QApplication::clipboard()->setText(m_readings.summary()); });
    menu.addSeparator();
    const auto picture = [this](const QString &path) { exportTo(path); };
    add(tr("Export PNG…"), [this, picture] { choose(QStringLiteral("png"), tr("PNG picture (*.png)"), picture); });
    add(tr("Export SVG…"), [this, picture] { choose(QStringLiteral("svg"), tr("SVG drawing (*.svg)"), picture); });
    add(tr("Export PDF…"), [this, picture] { choose(QStringLiteral("pdf"), tr("PDF document (*.pdf)"), picture); });
    if (m_table)
        add(tr("Export CSV…"), [this] { choose(QStringLiteral("csv"), tr("Table (*.csv)"), m_table); });
}

} // namespace mb
