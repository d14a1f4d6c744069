// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/signal.h"

#include "model/axis.h"
#include "widgets/common/devicetext.h"

#include <QCoreApplication>
#include <QDataStream>
#include <QMimeData>

#include <array>

namespace mb {
namespace {

struct SignalText {
    Q_DECLARE_TR_FUNCTIONS(SignalText)
};

constexpr quint32 mostCarried = 256;
constexpr std::array<std::string_view, 4> usual{"velocity", "position", "current", "duty"};
constexpr std::array<std::string_view, 2> usualOfAxis{"position", "velocity"};

} // namespace

QByteArray toMime(const std::vector<Signal> &carried)
{
    QByteArray data;
    QDataStream stream(&data, QIODevice::WriteOnly);
    stream << static_cast<quint32>(carried.size());
    for (const Signal &signal : carried)
        stream << signal.device.value << signal.channel.value;
    return data;
}

std::vector<Signal> signalsFromMime(const QByteArray &data)
{
    QDataStream stream(data);
    quint32 count = 0;
    stream >> count;
    std::vector<Signal> carried;
    for (quint32 i = 0; i < count && i < mostCarried; ++i) {
        Signal signal;
        stream >> signal.device.value >> signal.channel.value;
        if (stream.status() != QDataStream::Ok)
            return {};
        carried.push_back(signal);
    }
    return carried;
}

QMimeData *carry(const std::vector<Signal> &carried)
{
    if (carried.empty())
        return nullptr;
    auto *data = new QMimeData;
    data->setData(QLatin1String(signalMimeType), toMime(carried));
    return data;
}

QString channelName(const Channel &channel)
{
    const QString label = tableText(channel.label);
    //: Translate as "capital" where a noun has a capital letter in the middle of a line too.
    const bool small = SignalText::tr("small") == QLatin1String("small");
    return small ? label.left(1).toLower() + label.mid(1) : label;
}

QString signalName(const DeviceView &device, ChannelIndex channel)
{
    const Channel &row = device.family->channels[channel.value];
    const int axis = axisOf(row.key);
    return QStringLiteral("#%1 %2%3")
        .arg(device.identity->address)
        .arg(axis > 0 ? QStringLiteral("ch%1 ").arg(axis) : QString(), channelName(row));
}

QString signalName(const DeviceView &device, ChannelIndex channel, const std::vector<DeviceView> &devices)
{
    bool otherFamily = false;
    bool otherLink = false;
    for (const DeviceView &other : devices) {
        const bool same = other.id != device.id && other.identity->address == device.identity->address;
        otherFamily = otherFamily || (same && other.family != device.family);
        otherLink = otherLink || (same && other.family == device.family && other.link != device.link);
    }
    QString name = signalName(device, channel);
    if (otherFamily)
        name = qt(device.family->title) + QLatin1Char(' ') + name;
    if (!otherLink)
        return name;
    const auto link = LinkAddress::parse(device.link);
    return name + QStringLiteral(" (%1)").arg(qt(link ? link->shortName() : device.link));
}

std::vector<Signal> usualSignals(const DeviceView &device, int axis)
{
    std::vector<Signal> found;
    const auto take = [&](const std::string &key) {
        if (const auto channel = device.telemetry->find(key))
            found.push_back({device.id, *channel});
    };
    const int axes = device.family->capabilities.axes;
    if (axis > 0) {
        for (const std::string_view key : usualOfAxis)
            take(axisKey(axis, key));
    } else if (axes > 1) {
        for (int each = 1; each <= axes; ++each)
            take(axisKey(each, usualOfAxis.front()));
    } else {
        for (const std::string_view key : usual)
            take(std::string(key));
    }
    return found;
}

} // namespace mb
