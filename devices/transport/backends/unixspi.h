// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "transport/spilink.h"

#include <deque>
#include <memory>
#include <mutex>
#include <optional>

class QSocketNotifier;

namespace mb {

/// SPI over a stream socket (docs/names.md#links): a 16-bit little-endian length and the bytes of one transfer go out, as
/// many bytes and the level of the ready line come back; length 0 asks for the line, 65535 pulses reset. For simulated boards
/// in other processes.
class UnixSpiLink final : public SpiLink {
public:
    UnixSpiLink(LinkAddress address, Clock &clock);
    ~UnixSpiLink() override;

private:
    enum class Ask { Transfer, Level, Aside };
    struct Pending {
        Ask kind = Ask::Level;
        std::size_t size = 0; ///< bytes of the answer without the level
    };
    /// What is on its way, in the order of the answers. Another thread may send past the link (Outlet::aside).
    struct Wire {
        [[nodiscard]] bool sendAside(std::span<const std::uint8_t> message);

        std::mutex mutex;
        int descriptor = -1;
        Bytes out;
        std::deque<Pending> pending;
    };

    Result<void> doOpen() override;
    void doClose() override;
    [[nodiscard]] Outlet doOutlet() const override;
    void doTransfer(const Bytes &mosi) override;
    void doSampleReady() override;
    [[nodiscard]] bool doSignalsReady() const override { return false; }
    Result<void> doPulseReset() override;

    void ask(Pending pending, std::uint16_t length, const Bytes &bytes);
    void endOfSimulator();
    void flush();
    void receive();
    void takeAnswers();
    [[nodiscard]] std::optional<Pending> takePending();
    void watchAnswer();
    void lookForAnswer();
    void end(Error loss);

    std::shared_ptr<Wire> m_wire = std::make_shared<Wire>();
    int m_descriptor = -1;
    bool m_isServed = false; ///< it has answered
    Bytes m_in;
    std::unique_ptr<QSocketNotifier> m_readable;
    std::unique_ptr<QSocketNotifier> m_writable;
    Timer m_failed;
    Timer m_look;
    int m_silentLooks = 0; ///< in a row, while an answer is awaited
};

} // namespace mb
