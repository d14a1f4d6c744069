// SPDX-License-Identifier: GPL-3.0-or-later
// Who keeps the computer awake, and when: on a bus of the tests' own, with a logind that they play.
#include "app/sleep/logindinhibitor.h"
#include "app/sleep/sleepguard.h"
#include "model/registry.h"
#include "model/session.h"
#include "support/eventloop.h"
#include "support/fakeguard.h"
#include "transport/backends/unixspiserver.h"

#include <gtest/gtest.h>

#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusUnixFileDescriptor>
#include <QDBusVirtualObject>
#include <QFile>
#include <QProcess>
#include <QProcessEnvironment>
#include <QTemporaryDir>

#include <poll.h>
#include <unistd.h>

namespace mb {
namespace {

/// A logind that hands out locks, and knows which of them are still held.
class Logind final : public QDBusVirtualObject {
public:
    bool handleMessage(const QDBusMessage &message, const QDBusConnection &connection) override
    {
        if (message.member() != QStringLiteral("Inhibit"))
            return false;
        asked.push_back(message.arguments());
        if (refused.contains(message.arguments().value(0).toString()))
            return connection.send(message.createErrorReply(QDBusError::AccessDenied, QStringLiteral("not allowed")));
        int ends[2] = {-1, -1};
        if (::pipe(ends) != 0)
            return false;
        m_locks.push_back(ends[0]);
        const QDBusUnixFileDescriptor lock(ends[1]);
        ::close(ends[1]);
        return connection.send(message.createReply(QVariant::fromValue(lock)));
    }
    [[nodiscard]] QString introspect(const QString &) const override { return {}; }
    ~Logind() override
    {
        for (const int lock : m_locks)
            ::close(lock);
    }
    /// Locks whose holder has not closed them.
    [[nodiscard]] int held() const
    {
        return static_cast<int>(std::count_if(m_locks.begin(), m_locks.end(), [](int lock) {
            pollfd ended{lock, 0, 0};
            return ::poll(&ended, 1, 0) == 0;
        }));
    }

    QStringList refused;
    std::vector<QVariantList> asked;

private:
    std::vector<int> m_locks;
};

/// A bus of its own, which ends with it.
class PrivateBus {
public:
    PrivateBus()
    {
        m_daemon.start(QStringLiteral("dbus-daemon"),
            {QStringLiteral("--session"), QStringLiteral("--nofork"), QStringLiteral("--print-address=1")});
        EXPECT_TRUE(m_daemon.waitForStarted()) << "install dbus";
        EXPECT_TRUE(m_daemon.waitForReadyRead());
        address = QString::fromLatin1(m_daemon.readLine().trimmed());
        connection
            = std::make_unique<QDBusConnection>(QDBusConnection::connectToBus(address, QStringLiteral("logind")));
        EXPECT_TRUE(connection->isConnected());
    }
    ~PrivateBus()
    {
        connection.reset();
        QDBusConnection::disconnectFromBus(QStringLiteral("logind"));
        m_daemon.terminate();
        m_daemon.waitForFinished();
    }
    void offer(Logind &logind)
    {
        EXPECT_TRUE(connection->registerVirtualObject(QStringLiteral("/org/freedesktop/login1"), &logind));
        EXPECT_TRUE(connection->registerService(QStringLiteral("org.freedesktop.login1")));
    }

    QString address;
    std::unique_ptr<QDBusConnection> connection;

private:
    QProcess m_daemon;
};

QByteArray intelHexLine(int address)
{
    QByteArray record;
    record.append(char(16)).append(char(address >> 8)).append(char(address & 0xFF)).append(char(0));
    record.append(QByteArray(16, '\xFF'));
    int sum = 0;
    for (const char byte : record)
        sum += static_cast<unsigned char>(byte);
    record.append(char(-sum & 0xFF));
    return ':' + record.toHex().toUpper() + '\n';
}

TEST(Sleep, IsInhibitedByALockOfLogindAsLongAsItIsWanted)
{
    test::EventLoop loop;
    PrivateBus bus;
    Logind logind;
    bus.offer(logind);
    LogindInhibitor inhibitor(bus.address.toStdString());
    EXPECT_EQ(logind.held(), 0);
    inhibitor.keepAwake(true);
    ASSERT_TRUE(loop.runUntil([&] { return logind.held() == 1; }));
    ASSERT_EQ(logind.asked.size(), 1U);
    EXPECT_EQ(logind.asked[0].value(0).toString(), QStringLiteral("sleep:handle-lid-switch"));
    EXPECT_EQ(logind.asked[0].value(1).toString(), QStringLiteral("MotorBench"));
    EXPECT_EQ(logind.asked[0].value(3).toString(), QStringLiteral("block"));
    inhibitor.keepAwake(false);
    EXPECT_TRUE(loop.runUntil([&] { return logind.held() == 0; }));
    inhibitor.keepAwake(true);
    EXPECT_TRUE(loop.runUntil([&] { return logind.held() == 1; }));
}

TEST(Sleep, TheLockEndsWithWhoHoldsIt)
{
    test::EventLoop loop;
    PrivateBus bus;
    Logind logind;
    bus.offer(logind);
    {
        LogindInhibitor inhibitor(bus.address.toStdString());
        inhibitor.keepAwake(true);
        ASSERT_TRUE(loop.runUntil([&] { return logind.held() == 1; }));
    }
    EXPECT_TRUE(loop.runUntil([&] { return logind.held() == 0; }));
}

TEST(Sleep, WhoMayNotForbidTheLidStillForbidsTheRest)
{
    test::EventLoop loop;
    PrivateBus bus;
    Logind logind;
    logind.refused = QStringList{QStringLiteral("sleep:handle-lid-switch")};
    bus.offer(logind);
    LogindInhibitor inhibitor(bus.address.toStdString());
    std::string trouble;
    const Subscription told = inhibitor.troubled().add([&](const Message &text) { trouble = text.english(); });
    inhibitor.keepAwake(true);
    ASSERT_TRUE(loop.runUntil([&] { return logind.held() == 1; }));
    EXPECT_EQ(logind.asked.back().value(0).toString(), QStringLiteral("sleep"));
    loop.runReady();
    EXPECT_EQ(trouble, "");
}

TEST(Sleep, WithoutLogindOneWordIsSaidAndNoMore)
{
    test::EventLoop loop;
    PrivateBus bus;
    LogindInhibitor inhibitor(bus.address.toStdString());
    std::vector<std::string> troubles;
    const Subscription told
        = inhibitor.troubled().add([&](const Message &text) { troubles.push_back(text.english()); });
    inhibitor.keepAwake(true);
    ASSERT_TRUE(loop.runUntil([&] { return !troubles.empty(); }));
    EXPECT_NE(troubles[0].find("not kept awake"), std::string::npos) << troubles[0];
    inhibitor.keepAwake(false);
    Logind logind;
    bus.offer(logind);
    inhibitor.keepAwake(true);
    EXPECT_TRUE(loop.runUntil([&] { return logind.held() == 1; })) << "it came later, and serves";
    EXPECT_EQ(troubles.size(), 1U);
}

TEST(Sleep, WithoutABusAWordIsSaid)
{
    test::EventLoop loop;
    LogindInhibitor inhibitor("unix:path=/nonexistent/bus");
    std::string trouble;
    const Subscription told = inhibitor.troubled().add([&](const Message &text) { trouble = text.english(); });
    inhibitor.keepAwake(true);
    EXPECT_TRUE(loop.runUntil([&] { return !trouble.empty(); }));
}

struct FakeInhibitor final : SleepInhibitor {
    void keepAwake(bool awake) override { isAwake = awake; }
    bool isAwake = false;
};

/// A session with a simulated board behind a socket, which counts as a real one.
class Guarded : public testing::Test {
protected:
    Guarded()
        : server(*LinkAddress::parse("unix:" + folder.filePath(QStringLiteral("spi")).toStdString()), loop.clock())
        , session(loop.clock(), families(), &guardian)
        , sleepGuard(session, loop.clock(), inhibitor)
    {
        const Family &family = *findFamily(families(), "quadquad2drv");
        board = std::move(*family.simulate(server, loop.clock(), *SimulatedUnit::parse("quadquad2drv:0")));
        EXPECT_TRUE(server.open());
        auto connecting = session.connect(*DeviceSelector::parse(server.address().text() + "/quadquad2drv:0"));
        connecting.start();
        EXPECT_TRUE(loop.runUntil([&] { return connecting.isFinished(); }));
        EXPECT_TRUE(connecting.result()) << connecting.result().error().detail;
        device = connecting.result().value_or(nullptr);
        EXPECT_TRUE(loop.runUntil([&] { return device->liveness().heard; }));
    }
    [[nodiscard]] bool becomesAwake(bool awake)
    {
        return loop.runUntil([this, awake] { return inhibitor.isAwake == awake; });
    }

    test::EventLoop loop;
    QTemporaryDir folder;
    UnixSpiServer server;
    std::unique_ptr<Simulator> board;
    test::FakeGuard guardian;
    Session session;
    FakeInhibitor inhibitor;
    SleepGuard sleepGuard;
    Device *device = nullptr;
};

TEST_F(Guarded, TheComputerIsKeptAwakeFromTheFirstSetPointUntilTheMotorIsStopped)
{
    EXPECT_FALSE(inhibitor.isAwake);
    SetPoint setPoint;
    setPoint.mode = Mode::Duty;
    setPoint.target = 0.1;
    SetPointStream &stream = session.stream(*device);
    ASSERT_TRUE(stream.start(setPoint, std::chrono::seconds(30)));
    EXPECT_TRUE(becomesAwake(true));
    stream.stop();
    EXPECT_TRUE(becomesAwake(false));
}

TEST_F(Guarded, TheComputerIsKeptAwakeWhileFirmwareIsWritten)
{
    device->gate().setBusy(say("firmware update"));
    EXPECT_TRUE(becomesAwake(true));
    device->gate().setBusy({});
    EXPECT_TRUE(becomesAwake(false));
}

/// Of a console whose computer is asked to stay awake, and that keeps what it keeps in this folder.
QProcessEnvironment environmentWith(const PrivateBus &bus, const QTemporaryDir &home)
{
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("DBUS_SYSTEM_BUS_ADDRESS"), bus.address);
    for (const char *const folder : {"XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME"})
        environment.insert(QLatin1String(folder), home.path());
    return environment;
}

/// The real console program, with a board and its bootloader in another process.
TEST(Sleep, AnUpdateByTheConsoleMarksItsDeviceBusySoThatTheComputerStaysAwake)
{
    test::EventLoop loop;
    PrivateBus bus;
    Logind logind;
    bus.offer(logind);
    const QTemporaryDir folder;
    const QString program = QCoreApplication::applicationDirPath() + QStringLiteral("/motorbenchctl");
    const QString socket = QStringLiteral("unix:") + folder.filePath(QStringLiteral("board"));
    const QString boot = folder.filePath(QStringLiteral("boot"));
    QFile image(folder.filePath(QStringLiteral("new.hex")));
    ASSERT_TRUE(image.open(QIODevice::WriteOnly));
    for (int line = 0; line < 10; ++line) // 16 bytes FF each; the bootloader takes 50 ms a line
        image.write(intelHexLine(16 * line));
    image.write(":00000001FF\n");
    image.close();
    QProcess board;
    board.start(program,
        {QStringLiteral("simulate"), QStringLiteral("--on"), socket,
            QStringLiteral("quadquad2drv:0,jumper=closed,boot=pty:") + boot});
    ASSERT_TRUE(board.waitForReadyRead(20'000));
    QProcess update;
    update.setProcessEnvironment(environmentWith(bus, folder));
    update.start(program,
        {QStringLiteral("flash"), socket + QStringLiteral("/quadquad2drv:0"), image.fileName(), QStringLiteral("--via"),
            QStringLiteral("serial:") + boot});
    EXPECT_TRUE(loop.runUntil([&] { return logind.held() == 1 || update.state() == QProcess::NotRunning; }));
    EXPECT_EQ(logind.held(), 1);
    EXPECT_TRUE(loop.runUntil([&] { return update.state() == QProcess::NotRunning; }, std::chrono::minutes(1)));
    EXPECT_EQ(update.exitCode(), 0) << update.readAllStandardError().toStdString();
    EXPECT_EQ(logind.held(), 0);
    board.terminate();
    board.waitForFinished();
}

TEST(Sleep, AServiceByTheConsoleKeepsTheComputerAwakeBetweenItsSteps)
{
    test::EventLoop loop;
    PrivateBus bus;
    Logind logind;
    bus.offer(logind);
    const QTemporaryDir folder;
    const auto write = [&folder](const QString &name, const QByteArray &text) {
        QFile file(folder.filePath(name));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
    };
    write(QStringLiteral("recipe.json"),
        R"({"recipe":1,"name":"n","family":"supermodified","parameters":{"file":"base.json"}})");
    write(QStringLiteral("base.json"), R"({"family":"supermodified","parameters":{"gain.p":{"raw":77}}})");
    const QString program = QCoreApplication::applicationDirPath() + QStringLiteral("/motorbenchctl");
    const QString line = folder.filePath(QStringLiteral("tty"));
    QProcess node;
    node.start(program,
        {QStringLiteral("simulate"), QStringLiteral("--on"), QStringLiteral("pty:") + line,
            QStringLiteral("supermodified:4")});
    ASSERT_TRUE(node.waitForReadyRead(20'000));
    QProcess service;
    service.setProcessEnvironment(environmentWith(bus, folder));
    service.start(program,
        {QStringLiteral("service"), folder.filePath(QStringLiteral("recipe.json")),
            QStringLiteral("serial:%1?baud=57600").arg(line)});
    EXPECT_TRUE(loop.runUntil([&] { return logind.held() == 1 || service.state() == QProcess::NotRunning; }));
    EXPECT_EQ(logind.held(), 1) << "neither firmware is written nor does a motor turn";
    EXPECT_TRUE(loop.runUntil([&] { return service.state() == QProcess::NotRunning; }, std::chrono::minutes(1)));
    EXPECT_EQ(service.exitCode(), 0) << service.readAllStandardError().toStdString();
    EXPECT_EQ(logind.held(), 0);
    node.terminate();
    node.waitForFinished();
}

} // namespace
} // namespace mb
