// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/groupmotion.h"

#include "model/leaserenewal.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/guarded.h"

#include <QPointer>

#include <algorithm>

namespace mb {

GroupMotion::GroupMotion(Workbench &workbench, Arming &arming, QObject *parent)
    : QObject(parent)
    , m_workbench(workbench)
    , m_arming(arming)
    , m_renewal(workbench)
{
    connect(&workbench, &Workbench::changed, this, &GroupMotion::follow);
    connect(&arming, &Arming::changed, this, &GroupMotion::follow);
}

bool GroupMotion::prepare(DeviceId lead, std::vector<Member> members)
{
    if (m_arming.isOnTrial(lead)) {
        m_workbench.report(
            Severity::Caution, {}, tr("not prepared: an experiment on the selected device has not ended"));
        return false;
    }
    const bool takesPart = std::ranges::any_of(members, [lead](const Member &member) { return member.device == lead; });
    if (!m_arming.isArmed(lead) || !takesPart) {
        m_workbench.report(Severity::Caution, {},
            takesPart ? tr("not prepared: hold the Arm button first")
                      : tr("not prepared: the selected device has to take part"));
        return false;
    }
    letGo(members);
    m_lead = lead;
    m_started = false;
    m_starting = false;
    m_seen.clear();
    m_members = std::move(members);
    ++m_order;
    for (Member &member : m_members) {
        member.setPoint.buffered = true;
        member.setPoint.order = m_order;
        command(member);
    }
    std::vector<DeviceId> others;
    for (const Member &member : m_members) {
        if (member.device != m_lead) // the arming renews that one
            others.push_back(member.device);
    }
    m_renewal.keep(std::move(others));
    Q_EMIT changed();
    return true;
}

/// Whoever takes no part any more is not left energised until its lease ends.
void GroupMotion::letGo(const std::vector<Member> &staying)
{
    for (const Member &member : m_members) {
        const bool stays = std::ranges::find(staying, member.device, &Member::device) != staying.end();
        if (!stays && member.device != m_lead)
            m_workbench.send(orders::StopMotion{member.device});
    }
}

void GroupMotion::command(const Member &member)
{
    if (member.device == m_lead) {
        m_arming.run(member.setPoint);
        return;
    }
    const DeviceView *view = viewOf(member.device);
    const QString name = view ? titleOf(*view) : QString();
    const auto finished = guarded(this, [this, name](const Result<void> &result) {
        if (result)
            return;
        m_workbench.report(Severity::Danger, name, errorText(result.error()));
        m_arming.halt(); // and follow() stops the rest
    });
    if (view && view->motion.running)
        m_workbench.send(orders::UpdateMotion{member.device, member.setPoint}, finished);
    else
        m_workbench.send(orders::StartMotion{member.device, member.setPoint, LeaseRenewal::term}, finished);
}

bool GroupMotion::hasAcknowledged(DeviceId device) const
{
    const auto member = std::ranges::find(m_members, device, &Member::device);
    const DeviceView *view = viewOf(device);
    if (member == m_members.end() || !view || !view->motion.running || view->motion.setPoint != member->setPoint)
        return false;
    return m_started ? view->liveness.mode == member->setPoint.mode
                     : view->kept.state == KeptMove::State::Acknowledged && view->kept.order == member->setPoint;
}

bool GroupMotion::isPrepared() const
{
    return isActive() && !m_started && !m_starting
        && std::ranges::all_of(m_members, [this](const Member &member) { return hasAcknowledged(member.device); });
}

bool GroupMotion::start()
{
    if (!isPrepared()) {
        m_workbench.report(
            Severity::Caution, {}, tr("not started: not every device has acknowledged its move; prepare them again"));
        return false;
    }
    m_starting = true;
    m_workbench.send(orders::ReleaseMoves{m_lead},
        [self = QPointer<GroupMotion>(this), to = &m_workbench, order = m_order](const Result<void> &result) {
            if (!result)
                to->report(Severity::Danger, {}, errorText(result.error()));
            if (self && order == self->m_order)
                self->released(result.has_value());
        });
    Q_EMIT changed();
    return true;
}

void GroupMotion::released(bool begun)
{
    if (!m_starting)
        return;
    m_starting = false;
    m_started = begun;
    Q_EMIT changed();
}

void GroupMotion::hold()
{
    SetPoint stay;
    stay.mode = Mode::Position;
    stay.relative = true;
    stay.order = ++m_order;
    if (!isActive()) {
        m_arming.run(stay);
        return;
    }
    m_starting = false;
    m_started = true; // what they keep is not to be started any more
    for (Member &member : m_members) {
        member.setPoint = stay;
        command(member);
    }
    Q_EMIT changed();
}

void GroupMotion::follow()
{
    if (!isActive())
        return;
    if (!m_arming.isMoving() || m_arming.device() != m_lead) {
        end();
        return;
    }
    for (const Member &member : m_members) {
        const DeviceView *view = viewOf(member.device);
        const bool running = view && view->motion.running;
        const bool seen = std::ranges::find(m_seen, member.device) != m_seen.end();
        if (running && !seen)
            m_seen.push_back(member.device);
        if (!running && seen && member.device != m_lead) {
            m_workbench.report(Severity::Danger, view ? titleOf(*view) : QString(),
                tr("stopped, and the others of its group with it: %1")
                    .arg(view ? messageText(view->motion.reason) : tr("it is gone")));
            m_arming.halt(); // comes back here as a change of the arming
            return;
        }
    }
    Q_EMIT changed();
}

void GroupMotion::end()
{
    m_renewal.keep({});
    letGo({});
    m_members.clear();
    m_started = false;
    m_starting = false;
    Q_EMIT changed();
}

} // namespace mb
