// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/conditions.h"

#include "experiment/owedgains.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/guarded.h"
#include "widgets/common/updates.h"
#include "widgets/control/arming.h"
#include "widgets/control/motionwords.h"

#include <utility>

namespace mb {
namespace {

constexpr auto resetKey = "reset ";
constexpr auto mayTurnKey = "may turn ";
constexpr auto owedKey = "owed ";

QString thingOf(const QString &key)
{
    return key.section(QLatin1Char('\n'), 0, 0);
}

QString resetKeyOf(DeviceId device)
{
    return QLatin1String(resetKey) + QString::number(device.value);
}

/// The job that writes the settings again, while it runs.
const OperationView *rewriting(const Snapshot &shot, DeviceId device)
{
    const OperationView *operation = shot.operation(device);
    const bool runs = operation && operation->status.state == OperationStatus::State::Running
        && operation->status.kind == OperationKind::RewriteSettings;
    return runs ? operation : nullptr;
}

} // namespace

Conditions::Conditions(Workbench &workbench, Arming &arming, BannerStack &banners, QObject *parent)
    : QObject(parent)
    , m_workbench(workbench)
    , m_arming(arming)
    , m_banners(banners)
{
    connect(&banners, &BannerStack::actionTriggered, this, &Conditions::act);
    connect(&banners, &BannerStack::otherTriggered, this, [this](const QString &key) { settleOwed(key, true); });
}

void Conditions::follow()
{
    const std::set<QString> before = std::exchange(m_standing, {});
    for (const LinkView &link : m_workbench.snapshot().links)
        followLink(link);
    for (const DeviceView &device : m_workbench.snapshot().devices) {
        followDevice(device);
        followReset(device);
    }
    followUpdates();
    followOwed();
    if (const QString names = namesThatMayTurn(m_workbench.snapshot()); !names.isEmpty())
        post(QLatin1String(mayTurnKey) + names, BannerKind::Danger, tr("%1 may still turn: cut its power").arg(names),
            tr("Its stop was not confirmed. It is sent again, and first of all when its line is back."),
            tr("I have looked: it stands"));
    if (m_arming.state() == LampState::Stopped)
        post(QStringLiteral("stopped ") + m_arming.reason(),
            m_arming.isStoppedByHand() ? BannerKind::Ended : BannerKind::Danger,
            tr("Stopped: %1").arg(m_arming.reason()), tr("Hold the Arm button for 1 s to arm again."));
    std::set<QString> things;
    for (const QString &key : m_standing)
        things.insert(thingOf(key));
    for (const QString &over : before) {
        if (m_standing.contains(over))
            continue;
        const bool isOver = !things.contains(thingOf(over));
        m_banners.clear(over, isOver);
        if (!isOver)
            m_standing.insert(over);
    }
    std::erase_if(m_failures, [this](const auto &failure) { return !m_workbench.snapshot().device(failure.first); });
}

void Conditions::post(const QString &key, BannerKind kind, const QString &cause, const QString &remedy,
    const QString &action, const QString &other)
{
    m_standing.insert(key);
    m_banners.post(key, kind, cause, remedy, action, other);
}

void Conditions::followLink(const LinkView &link)
{
    const QString thing = QStringLiteral("link ") + QString::fromStdString(link.address);
    const QString ailment = QStringLiteral("\n%1").arg(static_cast<int>(link.diagnosis.ailment));
    const QString name = QString::fromStdString(link.name);
    if (link.state == LinkState::Lost) {
        m_standing.insert(thing); // nor is it well
        post(QStringLiteral("lost ") + thing + ailment, BannerKind::Danger, tr("%1 is lost").arg(name),
            messageText(link.reason));
    } else if (!link.diagnosis.isHealthy()) {
        post(thing + ailment, BannerKind::Caution, name + QStringLiteral(": ") + messageText(link.diagnosis.cause),
            messageText(link.diagnosis.remedy));
    }
}

void Conditions::followDevice(const DeviceView &device)
{
    if (device.liveness.foreignMaster)
        post(QStringLiteral("driven %1").arg(device.id.value), BannerKind::Caution,
            tr("Another master drives %1").arg(titleOf(device)),
            tr("Arming is off until it stops sending control frames."));
    if (device.identity->state == DeviceState::Duplicate)
        post(QStringLiteral("device %1").arg(device.id.value), BannerKind::Caution,
            tr("Several units answer as %1").arg(titleOf(device)),
            tr("Control is locked. Assign one of them a new number from the menu of its row."));
}

/// On every page, until it is over: what is written, and where.
void Conditions::followUpdates()
{
    const Snapshot &shot = m_workbench.snapshot();
    for (const OperationView &update : runningUpdates(m_workbench)) {
        const QString key = QStringLiteral("update %1").arg(update.device.value);
        const OperationStatus &status = update.status;
        post(key, status.mayInterrupt ? BannerKind::Info : BannerKind::Caution,
            tr("Firmware is being written to %1").arg(placeOf(shot, update)),
            status.total == 0 ? messageText(status.step)
                : status.mayInterrupt
                ? tr("Safe to unplug: the update can be run again. %1 of %2.").arg(status.done).arg(status.total)
                : tr("Do not unplug. %1 of %2.").arg(status.done).arg(status.total));
    }
}

void Conditions::followReset(const DeviceView &device)
{
    const QString key = resetKeyOf(device.id);
    const auto lost = static_cast<int>(lostSettings(*device.family, device.profile).size());
    if (lost == 0) {
        m_failures.erase(device.id);
        return;
    }
    if (const OperationView *operation = rewriting(m_workbench.snapshot(), device.id)) {
        post(key, BannerKind::Caution,
            tr("Writing the settings of %1 again: %2 of %3")
                .arg(titleOf(device))
                .arg(operation->status.done)
                .arg(operation->status.total),
            tr("Each is confirmed by the board."), tr("Cancel"));
        return;
    }
    const auto failure = m_failures.find(device.id);
    post(key, BannerKind::Caution, resetTitle(device, lost),
        failure == m_failures.end() ? (device.family->capabilities.keepsSettings
                ? tr("Nothing shows that it still has what was not saved. This program knows what was last written.")
                : tr("The board keeps nothing without power. This program knows what was last written."))
                                    : failure->second,
        tr("Write them again"));
}

/// Of a unit that keeps what is saved no restart is known for sure: an order without an answer leaves a setting unknown, too.
QString Conditions::resetTitle(const DeviceView &device, int lost) const
{
    if (device.family->capabilities.keepsSettings)
        return lost == 1 ? tr("%1 may have been reset: 1 setting is unknown").arg(titleOf(device))
                         : tr("%1 may have been reset: %2 settings are unknown").arg(titleOf(device)).arg(lost);
    return lost == 1 ? tr("%1 was reset: 1 setting is unknown").arg(titleOf(device))
                     : tr("%1 was reset: %2 settings are unknown").arg(titleOf(device)).arg(lost);
}

/// What an experiment could not put back because its program died: never without being asked.
void Conditions::followOwed()
{
    for (const auto &[id, all] : m_workbench.owedGains()) {
        const DeviceView *device = m_workbench.snapshot().device(id);
        if (!device)
            continue;
        for (const tuning::OwedGains &owed : all) {
            const QString key = QLatin1String(owedKey) + QStringLiteral("%1 %2").arg(id.value).arg(owed.trial);
            const QString values = QString::fromStdString(tuning::assignmentsOf(*device->family, owed.values));
            post(key, BannerKind::Caution,
                tr("Trial #%1 on %2 was cut before it put its gains back").arg(owed.trial).arg(titleOf(*device)),
                placeCaveat(owed.unit) + tr("Before it: %1. The motor must stand.").arg(values), tr("Put them back"),
                tr("Keep what it has"));
        }
    }
}

void Conditions::settleOwed(const QString &key, bool keep)
{
    const QStringList parts = key.split(QLatin1Char(' '));
    const DeviceId device{parts.value(1).toUInt()};
    const std::int64_t trial = parts.value(2).toLongLong();
    if (keep)
        m_workbench.send(orders::DismissGains{device, trial});
    else
        m_workbench.send(orders::PayGains{device, trial});
}

void Conditions::act(const QString &key)
{
    if (key.startsWith(QLatin1String(owedKey)))
        return settleOwed(key, false);
    if (key.startsWith(QLatin1String(mayTurnKey)))
        m_workbench.send(orders::DismissStops{});
    if (!key.startsWith(QLatin1String(resetKey)))
        return;
    const DeviceId device{key.midRef(static_cast<int>(qstrlen(resetKey))).toUInt()};
    if (const OperationView *operation = rewriting(m_workbench.snapshot(), device)) {
        m_workbench.send(orders::CancelOperation{operation->id});
        return;
    }
    m_failures.erase(device);
    m_workbench.send(orders::RewriteSettings{device},
        guarded(this, [this, device](const Result<void> &result) { written(device, result); }));
}

void Conditions::written(DeviceId device, const Result<void> &result)
{
    if (!result)
        m_failures[device] = result.error().fault == Fault::Cancelled
            ? tr("Writing was cancelled; what is missing can be written later.")
            : errorText(result.error());
    follow();
}

} // namespace mb
