// SPDX-License-Identifier: GPL-3.0-or-later
// A QtSerialBus plugin of our own plays the adapters that we have not: what comes of error frames, of stamps, and of a full adapter.
#include "async/virtualclock.h"
#include "support/eventloop.h"
#include "transport/backends/qtcanbus.h"
#include "transport/canlink.h"
#include "transport/linkcatalog.h"

#include <gtest/gtest.h>

#include <QByteArray>
#include <QCanBusDevice>
#include <QCanBusDeviceInfo>
#include <QCanBusFactoryV2>
#include <QCanBusFrame>
#include <QCborMap>
#include <QPointer>
#include <QString>
#include <QtGlobal>
#include <QtPlugin>

#include <chrono>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

namespace mb {
namespace {

using namespace std::chrono_literals;

constexpr int ownBitrate = 500'000;

class PlayedAdapter final : public QCanBusDevice {
public:
    PlayedAdapter() { QCanBusDevice::setConfigurationParameter(BitRateKey, ownBitrate); }
    bool writeFrame(const QCanBusFrame &frame) override
    {
        if (isFull)
            return false;
        enqueueOutgoingFrame(frame);
        return true;
    }
    void setConfigurationParameter(int key, const QVariant &value) override
    {
        ++settings;
        QCanBusDevice::setConfigurationParameter(key, value);
    }
    QString interpretErrorFrame(const QCanBusFrame &) override { return {}; }
    /// What the adapter still has goes out on the bus.
    std::vector<quint32> drain()
    {
        std::vector<quint32> identifiers;
        while (hasOutgoingFrames())
            identifiers.push_back(dequeueOutgoingFrame().frameId());
        Q_EMIT framesWritten(static_cast<qint64>(identifiers.size()));
        return identifiers;
    }
    void receive(const QCanBusFrame &frame) { enqueueReceivedFrames({frame}); }
    void fail(const QString &text, CanBusError error) { setError(text, error); }
    void unplug() { setState(UnconnectedState); }

    bool isFull = false;
    bool isWithoutPower = false;
    int settings = 0;

private:
    bool open() override
    {
        if (isWithoutPower)
            setError(QStringLiteral("it has no power"), ConnectionError);
        else
            setState(ConnectedState);
        return !isWithoutPower;
    }
    void close() override { setState(UnconnectedState); }
};

QPointer<PlayedAdapter> played; ///< the last that was made

/// As moc would write it.
class PlayedPlugin final : public QObject, public QCanBusFactoryV2 {
public:
    void *qt_metacast(const char *name) override
    {
        if (std::strcmp(name, qobject_interface_iid<QCanBusFactory *>()) == 0)
            return static_cast<QCanBusFactory *>(this);
        if (std::strcmp(name, qobject_interface_iid<QCanBusFactoryV2 *>()) == 0)
            return static_cast<QCanBusFactoryV2 *>(this);
        return QObject::qt_metacast(name);
    }
    QCanBusDevice *createDevice(const QString &interface, QString *cause) const override
    {
        if (interface != QLatin1String("one") && interface != QLatin1String("dark")) {
            *cause = QStringLiteral("no such adapter");
            return nullptr;
        }
        played = new PlayedAdapter;
        played->isWithoutPower = interface == QLatin1String("dark");
        return played;
    }
    QList<QCanBusDeviceInfo> availableDevices(QString *cause) const override
    {
        *cause = finding;
        return {};
    }
    inline static QString finding; ///< what it says where it has none
};

QObject *playedPlugin()
{
    static PlayedPlugin plugin;
    return &plugin;
}

const char *metadataOfPlayed()
{
    static const QByteArray text = QByteArray("QTMETADATA !\0\5\17\0", 16)
        + QCborMap{{2, QLatin1String(qobject_interface_iid<QCanBusFactory *>())}, {3, QLatin1String("PlayedPlugin")},
            {4, QCborMap{{QLatin1String("Key"), QLatin1String("played")}}}}
              .toCborValue()
              .toCbor();
    return text.constData();
}

[[maybe_unused]] const bool isPlayedKnown = (qRegisterStaticPluginFunction({playedPlugin, metadataOfPlayed}), true);

QCanBusFrame errorFrame(QCanBusFrame::FrameErrors errors, const QByteArray &details = QByteArray(8, '\0'))
{
    QCanBusFrame frame(QCanBusFrame::ErrorFrame);
    frame.setError(errors);
    frame.setPayload(details);
    return frame;
}

struct QtCanAdapterPlayed : testing::Test {
    QtCanAdapterPlayed()
        : link(made("one"))
        , hearing(link->received().add([this](const CanFrame &frame) { heard.push_back(frame); }))
    {
        EXPECT_TRUE(link->open());
    }
    std::unique_ptr<CanLink> made(const std::string &interface)
    {
        auto made = makeQtCanLink(LinkAddress::parse("qtcan:played:" + interface).value(), clock);
        return std::unique_ptr<CanLink>(static_cast<CanLink *>(made.value().release()));
    }
    void send(std::uint32_t identifier, Priority priority = Priority::Normal)
    {
        EXPECT_TRUE(link->send(standardFrame(identifier, {}), priority));
    }
    void receive(std::chrono::microseconds stamp)
    {
        QCanBusFrame frame(0x123, QByteArray("\1\2"));
        frame.setTimeStamp(QCanBusFrame::TimeStamp::fromMicroSeconds(stamp.count()));
        played->receive(frame);
    }

    test::EventLoop loop;
    VirtualClock clock;
    std::unique_ptr<CanLink> link;
    std::vector<CanFrame> heard;
    Subscription hearing;
};

using Identifiers = std::vector<quint32>;

TEST_F(QtCanAdapterPlayed, APluginThatFindsNoAdapterHasARowWithTheCauseAndTheRemedy)
{
    const auto row = [](const QString &finding) {
        PlayedPlugin::finding = finding;
        for (const LinkListing &each : listPluginLinks()) {
            if (each.link.text() == "qtcan:played")
                return each;
        }
        return LinkListing{};
    };
    const LinkListing silent = row({});
    EXPECT_EQ(silent.state, ListingState::Absent);
    EXPECT_FALSE(silent.openable);
    EXPECT_EQ(silent.kind, LinkKind::Can);
    EXPECT_EQ(silent.diagnosis,
        (Diagnosis{Ailment::NotThere, say("the plugin %1 finds no adapter", "played"), say("plug one in"), {}}));
    EXPECT_EQ(silent.detail.english(), "the plugin played finds no adapter; plug one in");
    const std::string missing
        = "the plugin played finds no adapter (Cannot load library pcan); install its vendor's driver";
    EXPECT_EQ(row(QStringLiteral("Cannot load library pcan: (no such file: pcan)")).detail.english(), missing);
    EXPECT_EQ(row(QStringLiteral("Cannot load library pcan")).detail.english(), missing);
}

TEST_F(QtCanAdapterPlayed, HasTheBitrateOfItsAddressAndWithoutOneKeepsItsOwn)
{
    EXPECT_EQ(link->bitrate(), ownBitrate);
    EXPECT_EQ(played->settings, 0);
    const auto other = made("one?bitrate=250000");
    ASSERT_TRUE(other->open());
    EXPECT_EQ(other->bitrate(), 250'000);
    EXPECT_EQ(played->configurationParameter(QCanBusDevice::BitRateKey).toInt(), 250'000);
}

TEST_F(QtCanAdapterPlayed, OneThatCannotBeMadeIsNamedWithTheCause)
{
    const auto opened = made("two")->open();
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().text(), "played:two cannot be opened: no such adapter");
    const auto dark = made("dark");
    const auto refused = dark->open();
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().text(), "played:dark cannot be opened: it has no power");
    EXPECT_TRUE(played.isNull()) << "nothing is kept of it";
}

TEST_F(QtCanAdapterPlayed, StampsCountWhereTheyAreFinerThanMilliseconds)
{
    clock.advance(10s);
    const Instant first = clock.now();
    receive(1'000'000us);
    clock.advance(300us);
    receive(1'000'000us);
    clock.advance(300us);
    receive(1'000'600us); // from here on
    clock.advance(700us);
    receive(1'000'900us);
    ASSERT_EQ(heard.size(), 4U);
    EXPECT_EQ(heard[0].time, first);
    EXPECT_EQ(heard[1].time, first + 300us) << "when it came";
    EXPECT_EQ(heard[2].time, first + 600us);
    EXPECT_EQ((heard[3].time - first) / 1us, 900) << "when it was on the bus";
    EXPECT_EQ(toText(heard[0]), "123#0102");
}

TEST_F(QtCanAdapterPlayed, ErrorFramesBecomeTheHealthOfTheBusAndBusOffLosesTheLink)
{
    played->receive(errorFrame(QCanBusFrame::ControllerError, QByteArray("\0\x20\0\0\0\0\0\0", 8)));
    EXPECT_EQ(link->health().state, BusState::Passive);
    played->receive(errorFrame(QCanBusFrame::MissingAcknowledgmentError));
    EXPECT_EQ(link->health().acknowledgeErrors, 1U);
    EXPECT_EQ(link->counters().errors, 2U);
    EXPECT_EQ(link->state(), LinkState::Open);
    played->receive(errorFrame(QCanBusFrame::BusOffError | QCanBusFrame::ControllerError));
    EXPECT_EQ(link->state(), LinkState::Lost);
    EXPECT_EQ(link->loss().ailment, Ailment::BusOff);
    EXPECT_TRUE(heard.empty());
}

TEST_F(QtCanAdapterPlayed, WhatIsNoFrameCountsAsAnErrorAndTheNextOneIsHeard)
{
    played->receive(QCanBusFrame(QCanBusFrame::InvalidFrame));
    played->receive(QCanBusFrame(0x123, QByteArray(12, '\1'))); // of CAN FD
    EXPECT_EQ(link->counters().errors, 2U);
    EXPECT_TRUE(heard.empty());
    receive(0us);
    EXPECT_EQ(heard.size(), 1U);
}

TEST_F(QtCanAdapterPlayed, HasFewFramesAtATimeSoThatAStopDoesNotWaitBehindMany)
{
    for (std::uint32_t identifier = 1; identifier <= 7; ++identifier)
        send(identifier);
    EXPECT_EQ(link->backlog(), 3U);
    send(99, Priority::Urgent);
    EXPECT_EQ(played->drain(), (Identifiers{1, 2, 3, 4}));
    EXPECT_EQ(played->drain(), (Identifiers{99, 5, 6, 7}));
    EXPECT_EQ(link->backlog(), 0U);
}

TEST_F(QtCanAdapterPlayed, WhatItRefusesIsTriedAgainForHalfASecondAndAStopForLonger)
{
    played->isFull = true;
    send(1);
    EXPECT_EQ(link->backlog(), 1U);
    played->isFull = false;
    clock.advance(5ms);
    EXPECT_EQ(played->drain(), Identifiers{1});
    played->isFull = true;
    send(2);
    send(3, Priority::Urgent);
    clock.advance(600ms);
    EXPECT_EQ(link->counters().lost, 1U);
    played->isFull = false;
    clock.advance(5ms);
    EXPECT_EQ(played->drain(), Identifiers{3});
}

TEST_F(QtCanAdapterPlayed, IsLostWithItsConnectionAndByNoOtherError)
{
    played->fail(QStringLiteral("one frame did not go out"), QCanBusDevice::WriteError);
    EXPECT_EQ(link->state(), LinkState::Open);
    EXPECT_EQ(link->counters().errors, 1U);
    played->fail(QStringLiteral("the cable is out"), QCanBusDevice::ConnectionError);
    EXPECT_EQ(link->state(), LinkState::Lost);
    EXPECT_EQ(link->loss().text(), "the cable is out");
    ASSERT_TRUE(link->open());
    played->unplug();
    EXPECT_EQ(link->loss().text(), "played:one was disconnected");
    EXPECT_EQ(link->loss().ailment, Ailment::Gone);
    static int said = 0;
    qInstallMessageHandler([](QtMsgType, const QMessageLogContext &, const QString &) { ++said; });
    link->close();
    qInstallMessageHandler(nullptr);
    EXPECT_EQ(said, 0) << "on a user's terminal";
}

} // namespace
} // namespace mb
