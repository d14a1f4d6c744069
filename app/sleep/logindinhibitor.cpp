// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sleep/logindinhibitor.h"

#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusReply>
#include <QDBusUnixFileDescriptor>
#include <QThread>

#include <atomic>

namespace mb {
namespace {

constexpr int patience = 5000; ///< ms for an answer of the bus

/// A lid is closed by hand, and not everybody may forbid that.
constexpr const char *wishes[] = {"sleep:handle-lid-switch", "sleep"};

QString nextConnectionName()
{
    static std::atomic<int> made = 0;
    return QStringLiteral("motorbench-sleep-%1").arg(++made);
}

QDBusMessage inhibition(const char *what)
{
    QDBusMessage call = QDBusMessage::createMethodCall(QStringLiteral("org.freedesktop.login1"),
        QStringLiteral("/org/freedesktop/login1"), QStringLiteral("org.freedesktop.login1.Manager"),
        QStringLiteral("Inhibit"));
    call << QString::fromLatin1(what) << QStringLiteral("MotorBench")
         << QStringLiteral("a motor is driven, or firmware is written") << QStringLiteral("block");
    return call;
}

} // namespace

/// What happens in the thread of its own. The lock is a descriptor: it holds as long as that is open.
class LogindInhibitor::Worker {
public:
    Worker(LogindInhibitor &owner, const std::string &bus)
        : m_owner(owner)
        , m_bus(QString::fromStdString(bus))
        , m_name(nextConnectionName())
    {
        m_inside.moveToThread(&m_thread);
        m_thread.setObjectName(QStringLiteral("sleep"));
        m_thread.start();
    }
    ~Worker()
    {
        m_thread.quit();
        m_thread.wait();
        QDBusConnection::disconnectFromBus(m_name);
    }
    void order(bool awake)
    {
        QMetaObject::invokeMethod(
            &m_inside, [this, awake] { awake ? hold() : let(); }, Qt::QueuedConnection);
    }

private:
    void hold()
    {
        if (!m_connected) {
            const QDBusConnection made = m_bus.isEmpty()
                ? QDBusConnection::connectToBus(QDBusConnection::SystemBus, m_name)
                : QDBusConnection::connectToBus(m_bus, m_name);
            m_connected = made.isConnected();
            if (!m_connected)
                return tell(made.lastError().message());
        }
        QString cause;
        for (const char *const what : wishes) {
            const QDBusReply<QDBusUnixFileDescriptor> reply
                = QDBusConnection(m_name).call(inhibition(what), QDBus::Block, patience);
            if (reply.isValid() && reply.value().isValid()) {
                m_lock = reply.value();
                return;
            }
            cause = reply.error().message();
        }
        tell(cause);
    }
    void let() { m_lock = QDBusUnixFileDescriptor(); }
    void tell(const QString &cause)
    {
        if (std::exchange(m_told, true))
            return;
        const Message text
            = say("this computer is not kept awake while motors are driven or firmware is written: %1; switch its "
                  "automatic suspend off meanwhile",
                cause.toStdString());
        QMetaObject::invokeMethod(
            &m_outside, [this, text] { m_owner.troubled().notify(text); }, Qt::QueuedConnection);
    }

    LogindInhibitor &m_owner;
    QString m_bus;
    QString m_name;
    bool m_connected = false;
    bool m_told = false;
    QDBusUnixFileDescriptor m_lock;
    QObject m_outside; ///< stands for the thread of the owner: what is left for it goes with this
    QObject m_inside;
    QThread m_thread;
};

LogindInhibitor::LogindInhibitor(std::string bus)
    : m_bus(std::move(bus))
{
}

LogindInhibitor::~LogindInhibitor() = default;

void LogindInhibitor::keepAwake(bool awake)
{
    if (!m_worker && awake)
        m_worker = std::make_unique<Worker>(*this, m_bus);
    if (m_worker)
        m_worker->order(awake);
}

} // namespace mb
