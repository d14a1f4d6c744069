// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plotspage.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/numberformat.h"
#include "widgets/plots/plotstack.h"
#include "widgets/plots/tracelist.h"

#include <QStackedWidget>

#include <algorithm>
#include <array>

namespace mb {
namespace {

constexpr double idleTime = 0.25; ///< silent devices scroll away this often
constexpr std::array<std::string_view, 4> usual{"velocity", "position", "current", "duty"};

} // namespace

void PlotsPage::follow()
{
    const auto &devices = m_workbench.snapshot().devices;
    m_pages->setCurrentIndex(devices.empty() && m_traces.empty() ? 0 : 1);
    m_signals->setDevices(devices);
    const auto gone = [this](const Trace &trace) { return !m_workbench.snapshot().device(trace.signal.device); };
    if (const auto end = std::remove_if(m_traces.begin(), m_traces.end(), gone); end != m_traces.end()) {
        m_traces.erase(end, m_traces.end());
        rebuild();
    }
    if (!m_touched)
        takeDefaults();
    if (!isVisible())
        return;
    followRates();
    showRows();
}

/// The recordings go on whether or not they are shown, so a change of selection loses nothing.
void PlotsPage::takeDefaults()
{
    const DeviceView *device = m_workbench.snapshot().device(m_selection.device());
    if (!device || device->id == m_defaultsOf || device->identity.state == DeviceState::Bootloader)
        return;
    m_defaultsOf = device->id;
    m_traces.clear();
    for (const std::string_view key : usual) {
        if (const auto channel = device->telemetry->find(key))
            m_traces.push_back({{device->id, *channel}, {}, {}, 0});
    }
    rebuild();
}

void PlotsPage::addSignal(const Signal &signal)
{
    choose(signal, true);
}

void PlotsPage::removeSignal(const Signal &signal)
{
    choose(signal, false);
}

void PlotsPage::choose(const Signal &signal, bool on)
{
    const auto found
        = std::find_if(m_traces.begin(), m_traces.end(), [&](const Trace &trace) { return trace.signal == signal; });
    const DeviceView *device = m_workbench.snapshot().device(signal.device);
    if (on == (found != m_traces.end()) || (on && (!device || signal.channel.value >= device->family->channels.size())))
        return;
    m_touched = true;
    if (on)
        m_traces.push_back({signal, {}, {}, 0});
    else
        m_traces.erase(found);
    rebuild();
}

void PlotsPage::rebuild()
{
    m_stack->clear();
    std::set<Signal> chosen;
    QStringList strips;
    bool simulated = false;
    for (Trace &trace : m_traces) {
        const DeviceView &device = *m_workbench.snapshot().device(trace.signal.device);
        const Channel &row = device.family->channels[trace.signal.channel.value];
        const ShownUnit unit = shownUnit(row.quantity, row.unit, m_units);
        if (!trace.source || &trace.source->telemetry() != device.telemetry.get())
            trace.source = std::make_shared<TelemetrySource>(device.telemetry, trace.signal.channel);
        trace.source->setScale(unit.scale);
        if (!strips.contains(unit.text))
            strips << unit.text;
        trace.style.name = signalName(device, trace.signal.channel);
        trace.style.unit = unit.text;
        trace.style.role = roleOf(row.quantity);
        trace.style.strip = strips.indexOf(unit.text);
        trace.id = m_stack->addTrace(trace.style, trace.source);
        chosen.insert(trace.signal);
        const LinkView *link = m_workbench.snapshot().link(device.link);
        simulated = simulated || (link && link->simulated);
    }
    m_stack->setWatermark(simulated ? tr("DEMO") : QString());
    m_stack->setClock(std::chrono::duration<double>(m_workbench.unixOffset()).count());
    m_plots->setCurrentIndex(m_traces.empty() ? 0 : 1);
    m_signals->setChosen(chosen);
    followRates();
    showRows();
    m_drawn = 0;
    m_drawnAt = 0.0;
    tick();
}

void PlotsPage::followRates()
{
    for (const Trace &trace : m_traces) {
        const DeviceView *device = m_workbench.snapshot().device(trace.signal.device);
        const std::size_t place = trace.signal.channel.value;
        if (device && trace.source)
            trace.source->follow(place < device->rates.size() ? device->rates[place] : 0.0, m_workbench.now());
    }
    double rate = 0.0;
    std::uint64_t lost = 0;
    std::uint64_t all = 0;
    for (const Trace &trace : m_traces) {
        rate += trace.source->rate();
        lost += trace.source->lost();
        all += trace.source->lost() + trace.source->telemetry().size(trace.signal.channel);
    }
    const QString foot = tr("%1 signals, %2 samples/s, %3 of %4 lost")
                             .arg(formatCount(static_cast<qint64>(m_traces.size())), formatNumber(rate),
                                 formatCount(static_cast<qint64>(lost)), formatCount(static_cast<qint64>(all)));
    for (const Trace &trace : m_traces)
        trace.source->setFootText(foot);
}

void PlotsPage::showRows()
{
    std::vector<TraceList::Row> rows;
    for (const Trace &trace : m_traces) {
        const DeviceView *device = m_workbench.snapshot().device(trace.signal.device);
        const LinkView *link = device ? m_workbench.snapshot().link(device->link) : nullptr;
        TraceList::Row row;
        row.id = trace.id;
        row.look.role = trace.style.role;
        row.name = trace.style.name;
        row.source = link ? QString::fromStdString(link->name) : QString();
        row.rate = tr("%1 Hz").arg(formatNumber(trace.source->rate()));
        row.lost = tr("%1 lost").arg(formatCount(static_cast<qint64>(trace.source->lost())));
        row.lossy = trace.source->lossy();
        const int decimals = trace.style.role == TraceRole::Position || trace.style.role == TraceRole::Velocity ? 0 : 2;
        const auto latest = trace.source->latest();
        row.value = latest ? formatValue(*latest, decimals, trace.style.unit) : QString(UnknownMark);
        if (m_stack->cursorsShown()) {
            const auto [a, b] = m_stack->cursorKeys();
            row.cursors = tr("A %1   B %2")
                              .arg(formatValue(m_stack->valueAt(trace.id, a), decimals, {}),
                                  formatValue(m_stack->valueAt(trace.id, b), decimals, trace.style.unit));
        }
        rows.push_back(row);
    }
    m_list->setRows(std::move(rows));
}

std::uint64_t PlotsPage::revision() const
{
    std::uint64_t sum = 0;
    for (const Trace &trace : m_traces)
        sum += trace.source ? trace.source->telemetry().revision() : 0;
    return sum;
}

void PlotsPage::tick()
{
    const double now = plotKey(m_workbench.now());
    const std::uint64_t present = revision();
    if (m_traces.empty() || (present == m_drawn && now - m_drawnAt < idleTime))
        return;
    m_drawn = present;
    m_drawnAt = now;
    m_stack->refresh(now);
}

} // namespace mb
