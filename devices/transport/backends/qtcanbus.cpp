// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/backends/qtcanbus.h"

#include "transport/backends/hardwaretime.h"
#include "transport/canqueue.h"
#include "wire/number.h"

#include <QCanBus>
#include <QCanBusDevice>
#include <QCanBusDeviceInfo>
#include <QLoggingCategory>
#include <QVariant>

#include <algorithm>

namespace mb {
namespace {

using namespace std::chrono_literals;

/// They print what they return, too; that is nobody's business.
QCanBus &plugins()
{
    QLoggingCategory::setFilterRules(QStringLiteral("qt.canbus*=false"));
    return *QCanBus::instance();
}

constexpr qint64 framesInPlugin = 4; // few, so that an urgent frame does not wait behind many
constexpr Duration retryDelay = 5ms; // of a plugin that refuses a frame: it does not tell when it has room again

CanFrame frameOf(const QCanBusFrame &raw, Instant time)
{
    CanFrame frame;
    frame.error = raw.frameType() == QCanBusFrame::ErrorFrame;
    frame.remote = raw.frameType() == QCanBusFrame::RemoteRequestFrame;
    frame.extended = !frame.error && raw.hasExtendedFrameFormat();
    frame.id = frame.error ? static_cast<std::uint32_t>(raw.error()) & 0x1FFFFFFFU : raw.frameId();
    const QByteArray bytes = raw.payload().left(8);
    frame.size = static_cast<std::uint8_t>(bytes.size());
    std::copy(bytes.begin(), bytes.end(), frame.data.begin());
    frame.time = time;
    return frame;
}

QCanBusFrame rawOf(const CanFrame &frame)
{
    const QByteArray bytes(reinterpret_cast<const char *>(frame.data.data()), frame.size);
    QCanBusFrame raw(frame.id, bytes);
    raw.setExtendedFrameFormat(frame.extended);
    if (frame.remote)
        raw.setFrameType(QCanBusFrame::RemoteRequestFrame);
    return raw;
}

class QtCanLink final : public CanLink {
public:
    QtCanLink(LinkAddress address, Clock &clock, int bitrate)
        : CanLink(std::move(address), clock)
        , m_bitrate(bitrate)
        , m_queue(clock)
        , m_retry(clock)
    {
    }
    ~QtCanLink() override { QtCanLink::doClose(); }

private:
    Result<void> doOpen() override;
    void doClose() override;
    Result<void> doSend(const CanFrame &frame, Priority priority) override;
    [[nodiscard]] std::size_t doBacklog() const override { return m_queue.size(); }
    [[nodiscard]] int doBitrate() const override { return m_bitrate; }
    void watch();
    void receive();
    void pump();
    void end(const QString &reason);

    int m_bitrate;
    std::unique_ptr<QCanBusDevice> m_device;
    HardwareTime m_stamps;
    bool m_isFine
        = false; ///< the adapter stamps finer than in milliseconds, in which a frame of 1 kHz looks lost and another one twice there
    Instant m_latest{};
    CanQueue m_queue;
    Timer m_retry;
};

Result<void> QtCanLink::doOpen()
{
    const QString path = QString::fromStdString(address().path);
    const QString plugin = path.section(QLatin1Char(':'), 0, 0);
    QCanBus &known = plugins();
    if (!known.plugins().contains(plugin)) {
        const QString names = known.plugins().join(QStringLiteral(", "));
        return fail(Fault::LinkLost, say("there is no CAN plugin %1", plugin.toStdString()),
            say("installed are: %1", names.toStdString()));
    }
    QString cause;
    m_device.reset(known.createDevice(plugin, path.section(QLatin1Char(':'), 1), &cause));
    if (m_device && m_bitrate > 0)
        m_device->setConfigurationParameter(QCanBusDevice::BitRateKey, m_bitrate);
    if (!m_device || !m_device->connectDevice()) {
        const QString why = m_device ? m_device->errorString() : cause;
        m_device.reset();
        return fail(Fault::LinkLost, say("%1 cannot be opened: %2", address().path, why.toStdString()));
    }
    m_bitrate = m_device->configurationParameter(QCanBusDevice::BitRateKey).toInt();
    m_stamps.reset();
    m_isFine = false;
    m_latest = {};
    watch();
    return {};
}

void QtCanLink::watch()
{
    QCanBusDevice *device = m_device.get();
    QObject::connect(device, &QCanBusDevice::framesReceived, device, [this] { receive(); });
    QObject::connect(device, &QCanBusDevice::framesWritten, device, [this](qint64) { pump(); });
    QObject::connect(device, &QCanBusDevice::stateChanged, device, [this](QCanBusDevice::CanBusDeviceState now) {
        if (now == QCanBusDevice::ConnectedState)
            pump();
        else if (now == QCanBusDevice::UnconnectedState)
            end(m_device->errorString());
    });
    QObject::connect(device, &QCanBusDevice::errorOccurred, device, [this](QCanBusDevice::CanBusError error) {
        if (error == QCanBusDevice::ConnectionError)
            end(m_device->errorString());
        else
            countError();
    });
}

void QtCanLink::doClose()
{
    if (auto device = std::exchange(m_device, nullptr)) {
        device->disconnect();
        device->disconnectDevice();
        device.release()->deleteLater(); // this may be one of its own signals
    }
    m_queue.clear();
    m_retry.stop();
}

Result<void> QtCanLink::doSend(const CanFrame &frame, Priority priority)
{
    MB_TRY_VOID(m_queue.admit(frame, priority, address().path));
    m_queue.push(frame, priority);
    pump();
    return {};
}

void QtCanLink::pump()
{
    countLost(m_queue.dropStale()); // first: it may be long ago that this thread had its turn
    while (m_device && !m_queue.isEmpty() && m_device->state() == QCanBusDevice::ConnectedState
        && m_device->framesToWrite() < framesInPlugin) {
        const CanQueue::Next next = m_queue.take(); // first: writing may call back
        if (m_device->writeFrame(rawOf(next.frame))) {
            m_queue.wentOut(next);
            continue;
        }
        if (m_device && !m_queue.putBack(next))
            countLost(1);
        break;
    }
    if (m_device && !m_queue.isEmpty())
        m_retry.startIn(retryDelay, [this] { pump(); });
}

void QtCanLink::receive()
{
    const Instant now = clock().now();
    while (m_device && m_device->framesAvailable() > 0 && state() == LinkState::Open) {
        const QCanBusFrame raw = m_device->readFrame();
        const auto stamp = std::chrono::seconds(raw.timeStamp().seconds())
            + std::chrono::microseconds(raw.timeStamp().microSeconds());
        if (raw.frameType() == QCanBusFrame::InvalidFrame || raw.payload().size() > 8) {
            countError();
            continue;
        }
        m_isFine = m_isFine || stamp % 1ms != 0us;
        const Instant time = m_isFine ? m_stamps.align(stamp, now) : now;
        m_latest = std::max(m_latest, time);
        const CanFrame frame = frameOf(raw, m_latest);
        deliver(frame);
        if (frame.error && raw.error().testFlag(QCanBusFrame::BusOffError))
            lose({Fault::LinkLost, say("bus-off: the adapter left the bus after too many errors"),
                say("check wiring, termination and bit rate"), {}, Ailment::BusOff});
    }
    endBatch();
}

void QtCanLink::end(const QString &reason)
{
    lose({Fault::LinkLost,
        reason.isEmpty() ? say("%1 was disconnected", address().path) : Message::verbatim(reason.toStdString()), {}, {},
        Ailment::Gone});
}

} // namespace

std::vector<QtCanAdapter> qtCanAdapters()
{
    std::vector<QtCanAdapter> adapters;
    for (const QString &plugin : plugins().plugins()) {
        const std::string name = plugin.toStdString();
        QString cause;
        const auto devices = plugins().availableDevices(plugin, &cause);
        for (const QCanBusDeviceInfo &device : devices) {
            QtCanAdapter adapter{name + ':' + device.name().toStdString(),
                Message::verbatim(device.description().toStdString()), {}, {}};
            if (plugin == QLatin1String("socketcan"))
                adapter.description
                    = say("the same interface as socketcan:%1, which also counts losses", device.name().toStdString());
            adapters.push_back(std::move(adapter));
        }
        if (!devices.isEmpty())
            continue;
        // A vendor's library that is missing is told in many words; the first of them name it.
        QString first = cause.section(QLatin1Char('('), 0, 0).trimmed();
        first.chop(first.endsWith(QLatin1Char(':')) ? 1 : 0);
        const std::string why = first.toStdString();
        adapters.push_back({name, {},
            why.empty() ? say("the plugin %1 finds no adapter", name)
                        : say("the plugin %1 finds no adapter (%2)", name, why),
            why.empty() ? say("plug one in") : say("install its vendor's driver")});
    }
    return adapters;
}

Result<std::unique_ptr<Link>> makeQtCanLink(const LinkAddress &address, Clock &clock)
{
    const auto colon = address.path.find(':');
    if (colon == std::string::npos || colon == 0 || colon + 1 == address.path.size())
        return fail(Fault::OutOfRange, say("'%1' is not qtcan:PLUGIN:INTERFACE", address.text()));
    int bitrate = 0;
    for (const auto &[key, value] : address.options) {
        if (key != "bitrate" || !takeNumber(value, bitrate) || bitrate <= 0)
            return fail(
                Fault::OutOfRange, say("qtcan links have the option bitrate=BITS_PER_SECOND, not '%1=%2'", key, value));
    }
    return std::make_unique<QtCanLink>(address, clock, bitrate);
}

} // namespace mb
