// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "transport/spilink.h"

#include <deque>
#include <memory>

class QSocketNotifier;

namespace mb {

/// SPI over a stream socket (product.md, `unix:PATH`): a 16-bit little-endian length and the bytes of one transfer go out, as
/// many bytes and the level of the ready line come back; length 0 asks for the line, 65535 pulses reset. For simulated boards
/// in other processes.
class UnixSpiLink final : public SpiLink {
public:
    UnixSpiLink(LinkAddress address, Clock &clock);
    ~UnixSpiLink() override;

private:
    enum class Ask { Transfer, Level };
    struct Pending {
        Ask kind = Ask::Level;
        std::size_t size = 0; ///< bytes of the answer without the level
    };

    Result<void> doOpen() override;
    void doClose() override;
    [[nodiscard]] Outlet doOutlet() const override { return {Outlet::Form::SpiSocket, m_descriptor}; }
    void doTransfer(const Bytes &mosi) override;
    void doSampleReady() override;
    [[nodiscard]] bool doSignalsReady() const override { return false; }
    Result<void> doPulseReset() override;
    [[nodiscard]] int doClockRate() const override { return 0; }

    void ask(Pending pending, std::uint16_t length, const Bytes &bytes);
    void endOfSimulator();
    void flush();
    void receive();
    void takeAnswers();
    void end(std::string reason);

    int m_descriptor = -1;
    Bytes m_out;
    Bytes m_in;
    std::deque<Pending> m_pending;
    std::unique_ptr<QSocketNotifier> m_readable;
    std::unique_ptr<QSocketNotifier> m_writable;
    Timer m_failed;
};

} // namespace mb
