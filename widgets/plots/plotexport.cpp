// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/devicetext.h"
#include "widgets/plots/picturefile.h"
#include "widgets/plots/plotcursors.h"
#include "widgets/plots/plotstack.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QFileDialog>
#include <QMenu>
#include <QTextStream>
#include <cmath>
#include <set>

namespace mb {
namespace {

constexpr double PictureScale = 2.0;
constexpr int TableColumns = 1 << 20; ///< so many that a source hands out every sample

QString csvField(const QString &text)
{
    static const QRegularExpression special(QStringLiteral("[,\"\r\n]"));
    if (!text.contains(special))
        return text;
    return QLatin1Char('"') + QString(text).replace(QLatin1Char('"'), QStringLiteral("\"\"")) + QLatin1Char('"');
}

QString csvNumber(double value)
{
    return std::isfinite(value) ? QString::number(value, 'g', 12) : QString();
}

} // namespace

Result<void> PlotStack::exportTo(const QString &path)
{
    const QString kind = QFileInfo(path).suffix().toLower();
    const QByteArray content = kind == QLatin1String("csv") ? table() : pictureAs(kind);
    const Result<void> written = savePlot(path, content);
    if (written)
        Q_EMIT exported(path);
    else
        Q_EMIT exportFailed(errorText(written.error()));
    return written;
}

QByteArray PlotStack::pictureAs(const QString &kind)
{
    const QSize size = m_plot->size();
    if (kind == QLatin1String("png"))
        return pngOf(m_plot->picture(size, PictureScale));
    return drawingAs(kind,
        {size, windowTitle().isEmpty() ? accessibleName() : windowTitle(), summary(),
            [&](QCPPainter &painter) { m_plot->toPainter(&painter, size.width(), size.height()); }});
}

QByteArray PlotStack::table() const
{
    struct Column {
        std::vector<PlotPoint> points;
        std::size_t next = 0;
    };
    QStringList head{QStringLiteral("time_s")};
    std::vector<Column> columns;
    std::set<double> keys;
    for (const auto &[id, trace] : m_traces) {
        if (!trace.visible || !trace.source)
            continue;
        head << csvField(trace.style.unit.isEmpty()
                ? trace.style.name
                : QStringLiteral("%1 (%2)").arg(trace.style.name, trace.style.unit));
        Column &column = columns.emplace_back();
        trace.source->columns(m_from, m_to, TableColumns, column.points);
        for (const PlotPoint &point : column.points) {
            if (point.key >= m_from && point.key <= m_to)
                keys.insert(point.key);
        }
    }
    QByteArray content;
    QTextStream out(&content);
    out.setCodec("UTF-8");
    out << head.join(QLatin1Char(',')) << '\n';
    for (const double key : keys) {
        out << QString::number(key, 'f', 6);
        for (Column &column : columns) {
            while (column.next < column.points.size() && column.points[column.next].key < key)
                ++column.next;
            const bool here = column.next < column.points.size() && column.points[column.next].key == key;
            out << ',' << (here ? csvNumber(column.points[column.next].value) : QString());
        }
        out << '\n';
    }
    out.flush();
    return content;
}

QString PlotStack::numbers() const
{
    const QChar tab = QLatin1Char('\t');
    const bool cursors = cursorsShown();
    const auto [a, b] = cursors ? cursorKeys() : range();
    QString table = QStringLiteral("trace\tunit\tA\tB\tB-A\tmean\tdeviation\tmin\tmax\tsamples\tlost\n");
    table += QStringLiteral("time\ts\t%1\t%2\t%3\t\t\t\t\t\t\n")
                 .arg(QString::number(a, 'f', 6), QString::number(b, 'f', 6), csvNumber(b - a));
    for (const auto &[id, trace] : m_traces) {
        if (!trace.visible || !trace.source)
            continue;
        const double shift = trace.style.aligned ? origin() : 0.0;
        const auto found = trace.source->statistics(a - shift, b - shift);
        QStringList fields{trace.style.name, trace.style.unit, csvNumber(valueAt(id, a)), csvNumber(valueAt(id, b)),
            csvNumber(valueAt(id, b) - valueAt(id, a))};
        if (found)
            fields << csvNumber(found->mean) << csvNumber(found->deviation) << csvNumber(found->low)
                   << csvNumber(found->high) << QString::number(found->count) << QString::number(found->lost);
        table += fields.join(tab) + QLatin1Char('\n');
    }
    return table;
}

void PlotStack::chooseExport(const QString &suffix, const QString &filter)
{
    auto *dialog = new QFileDialog(this, tr("Export plot"), QString(), filter);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(suffix);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString &path) { exportTo(path); });
    dialog->open();
}

void PlotStack::fillMenu(QMenu &menu)
{
    const auto add = [&](const QString &text, auto &&act) { return menu.addAction(text, this, act); };
    add(m_live ? tr("Pause view\tP") : tr("Back to live\tP"), [this] { m_live ? setLive(false) : backToLive(); });
    add(tr("Fit time and value\t0"), [this] { fit(); });
    QAction *cursors = add(tr("Cursors A and B\tL"), [this] { setCursorsShown(!cursorsShown()); });
    cursors->setCheckable(true);
    cursors->setChecked(cursorsShown());
    menu.addSeparator();
    add(tr("Copy picture"),
        [this] { QApplication::clipboard()->setImage(m_plot->picture(m_plot->size(), PictureScale)); });
    add(tr("Copy numbers"), [this] { QApplication::clipboard()->setText(numbers()); });
    add(tr("Copy summary"), [this] { QApplication::clipboard()->setText(summary()); });
    menu.addSeparator();
    add(tr("Export PNG…"), [this] { chooseExport(QStringLiteral("png"), tr("PNG picture (*.png)")); });
    add(tr("Export SVG…"), [this] { chooseExport(QStringLiteral("svg"), tr("SVG drawing (*.svg)")); });
    add(tr("Export PDF…"), [this] { chooseExport(QStringLiteral("pdf"), tr("PDF document (*.pdf)")); });
    if (m_ownTable)
        add(tr("Export CSV…"), [this] { chooseExport(QStringLiteral("csv"), tr("Table (*.csv)")); });
}

void PlotStack::contextMenuEvent(QContextMenuEvent *event)
{
    auto *menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    fillMenu(*menu);
    Q_EMIT menuRequested(menu, stripAt(event->pos()), keyAt(event->pos().x()));
    menu->popup(event->globalPos());
}

} // namespace mb
