// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/mqttpublisher.h"

#include "app/console/target.h"

#include <QJsonDocument>
#include <QJsonObject>

#include <mosquitto.h>

#include <cerrno>
#include <chrono>
#include <cstring>

namespace mb::console {
namespace {

constexpr int keepAliveSeconds = 30; // s
constexpr std::chrono::seconds finishTime(2);

} // namespace

Result<std::unique_ptr<Publisher>> MqttPublisher::open(const PublishAddress &address, Duration limit)
{
    auto publisher = std::make_unique<MqttPublisher>(address.topic);
    MB_TRY_VOID(publisher->connect(address, limit));
    return publisher;
}

MqttPublisher::MqttPublisher(std::string topic)
    : m_topic(std::move(topic))
{
    mosquitto_lib_init();
    m_client = mosquitto_new(nullptr, true, this);
    mosquitto_connect_callback_set(m_client, [](mosquitto *, void *self, int answer) {
        auto *publisher = static_cast<MqttPublisher *>(self);
        publisher->answer(answer);
    });
    mosquitto_publish_callback_set(m_client, [](mosquitto *, void *self, int) {
        auto *publisher = static_cast<MqttPublisher *>(self);
        publisher->count(-1);
    });
}

MqttPublisher::~MqttPublisher()
{
    mosquitto_disconnect(m_client);
    mosquitto_loop_stop(m_client, true);
    mosquitto_destroy(m_client);
    mosquitto_lib_cleanup();
}

Result<void> MqttPublisher::connect(const PublishAddress &address, Duration limit)
{
    const int status = mosquitto_connect(m_client, address.host.c_str(), address.port, keepAliveSeconds);
    if (status != MOSQ_ERR_SUCCESS)
        return fail(Fault::LinkLost,
            say("%1: %2", address.name(),
                (status == MOSQ_ERR_ERRNO ? std::strerror(errno) : mosquitto_strerror(status))),
            say("start the broker, or name the host that it runs on"));
    mosquitto_loop_start(m_client);
    std::unique_lock lock(m_lock);
    if (!m_told.wait_for(lock, limit, [this] { return m_answer >= 0; }))
        return fail(silence(address));
    if (m_answer != 0)
        return fail(Fault::LinkLost, say("%1 refuses: %2", address.name(), mosquitto_connack_string(m_answer)),
            say("allow clients without a name and password there"));
    return {};
}

void MqttPublisher::answer(int code)
{
    const std::lock_guard lock(m_lock);
    m_answer = code;
    m_told.notify_all();
}

void MqttPublisher::count(int more)
{
    const std::lock_guard lock(m_lock);
    m_waiting += more;
    m_told.notify_all();
}

bool MqttPublisher::send(
    const std::string &device, std::string_view channel, double seconds, double value, std::string_view unit)
{
    const QByteArray text = QJsonDocument(
        QJsonObject{{QStringLiteral("t"), seconds}, {QStringLiteral("channel"), qt(channel)},
            {QStringLiteral("value"), value},
            {QStringLiteral("unit"),
                qt(unit)}}).toJson(QJsonDocument::Compact);
    const std::string topic = m_topic + '/' + device + '/' + std::string(channel);
    count(1);
    const bool sent = mosquitto_publish(m_client, nullptr, topic.c_str(), text.size(), text.constData(), 0, false)
        == MOSQ_ERR_SUCCESS;
    if (!sent)
        count(-1);
    return sent;
}

void MqttPublisher::finish()
{
    std::unique_lock lock(m_lock);
    m_told.wait_for(lock, finishTime, [this] { return m_waiting <= 0; });
    drop(static_cast<std::uint64_t>(std::max(m_waiting, 0))); // handed over, and never on the line
    m_waiting = 0;
}

} // namespace mb::console
