// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/publisher.h"
#include "async/noncopyable.h"

#include <condition_variable>
#include <mutex>

struct mosquitto;

namespace mb::console {

/// `TOPIC/DEVICE/CHANNEL` gets the line that `watch --json` prints, quality 0, not retained. The connection lives in a thread of
/// libmosquitto, which connects again by itself; what comes meanwhile is dropped and counted.
class MqttPublisher final : public Publisher, private NonCopyable {
public:
    /// Waits for the broker, `limit` at most once its host has taken the connection.
    [[nodiscard]] static Result<std::unique_ptr<Publisher>> open(const PublishAddress &address, Duration limit);

    explicit MqttPublisher(std::string topic);
    ~MqttPublisher() override;

    void finish() override;

protected:
    bool send(const std::string &device, std::string_view channel, double seconds, double value,
        std::string_view unit) override;

private:
    [[nodiscard]] Result<void> connect(const PublishAddress &address, Duration limit);
    void answer(int code);
    void count(int more);

    std::string m_topic;
    mosquitto *m_client = nullptr;
    std::mutex m_lock; ///< of what follows: libmosquitto's thread tells it
    std::condition_variable m_told;
    int m_answer = -1; ///< of the broker; -1: none yet; 0: taken
    int m_waiting = 0; ///< messages that were handed over and not sent yet
};

} // namespace mb::console
