// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/motionwords.h"

#include "model/identity.h"
#include "widgets/common/devicetext.h"

#include <QCoreApplication>

#include <algorithm>

namespace mb {
namespace {

struct MotionWords {
    Q_DECLARE_TR_FUNCTIONS(mb::MotionWords)
};

} // namespace

QString addressIn(const Snapshot &shot, DeviceId device)
{
    const DeviceView *const view = shot.device(device);
    return view ? QStringLiteral("#%1").arg(view->identity->address) : QString();
}

QString titleIn(const Snapshot &shot, DeviceId device)
{
    const DeviceView *const view = shot.device(device);
    return view ? titleOf(*view) : QString();
}

QString whatMoves(const DeviceView *view, Mode mode)
{
    const auto axes = view ? view->motion.setPoints.size() : 0;
    if (!view || view->family->capabilities.axes == 1 || axes == 0)
        return modeText(mode);
    if (axes > 1)
        return MotionWords::tr("%1 axes").arg(axes);
    const SetPoint &only = view->motion.setPoints.front();
    return MotionWords::tr("axis %1 %2").arg(only.axis).arg(modeText(only.mode));
}

bool isTried(const Snapshot &shot, DeviceId device)
{
    const OperationView *job = shot.operation(device);
    return job && job->status.state == OperationStatus::State::Running
        && (job->status.kind == OperationKind::Trial || job->status.kind == OperationKind::FamilyExperiment);
}

const DeviceView *experimentedWith(const Snapshot &shot)
{
    const auto found = std::ranges::find_if(shot.devices, [&shot](const DeviceView &device) {
        const OperationView *job = shot.operation(device.id);
        return device.motion.running && job && job->status.state == OperationStatus::State::Running
            && job->status.kind == OperationKind::FamilyExperiment;
    });
    return found == shot.devices.end() ? nullptr : &*found;
}

QString namesThatMayTurn(const Snapshot &shot)
{
    QStringList names;
    for (const DeviceView &device : shot.devices) {
        if (device.mayTurn)
            names += addressIn(shot, device.id);
    }
    return (names + namesOwed(shot)).join(QStringLiteral(", "));
}

QStringList namesOwed(const Snapshot &shot)
{
    QStringList names;
    for (const OwedStopView &owed : shot.owedStops) {
        const QString name = qt(partsOf(owed.device).device);
        names += owed.elsewhere ? MotionWords::tr("%1 on the adapter before").arg(name) : name;
    }
    return names;
}

QString namesLeftOut(const Snapshot &shot, bool why)
{
    QStringList names;
    for (const DeviceView &device : shot.devices) {
        if (!device.mayNotBeStopped.empty())
            names += addressIn(shot, device.id)
                + (why ? QStringLiteral(" (%1)").arg(messageText(device.mayNotBeStopped)) : QString());
    }
    return names.join(QStringLiteral(", "));
}

bool isStopping(const Snapshot &shot)
{
    return std::ranges::any_of(shot.devices,
        [](const DeviceView &device) { return device.stop == StopState::Stopping && device.stopsMotion; });
}

} // namespace mb
