// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parametercommands.h"

#include "widgets/common/banner.h"
#include "widgets/common/devicetext.h"
#include "widgets/parameters/editdesk.h"

#include <QPointer>

namespace mb {
namespace {

// Notices in the strip of the window.
constexpr auto writeNotice = "parameters write";
constexpr auto historyNotice = "parameters history";

} // namespace

ParameterCommands::ParameterCommands(Workbench &workbench, BannerStack &banners, QObject *parent)
    : QObject(parent)
    , m_workbench(workbench)
    , m_banners(banners)
{
}

void ParameterCommands::refuse(const char *key, DeviceId device, const Error &error, const QString &remedy)
{
    const DeviceView *of = m_workbench.snapshot().device(device);
    const QString cause = errorText(error);
    m_banners.post(
        QLatin1String(key), BannerKind::Danger, of ? titleOf(*of) + QStringLiteral(": ") + cause : cause, remedy);
}

void ParameterCommands::read(DeviceId device)
{
    m_workbench.send(orders::ReadParameters{device});
}

void ParameterCommands::write(DeviceId device, const std::vector<ParameterChange> &changes)
{
    m_banners.clear(QLatin1String(writeNotice));
    m_workbench.send(orders::WriteParameters{device, changes},
        [commands = QPointer(this), device, changes](const Result<void> &result) {
            if (commands)
                commands->settle(device, changes, result);
        });
}

void ParameterCommands::settle(DeviceId device, const std::vector<ParameterChange> &sent, const Result<void> &result)
{
    if (StagedEdits *edits = EditDesk::of(m_workbench).find(device); result && edits)
        edits->settle(sent);
    if (!result)
        refuse(writeNotice, device, result.error(),
            tr("What was written before it is in force; the rest is still staged. Nothing was stored."));
    Q_EMIT written();
}

void ParameterCommands::store(DeviceId device)
{
    m_banners.clear(QLatin1String(writeNotice));
    m_workbench.send(orders::StoreParameters{device}, [commands = QPointer(this), device](const Result<void> &result) {
        if (commands && !result)
            commands->refuse(writeNotice, device, result.error(),
                tr("Nothing is proved to be in flash. Store again, and keep power on."));
    });
}

/// The end of an order that leaves something in the history.
std::function<void(const Result<void> &)> ParameterCommands::keeping(DeviceId device, const QString &remedy)
{
    return [commands = QPointer(this), device, remedy](const Result<void> &result) {
        if (commands && !result)
            commands->refuse(historyNotice, device, result.error(),
                result.error().fault == Fault::Unsafe ? QString() : remedy); // nothing was done
        else if (commands)
            Q_EMIT commands->kept();
    };
}

void ParameterCommands::takeSnapshot(DeviceId device)
{
    m_workbench.send(orders::TakeSnapshot{device, {}}, keeping(device, tr("Nothing is kept.")));
}

void ParameterCommands::undoWrite(DeviceId device, bool again)
{
    m_banners.clear(QLatin1String(historyNotice));
    m_workbench.send(orders::UndoWrite{device, again}, keeping(device, {}));
}

void ParameterCommands::restore(DeviceId device, const std::vector<ParameterChange> &changes)
{
    m_banners.clear(QLatin1String(historyNotice));
    m_workbench.send(orders::RestoreParameters{device, changes},
        keeping(device, tr("What was written before it is in force. Undo takes it back.")));
}

} // namespace mb
