// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/sendguard.h"

#include "widgets/common/devicetext.h"
#include "widgets/monitor/frametext.h"

#include <QCoreApplication>
#include <QRegularExpression>

namespace mb {
namespace {

struct SendGuard {
    Q_DECLARE_TR_FUNCTIONS(SendGuard)
};

std::vector<const DeviceView *> addressed(const FrameMeaning &meaning, const std::string &link, const Snapshot &shot)
{
    std::vector<const DeviceView *> found;
    for (const DeviceView &device : shot.devices) {
        if (device.link == link && device.family && device.family->key == meaning.family->key
            && device.identity->address == meaning.frame.address)
            found.push_back(&device);
    }
    return found;
}

QString refusalOfControl(
    const std::vector<const DeviceView *> &devices, const FrameMeaning &meaning, const Arming &arming)
{
    const QString number = QStringLiteral("#%1").arg(meaning.frame.address);
    if (devices.empty())
        return SendGuard::tr("No %1 %2 is known on this link, so STOP could not reach it. Scan first.")
            .arg(qt(meaning.family->title), number);
    if (devices.size() > 1)
        return SendGuard::tr("Two units answer as %1. Assign one a new number first.").arg(number);
    const DeviceView &device = *devices.front();
    if (!device.family->capabilities.watchdog)
        return SendGuard::tr("%1 keeps its last set-point for ever: it has no watchdog. Drive it from the Tune page.")
            .arg(titleOf(device));
    if (!device.busy.empty())
        return SendGuard::tr("%1 is busy: %2").arg(titleOf(device), messageText(device.busy));
    if (device.motion.running)
        return SendGuard::tr("This window drives %1 already. Halt it first.").arg(titleOf(device));
    if (!device.mayNotMove.empty())
        return messageText(device.mayNotMove);
    if (!arming.isArmed(device.id))
        return SendGuard::tr("%1 is not armed. Select it, then hold Arm in the header.").arg(titleOf(device));
    return {};
}

} // namespace

TypedFrame readTypedFrame(const QString &id, bool extended, const QString &data)
{
    QString digits = id.trimmed();
    const int hash = digits.indexOf(QLatin1Char('#'));
    if (hash >= 0) {
        const auto whole = canFrameFromText(digits.section(QLatin1Char(' '), -1).toStdString());
        return whole ? TypedFrame{whole, {}}
                     : TypedFrame{{}, SendGuard::tr("'%1' is no frame such as 02061405#8125").arg(digits)};
    }
    if (digits.startsWith(QLatin1String("0x"), Qt::CaseInsensitive))
        digits.remove(0, 2);
    bool good = false;
    const uint number = digits.toUInt(&good, 16);
    if (!good)
        return {{}, SendGuard::tr("The identifier is hexadecimal, such as 7FF or 02061405")};
    if (number > (extended ? 0x1FFFFFFFU : 0x7FFU))
        return {{},
            extended ? SendGuard::tr("%1 has more than 29 bits: at most 1FFFFFFF").arg(digits)
                     : SendGuard::tr("%1 has more than 11 bits: choose 29 bits").arg(digits)};
    QString bytes = data;
    bytes.remove(QRegularExpression(QStringLiteral("[\\s.]")));
    static const QRegularExpression hex(QStringLiteral("^([0-9A-Fa-f]{2})*$"));
    if (!hex.match(bytes).hasMatch())
        return {{}, SendGuard::tr("The data are pairs of hexadecimal digits, such as 81 25 11")};
    if (bytes.size() > 16)
        return {{}, SendGuard::tr("%1 bytes: a frame has at most 8").arg(bytes.size() / 2)};
    CanFrame frame;
    frame.id = number;
    frame.extended = extended;
    frame.size = static_cast<std::uint8_t>(bytes.size() / 2);
    for (int i = 0; i < frame.size; ++i)
        frame.data.at(static_cast<std::size_t>(i)) = static_cast<std::uint8_t>(bytes.mid(i * 2, 2).toUInt(nullptr, 16));
    return {frame, {}};
}

SendVerdict judgeFrame(const CanFrame &frame, const std::string &link, const Snapshot &shot, const Arming &arming)
{
    const FrameDecoder decoder = decoderFor(shot, link);
    const auto control = decoder.control(frame);
    const auto meaning = control ? control : decoder.decode(frame);
    SendVerdict verdict;
    verdict.control = control.has_value();
    verdict.meaning = !meaning ? SendGuard::tr("no decoder knows this identifier")
                               : SendGuard::tr("%1 of %2 #%3   %4")
                                     .arg(qt(meaning->frame.message), qt(meaning->family->title))
                                     .arg(meaning->frame.address)
                                     .arg(fieldsLine(meaning->frame));
    const LinkView *view = shot.link(link);
    if (!view || view->state != LinkState::Open || view->kind != LinkKind::Can) {
        verdict.refusal = view && view->kind == LinkKind::Can && !view->reason.empty()
            ? messageText(view->reason)
            : SendGuard::tr("No open CAN link is shown. Open one first.");
        return verdict;
    }
    if (!control)
        return verdict;
    const auto devices = addressed(*control, link, shot);
    verdict.refusal = refusalOfControl(devices, *control, arming);
    if (verdict.refusal.isEmpty())
        verdict.device = devices.front()->id;
    return verdict;
}

} // namespace mb
