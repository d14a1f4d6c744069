// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/publisher.h"
#include "async/descriptor.h"

namespace mb::console {

/// One datagram a sample, as PlotJuggler's UDP server reads JSON: `{"timestamp":12.5,"dmc60c:5":{"velocity":799}}`.
class UdpPublisher final : public Publisher {
public:
    [[nodiscard]] static Result<std::unique_ptr<Publisher>> open(const PublishAddress &address);

    /// Takes the descriptor of a connected socket.
    explicit UdpPublisher(int socket);

protected:
    bool send(const std::string &device, std::string_view channel, double seconds, double value,
        std::string_view unit) override;

private:
    Descriptor m_socket;
};

} // namespace mb::console
