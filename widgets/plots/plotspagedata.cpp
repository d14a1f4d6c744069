// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/devicetext.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/ratekeeper.h"
#include "widgets/common/replaybar.h"
#include "widgets/plots/plotscrubber.h"
#include "widgets/plots/plotspage.h"
#include "widgets/plots/tracelist.h"
#include "widgets/plots/triggerbar.h"

#include <QStackedWidget>

#include <algorithm>
#include <array>
#include <cmath>

namespace mb {
namespace {

constexpr double idleScroll = 0.25; ///< silent devices scroll away this often
/// Samples per second to wish for, so that zooming does not change them all the time.
constexpr std::array<double, 5> rateSteps{20.0, 50.0, 100.0, 200.0, 500.0};
constexpr double narrowestWindow = 0.01;

int decimalsOf(const TraceStyle &style)
{
    return style.role == TraceRole::Position || style.role == TraceRole::Velocity ? 0 : 2;
}

} // namespace

void PlotsPage::follow()
{
    const auto &devices = m_workbench.snapshot().devices;
    m_pages->setCurrentIndex(devices.empty() && m_board->traces().empty() ? 0 : 1);
    m_signals->setDevices(devices);
    m_board->follow();
    m_replay->setLink(m_board->link());
    if (m_waiting)
        applyWaiting(false);
    else if (!m_board->isTouched())
        takeDefaults();
    if (!isVisible())
        return;
    m_board->followRates();
    wishRates();
    showRows();
    showRecording();
}

/// What is plotted comes as often as the screen can show it, and not more often.
void PlotsPage::wishRates()
{
    std::vector<RateKeeper::Wish> wishes;
    const auto add = [&](const Signal &signal, double hertz) {
        const DeviceView *device = m_workbench.snapshot().device(signal.device);
        if (device && device->telemetry && RateKeeper::isFree(*device))
            wishes.push_back({signal.device, signal.channel, hertz});
    };
    if (isVisible()) {
        const double columns = std::max(m_stack->width(), 1) / std::max(m_stack->window(), narrowestWindow);
        const auto step
            = std::find_if(rateSteps.begin(), rateSteps.end(), [&](double rate) { return rate >= columns; });
        const double hertz = step == rateSteps.end() ? rateSteps.back() : *step;
        for (const PlotBoard::Trace &trace : m_board->traces())
            add(trace.signal, hertz);
        for (const Signal &signal : m_board->ingredients())
            add(signal, hertz);
    }
    RateKeeper::of(m_workbench).wish(this, wishes);
}

/// The recordings go on whether or not they are shown, so a change of selection loses nothing.
void PlotsPage::takeDefaults()
{
    const DeviceView *device = m_workbench.snapshot().device(m_selection.device());
    const int axis = m_selection.axis();
    const bool same = device && device->id == m_defaultsOf && axis == m_defaultsOfAxis;
    if (!device || same || device->identity.state == DeviceState::Bootloader)
        return;
    m_defaultsOf = device->id;
    m_defaultsOfAxis = axis;
    if (const auto own = m_layouts.load(PlotLayouts::familyName(qt(device->family->key))); own && axis == 0) {
        m_stack->setWindow(own->window);
        return m_board->setTraces(tracesOf(*own, device->id), false);
    }
    std::vector<PlotBoard::Trace> traces;
    for (const Signal &signal : usualSignals(*device, axis))
        traces.push_back({signal, {}});
    m_board->setTraces(std::move(traces), false);
}

void PlotsPage::addSignal(const Signal &signal)
{
    m_board->choose(signal, true);
}

void PlotsPage::addSignals(const std::vector<Signal> &wanted)
{
    for (const Signal &signal : wanted)
        m_board->choose(signal, true);
}

void PlotsPage::removeSignal(const Signal &signal)
{
    m_board->choose(signal, false);
}

void PlotsPage::boardChanged()
{
    std::set<Signal> chosen;
    std::vector<TriggerBar::Choice> choices;
    for (const PlotBoard::Trace &trace : m_board->traces()) {
        chosen.insert(trace.signal);
        choices.push_back({trace.id, trace.style.name, trace.style.unit});
    }
    QStringList derived;
    for (const PlotBoard::Derived &signal : m_board->derived())
        derived << signal.name;
    m_signals->setDerived(derived);
    m_signals->setChosen(chosen);
    m_triggerBar->setTraces(choices);
    if (m_trigger.isArmed())
        m_board->traces().empty() ? triggerOff() : arm();
    fillAgainst();
    if (m_view && m_plots->currentIndex() <= 1)
        m_plots->setCurrentIndex(m_board->traces().empty() ? 0 : 1);
    if (!m_board->traces().empty())
        m_scrubber->setSource(m_board->traces().front().source, m_board->traces().front().style.look());
    if (m_board->isTouched())
        m_remember.start();
    showRows();
    m_drawn = 0;
    m_drawnAt = 0.0;
    draw();
}

QString PlotsPage::statisticsOf(const PlotBoard::Trace &trace, int decimals) const
{
    const auto found = m_stack->selection(trace.id);
    if (!found)
        return {};
    QString text = tr("mean %1 · σ %2 · %3 … %4 · %5 samples")
                       .arg(formatValue(found->mean, decimals, {}), formatSignificant(found->deviation, 3),
                           formatValue(found->low, decimals, {}), formatValue(found->high, decimals, {}),
                           formatCount(static_cast<qint64>(found->count)));
    if (found->lost > 0)
        text += tr(" · %1 lost").arg(formatCount(static_cast<qint64>(found->lost)));
    return text;
}

void PlotsPage::showRows()
{
    std::vector<TraceList::Row> rows;
    for (const PlotBoard::Trace &trace : m_board->traces()) {
        const DeviceView *device = m_workbench.snapshot().device(trace.signal.device);
        const LinkView *link = device ? m_workbench.snapshot().link(device->link) : nullptr;
        TraceList::Row row;
        row.id = trace.id;
        row.look = trace.style.look();
        row.name = trace.style.name;
        row.source = link ? QString::fromStdString(link->name) : device ? QString() : tr("derived");
        row.rate = tr("%1 Hz").arg(formatNumber(trace.source->rate()));
        row.lost = tr("%1 lost").arg(formatCount(static_cast<qint64>(trace.source->lost())));
        row.lossy = trace.source->lossy();
        const int decimals = decimalsOf(trace.style);
        const auto latest = trace.source->latest();
        row.value = latest ? formatValue(*latest, decimals, trace.style.unit) : QString(UnknownMark);
        if (m_stack->cursorsShown()) {
            const auto [a, b] = m_stack->cursorKeys();
            row.cursors = tr("A %1   B %2")
                              .arg(formatValue(m_stack->valueAt(trace.id, a), decimals, {}),
                                  formatValue(m_stack->valueAt(trace.id, b), decimals, trace.style.unit));
            row.statistics = statisticsOf(trace, decimals);
        }
        rows.push_back(row);
    }
    m_list->setRows(std::move(rows));
}

void PlotsPage::followSession(double now)
{
    double first = now;
    for (const PlotBoard::Trace &trace : m_board->traces()) {
        const auto begin = trace.source->telemetry().first(trace.source->channel());
        first = begin ? std::min(first, plotKey(begin->time)) : first;
    }
    m_scrubber->setSession(first, now, std::chrono::duration<double>(m_workbench.unixOffset()).count());
    m_scrubber->follow();
}

void PlotsPage::tick()
{
    if (m_stack->budget().isDue())
        draw();
}

void PlotsPage::draw()
{
    if (!isVisible())
        return;
    m_board->advance();
    const double now = plotKey(m_board->present());
    const std::uint64_t present = m_board->revision();
    if (m_board->traces().empty() || (present == m_drawn && std::abs(now - m_drawnAt) < idleScroll))
        return;
    m_drawn = present;
    m_drawnAt = now;
    const Painting painting(m_stack->budget());
    m_trigger.poll(now);
    m_stack->refresh(now);
    followSession(now);
    refreshView(now);
}

} // namespace mb
