// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/guardian/message.h"

#include <cstring>

namespace mb::guardian {
namespace {

// Both ends are programs of one build on one machine: numbers in its own order.
template <class T> void put(Bytes &packet, T value)
{
    const std::size_t at = packet.size();
    packet.resize(at + sizeof value);
    std::memcpy(packet.data() + at, &value, sizeof value);
}

void putBytes(Bytes &packet, std::span<const std::uint8_t> bytes)
{
    put(packet, static_cast<std::uint16_t>(bytes.size()));
    packet.insert(packet.end(), bytes.begin(), bytes.end());
}

/// Takes a packet apart; one that ends too early is broken from then on.
class Reader {
public:
    explicit Reader(std::span<const std::uint8_t> packet)
        : m_rest(packet)
    {
    }
    template <class T> T number()
    {
        T value{};
        if (m_rest.size() < sizeof value)
            m_broken = true;
        if (m_broken)
            return value;
        std::memcpy(&value, m_rest.data(), sizeof value);
        m_rest = m_rest.subspan(sizeof value);
        return value;
    }
    Bytes bytes()
    {
        const auto size = number<std::uint16_t>();
        if (m_rest.size() < size)
            m_broken = true;
        if (m_broken)
            return {};
        Bytes taken(m_rest.begin(), m_rest.begin() + size);
        m_rest = m_rest.subspan(size);
        return taken;
    }
    [[nodiscard]] bool isBroken() const { return m_broken; }
    [[nodiscard]] bool isComplete() const { return !m_broken && m_rest.empty(); }

private:
    std::span<const std::uint8_t> m_rest;
    bool m_broken = false;
};

bool isLegal(const Step &step)
{
    using std::chrono::milliseconds;
    return (!step.bytes.empty() || step.reply.empty()) && step.mask.size() == step.reply.size()
        && step.wait >= milliseconds(1) && step.wait <= milliseconds(500) && step.attempts >= 1 && step.attempts <= 100;
}

Step takeStep(Reader &reader)
{
    Step step;
    step.bytes = reader.bytes();
    step.reply = reader.bytes();
    step.mask = reader.bytes();
    step.wait = std::chrono::milliseconds(reader.number<std::uint16_t>());
    step.attempts = reader.number<std::uint16_t>();
    return step;
}

} // namespace

Bytes encode(const Order &order)
{
    Bytes packet;
    put(packet, static_cast<std::uint8_t>(order.kind));
    put(packet, order.id);
    if (order.kind != Order::Kind::Watch)
        return packet;
    putBytes(packet, Bytes(order.name.begin(), order.name.end()));
    for (const Step &step : order.script) {
        putBytes(packet, step.bytes);
        putBytes(packet, step.reply);
        putBytes(packet, step.mask);
        put(packet, static_cast<std::uint16_t>(step.wait.count()));
        put(packet, static_cast<std::uint16_t>(step.attempts));
    }
    return packet;
}

Bytes encode(const Report &report)
{
    Bytes packet;
    put(packet, static_cast<std::uint8_t>(report.kind));
    put(packet, report.id);
    put(packet, static_cast<std::uint8_t>((report.confirmed ? 1U : 0U) | (report.proved ? 2U : 0U)));
    return packet;
}

std::optional<Order> decodeOrder(std::span<const std::uint8_t> packet)
{
    Reader reader(packet);
    Order order;
    const auto kind = reader.number<std::uint8_t>();
    order.id = reader.number<std::uint32_t>();
    if (reader.isBroken() || kind > static_cast<std::uint8_t>(Order::Kind::Stop))
        return std::nullopt;
    order.kind = static_cast<Order::Kind>(kind);
    if (order.kind != Order::Kind::Watch)
        return reader.isComplete() ? std::optional(order) : std::nullopt;
    const Bytes name = reader.bytes();
    order.name.assign(name.begin(), name.end());
    while (!reader.isBroken() && !reader.isComplete()) {
        order.script.push_back(takeStep(reader));
        if (!isLegal(order.script.back()))
            return std::nullopt;
    }
    return reader.isComplete() && !order.script.empty() ? std::optional(order) : std::nullopt;
}

std::optional<Report> decodeReport(std::span<const std::uint8_t> packet)
{
    Reader reader(packet);
    Report report;
    const auto kind = reader.number<std::uint8_t>();
    report.id = reader.number<std::uint32_t>();
    const auto verdict = reader.number<std::uint8_t>();
    if (!reader.isComplete() || kind > static_cast<std::uint8_t>(Report::Kind::Refused) || verdict > 3)
        return std::nullopt;
    report.kind = static_cast<Report::Kind>(kind);
    report.confirmed = (verdict & 1U) != 0;
    report.proved = (verdict & 2U) != 0;
    return report;
}

} // namespace mb::guardian
