// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/mailbox.h"
#include "transport/backends/gpiolines.h"
#include "transport/spilink.h"

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

class QSocketNotifier;

namespace mb {

/// An SPI device of the kernel, mode 1, most significant bit first: `spidev:/dev/spidev0.0?speed=500000&ready=gpiochip0:25&reset=gpiochip0:24`.
/// Transfers block, so a thread of its own makes them; everything else is on the thread that opened the link.
class SpidevLink final : public SpiLink {
public:
    /// OutOfRange for an unknown option or a speed outside 10 kHz … 10 MHz.
    [[nodiscard]] static Result<std::unique_ptr<SpidevLink>> make(const LinkAddress &address, Clock &clock);
    ~SpidevLink() override;

private:
    SpidevLink(LinkAddress address, Clock &clock, int hertz);

    Result<void> doOpen() override;
    void doClose() override;
    [[nodiscard]] Outlet doOutlet() const override { return {Outlet::Form::SpiDevice, m_descriptor}; }
    void doTransfer(const Bytes &mosi) override;
    Result<void> doPulseReset() override;

    [[nodiscard]] Result<void> openDevice();
    [[nodiscard]] Result<void> openLines();
    void startWorker();
    void work();
    void transferred(Bytes miso, int error);

    int m_descriptor = -1;
    GpioLine m_readyLine;
    GpioLine m_resetLine;
    Timer m_released;
    std::unique_ptr<Mailbox> m_done;
    std::unique_ptr<QSocketNotifier> m_arrivals;

    std::mutex m_mutex;
    std::condition_variable m_wake;
    std::optional<Bytes> m_next; ///< guarded, as the next
    bool m_ending = false;
    std::thread m_worker;
};

} // namespace mb
