// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/devicetext.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/replaybar.h"
#include "widgets/monitor/busbar.h"
#include "widgets/monitor/busloadview.h"
#include "widgets/monitor/buspage.h"
#include "widgets/monitor/framedetail.h"
#include "widgets/monitor/frameexport.h"
#include "widgets/monitor/framemodel.h"
#include "widgets/monitor/frametext.h"
#include "widgets/monitor/idmodel.h"
#include "widgets/monitor/recordstrip.h"
#include "widgets/monitor/sendpanel.h"
#include "widgets/monitor/trafficview.h"

#include <QFileDialog>
#include <QLabel>
#include <QMenu>

#include <algorithm>

namespace mb {
namespace {

constexpr Duration idsTime = std::chrono::milliseconds(200);
constexpr Duration loadTime = std::chrono::milliseconds(500);

} // namespace

const LinkView *BusPage::link() const
{
    const Snapshot &shot = m_workbench.snapshot();
    const auto current = static_cast<std::size_t>(m_bar->link());
    return current < shot.links.size() ? &shot.links[current] : nullptr;
}

void BusPage::followLinks()
{
    followLoad();
    if (!isVisible())
        return;
    QStringList names;
    for (const LinkView &link : m_workbench.snapshot().links)
        names += QString::fromStdString(link.name);
    m_bar->setLinks(names);
    followWanted();
    const LinkView *shown = link();
    if (!shown)
        return;
    const FrameDecoder decoder = decoderFor(m_workbench.snapshot(), shown->address);
    m_model->setDecoder(decoder);
    m_ids->setDecoder(decoder);
    m_model->setSource(shown->traffic);
    m_ids->setSource(shown->traffic);
    m_send->setLink(shown->address);
    m_record->setLink(shown->address);
    m_replay->setLink(shown->address);
}

void BusPage::showLink(const std::string &address)
{
    m_wanted = address;
    followLinks();
}

void BusPage::followWanted()
{
    const std::vector<LinkView> &links = m_workbench.snapshot().links;
    const auto found
        = std::find_if(links.begin(), links.end(), [this](const LinkView &l) { return l.address == m_wanted; });
    if (m_wanted.empty() || found == links.end())
        return;
    m_wanted.clear(); // first: this comes here again
    m_bar->setLink(static_cast<int>(found - links.begin()));
}

void BusPage::followLoad()
{
    const Snapshot &shot = m_workbench.snapshot();
    if (shot.time - m_loadAt < loadTime)
        return;
    m_loadAt = shot.time;
    for (const LinkView &link : shot.links) {
        std::deque<double> &loads = m_loads[link.address];
        loads.push_back(link.load);
        if (loads.size() > BusLoadView::points)
            loads.pop_front();
    }
    if (const LinkView *shown = link(); shown && isVisible())
        m_load->setLoads(m_loads[shown->address]);
}

void BusPage::applyFilter(const FrameFilter &filter, const FrameFilter &search)
{
    m_model->setFilter(filter);
    m_model->setSearch(search);
    m_ids->setFilter(search.isEmpty() ? filter : FrameFilter::both(filter, search));
    if (!m_paused)
        toEnd();
}

void BusPage::find(bool forward)
{
    const QModelIndex current = m_table->currentIndex();
    const int from = current.isValid() ? current.row() + (forward ? 1 : -1) : forward ? 0 : m_model->rowCount() - 1;
    const int found = m_model->findFrom(from, forward);
    if (found < 0)
        return;
    setPaused(true);
    m_table->setCurrentIndex(m_model->index(found, 0));
    m_table->scrollTo(m_model->index(found, 0));
}

void BusPage::tick()
{
    if (m_model->fetch() && !m_paused)
        toEnd();
    const LinkView *shown = link();
    const Instant now = m_workbench.now();
    if (!shown || now - m_idsAt < idsTime)
        return;
    m_idsAt = now;
    m_ids->refresh(m_workbench.presentOf(shown->address));
    showState(*shown);
}

void BusPage::showState(const LinkView &link)
{
    const std::uint64_t frames = link.counters.rx + link.counters.tx;
    const Instant now = m_workbench.now();
    if (m_rateLink != link.address || now - m_rateAt >= loadTime) {
        const bool known = m_rateLink == link.address;
        m_rate = known ? static_cast<double>(frames - std::min(frames, m_rateFrames))
                / std::chrono::duration<double>(now - m_rateAt).count()
                       : 0.0;
        m_rateLink = link.address;
        m_rateAt = now;
        m_rateFrames = frames;
    }
    const auto bold = [this](const QString &text, const QColor &color) {
        return QStringLiteral("<b style='color:%1'>%2</b>").arg(color.name(), text);
    };
    const Theme &theme = m_theme.theme();
    const auto count = [](std::uint64_t number) { return formatCount(static_cast<qint64>(number)); };
    QString state = tr("load %1 &nbsp; frames/s %2 &nbsp; dropped %3 &nbsp; errors %4")
                        .arg(bold(formatValue(link.load * 100.0, 0, QStringLiteral("%")), theme.text),
                            bold(formatNumber(m_rate, 0), theme.text),
                            bold(count(link.counters.lost), link.counters.lost > 0 ? theme.caution : theme.ok),
                            bold(count(link.counters.errors), link.counters.errors > 0 ? theme.danger : theme.ok));
    if (m_model->skipped() > 0)
        state += QStringLiteral(" &nbsp; ") + tr("not kept %1").arg(bold(count(m_model->skipped()), theme.caution));
    m_bar->setState(state);
    m_bar->setResult(
        tr("%1 of %2 shown")
            .arg(formatCount(m_model->rowCount()), formatCount(static_cast<qint64>(m_model->kept().size()))));
    m_loadCaption->setText(tr("last 60 s, peak %1 %").arg(formatNumber(m_load->peak() * 100.0, 0)));
    m_facts->setText(factsOf(link));
}

QString BusPage::factsOf(const LinkView &link) const
{
    QStringList facts{tr("%1 identifiers").arg(m_ids->rowCount())};
    if (const TrafficRow *busiest = m_ids->busiest())
        facts += tr("busiest %1, %2 frames/s").arg(hexId(busiest->last), formatNumber(busiest->rate, 0));
    if (m_ids->unlisted() > 0)
        facts += tr("%1 frames of identifiers without a row").arg(formatCount(static_cast<qint64>(m_ids->unlisted())));
    if (link.unknown > 0)
        facts += tr("%1 frames that no decoder knows").arg(formatCount(static_cast<qint64>(link.unknown)));
    if (link.kind == LinkKind::Can)
        facts += tableText(toString(link.health.state));
    if (link.health.transmitErrors && link.health.receiveErrors)
        facts += tr("error counters TEC %1, REC %2").arg(*link.health.transmitErrors).arg(*link.health.receiveErrors);
    return facts.join(QStringLiteral(" · "));
}

void BusPage::showSelected()
{
    const QModelIndex current = m_table->currentIndex();
    if (!current.isValid() || current.row() >= m_model->rowCount())
        return m_detail->clear();
    const FrameRow &row = m_model->row(current.row());
    m_detail->show(row, m_model->meaning(row), m_model->decoder(), m_model->origin());
}

void BusPage::chooseField(const QPoint &at)
{
    const QModelIndex index = m_idTable->indexAt(at);
    const FrameMeaning *known = index.isValid() ? m_ids->meaning(index.row()) : nullptr;
    if (!known || known->frame.fields.empty())
        return;
    auto *menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const int shown = m_ids->field(index.row());
    const QPersistentModelIndex row(index);
    for (std::size_t i = 0; i < known->frame.fields.size(); ++i) {
        const QString name = qt(known->frame.fields[i].name);
        QAction *action = menu->addAction(name, this, [this, row, name] {
            if (row.isValid())
                m_ids->chooseField(row.row(), name);
        });
        action->setCheckable(true);
        action->setChecked(static_cast<int>(i) == shown);
    }
    menu->popup(m_idTable->viewport()->mapToGlobal(at));
}

Duration BusPage::exportShift() const
{
    const LinkView *shown = link();
    return shown && shown->simulated ? -m_model->origin().time_since_epoch() : m_workbench.unixOffset();
}

QString BusPage::selectedText() const
{
    const LinkView *shown = link();
    const QItemSelectionModel *selection = m_table->selectionModel();
    if (!shown || !selection->hasSelection())
        return {};
    std::vector<int> rows;
    for (const QModelIndex &index : selection->selectedRows())
        rows.push_back(index.row());
    std::sort(rows.begin(), rows.end());
    std::string text;
    for (const int row : rows)
        text += trafficLine(m_model->row(row).record, shown->name, exportShift()) + '\n';
    return QString::fromStdString(text);
}

void BusPage::askWhereTo(bool all)
{
    auto *dialog = new QFileDialog(this, all ? tr("Export all frames") : tr("Export the frames that are shown"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilter(tr("candump log (*.log)"));
    dialog->setDefaultSuffix(QStringLiteral("log"));
    connect(dialog, &QFileDialog::fileSelected, this, [this, all](const QString &path) { exportTo(path, all); });
    dialog->open();
}

void BusPage::exportTo(const QString &path, bool all)
{
    const LinkView *shown = link();
    if (!shown)
        return;
    const auto &kept = m_model->kept();
    const int count = all ? static_cast<int>(kept.size()) : m_model->rowCount();
    const auto at = [&](int i) -> const TrafficRecord & {
        return all ? kept[static_cast<std::size_t>(i)].record : m_model->row(i).record;
    };
    const QString name = QString::fromStdString(shown->name);
    const auto written = exportTraffic(path, count, at, shown->name, exportShift());
    if (!written)
        m_workbench.report(Severity::Danger, name, qt(written.error().text()));
    else
        m_workbench.report(Severity::Info, name, tr("%1 frames written to %2").arg(formatCount(count), path));
}

} // namespace mb
