// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/triggerwatch.h"

#include "widgets/common/numberformat.h"

#include <QCoreApplication>
#include <cmath>

namespace mb {
namespace {

constexpr int mostEvents = 50; ///< that one look may go through

struct TriggerText {
    Q_DECLARE_TR_FUNCTIONS(TriggerText)
};

/// So that noise at the level is one edge: a tenth of the spread of what came lately.
double hysteresisOf(const TelemetrySource &source, double now)
{
    constexpr double lately = 2.0;
    const auto found = source.statistics(now - lately, now);
    return found ? found->deviation * 0.1 / std::abs(source.scale()) : 0.0;
}

} // namespace

void TriggerWatch::arm(const TriggerSetup &setup, std::shared_ptr<const TelemetrySource> source, double now)
{
    m_setup = setup;
    m_event.reset();
    m_events = 0;
    m_done = false;
    m_armedAt = now;
    const TriggerRule rule{setup.kind, setup.level / source->scale(), hysteresisOf(*source, now)};
    constexpr Duration lead = std::chrono::seconds(1); // an edge needs to know from where it comes
    m_search.emplace(rule, source->sharedTelemetry(), source->channel(), instantOf(now) - lead);
    m_scale = source->scale();
    m_source = std::move(source);
    m_stack.view().hold({}, setup.before);
    show(now);
}

void TriggerWatch::disarm()
{
    m_search.reset();
    m_source.reset();
    m_event.reset();
    m_done = false;
    m_stack.view().hold({}, m_setup.before);
    m_stack.setStateText({});
}

double TriggerWatch::windowEnd() const
{
    return *m_event + m_stack.view().window() * (1.0 - m_setup.before);
}

void TriggerWatch::poll(double now)
{
    if (!m_search)
        return;
    for (int i = 0; i < mostEvents && !m_done; ++i) {
        if (m_event && now < windowEnd())
            break; // the window is being filled
        if (m_event && m_setup.mode == TriggerSetup::Mode::Single) {
            m_done = true;
            break;
        }
        const auto found = m_search->poll(instantOf(m_event ? windowEnd() : m_armedAt));
        if (!found)
            break;
        m_event = plotKey(*found);
        ++m_events;
    }
    show(now);
}

void TriggerWatch::show(double now)
{
    m_stack.view().hold(m_event, m_setup.before);
    if (!m_event)
        m_stack.setStateText(TriggerText::tr("trigger armed, waiting"));
    else if (m_done)
        m_stack.setStateText(TriggerText::tr("single event caught"));
    else if (now < windowEnd())
        m_stack.setStateText(TriggerText::tr("event %1, filling").arg(m_events));
    else
        m_stack.setStateText(TriggerText::tr("event %1, waiting for the next").arg(m_events));
}

} // namespace mb
