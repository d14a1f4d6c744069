// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/stationlamp.h"

#include "app/closing.h"
#include "widgets/common/headerbar.h"
#include "widgets/control/arming.h"
#include "widgets/service/verdictof.h"

#include <algorithm>

namespace mb {

StationLamp::StationLamp(
    Workbench &workbench, Arming &arming, const Closing &closing, Selection &selection, HeaderBar &header)
    : QObject(&header)
    , m_workbench(workbench)
    , m_arming(arming)
    , m_closing(closing)
    , m_selection(selection)
    , m_header(header)
{
    connect(&workbench, &Workbench::serviceChanged, this, &StationLamp::follow);
    connect(&header.lamp(), &Lamp::armRequested, this, &StationLamp::arm);
    connect(&header.lamp(), &Lamp::disarmRequested, this, &StationLamp::disarm);
}

void StationLamp::follow()
{
    LampStatus status = over(m_arming.status(m_selection.device()));
    status.armable = status.armable && !m_closing.isEnding();
    m_header.setLampStatus(status);
}

/// The unit whose self-test runs now, its motor with it, until it is seen to rest; one that is announced, or waits, turns nothing yet.
const service::QueueRow *StationLamp::tested() const
{
    const ServiceView &view = m_workbench.service();
    const auto isTested = [](const service::QueueRow &row) {
        return row.state == service::RowState::Running && row.visit.step == service::Step::Test;
    };
    const bool turns = std::ranges::count_if(view.rows, isTested) > view.announced + view.waiting;
    return turns ? &**std::ranges::find_if(view.rows, isTested) : nullptr;
}

/// What a queue says never makes less of a motor that moves, or may.
LampStatus StationLamp::over(LampStatus status) const
{
    if (!m_workbench.service().running || (status.state != LampState::Safe && status.state != LampState::Stopped))
        return status;
    const ServiceView &view = m_workbench.service();
    status.candidate = {};
    status.remaining.reset();
    if (const service::QueueRow *row = tested()) {
        status.state = LampState::Moving;
        status.detail = tr("%1 self-test").arg(nameOf(*row));
    } else if (view.isArmed()) {
        status.state = LampState::Armed;
        status.detail = view.announced > 0 ? tr("turns in a moment") : tr("self-tests");
        if (view.announced == 0)
            status.remaining = std::chrono::duration_cast<std::chrono::seconds>(
                std::max(view.armedUntil - m_workbench.now(), Duration::zero()));
    } else {
        status.armable = view.moves();
        status.detail = view.moves() ? QString() : tr("nothing turns here");
    }
    return status;
}

void StationLamp::arm()
{
    if (!m_workbench.service().running)
        m_arming.arm(m_selection.device());
    else if (m_workbench.service().moves())
        m_workbench.send(orders::ArmService{true});
}

/// A motor that turns is stopped, too.
void StationLamp::disarm()
{
    const bool turns = tested() != nullptr;
    if (!turns && !m_workbench.service().isArmed())
        return m_arming.disarm();
    if (turns)
        m_arming.stopAll(tr("Arm button"));
    m_workbench.send(orders::ArmService{false});
}

} // namespace mb
