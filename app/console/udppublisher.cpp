// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/udppublisher.h"

#include "app/console/target.h"

#include <QJsonDocument>
#include <QJsonObject>

#include <netdb.h>
#include <sys/socket.h>

namespace mb::console {

Result<std::unique_ptr<Publisher>> UdpPublisher::open(const PublishAddress &address)
{
    addrinfo wanted{};
    wanted.ai_socktype = SOCK_DGRAM;
    addrinfo *found = nullptr;
    const int status = ::getaddrinfo(address.host.c_str(), std::to_string(address.port).c_str(), &wanted, &found);
    if (status != 0)
        return fail(Fault::LinkLost, say("udp://%1: %2", address.host, ::gai_strerror(status)),
            say("check the name of the host"));
    const std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)> rows(found, &::freeaddrinfo);
    for (const addrinfo *row = found; row; row = row->ai_next) {
        Descriptor socket(::socket(row->ai_family, row->ai_socktype | SOCK_CLOEXEC | SOCK_NONBLOCK, row->ai_protocol));
        if (socket.get() >= 0 && ::connect(socket.get(), row->ai_addr, row->ai_addrlen) == 0)
            return std::make_unique<UdpPublisher>(socket.give());
    }
    return fail(Fault::LinkLost, say("udp://%1 cannot be reached", address.host), say("check the network"));
}

UdpPublisher::UdpPublisher(int socket)
    : m_socket(socket)
{
}

bool UdpPublisher::send(
    const std::string &device, std::string_view channel, double seconds, double value, std::string_view)
{
    const QJsonObject values{{qt(channel), value}};
    const QByteArray text = QJsonDocument(QJsonObject{{QStringLiteral("timestamp"), seconds}, {qt(device), values}})
                                .toJson(QJsonDocument::Compact);
    return ::send(m_socket.get(), text.constData(), static_cast<std::size_t>(text.size()), MSG_DONTWAIT | MSG_NOSIGNAL)
        == text.size();
}

} // namespace mb::console
