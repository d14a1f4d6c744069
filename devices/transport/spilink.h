// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "async/noncopyable.h"
#include "async/task.h"
#include "async/turns.h"
#include "transport/lineload.h"
#include "transport/link.h"

#include <coroutine>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

namespace mb {

/// One board on an SPI bus, this program being the master: full-duplex transfers, one at a time in the order they were asked for,
/// and, where they are wired, the board's ready line and a reset line.
class SpiLink : public Link {
    struct Job;

public:
    /// What one assertion of chip select brought back: as many bytes as went out.
    using Bytes = std::vector<std::uint8_t>;

    /// `const Result<Bytes> miso = co_await link.transfer(mosi);` Chip select falls, the bytes are clocked, chip select
    /// rises. Dropped with its coroutine: a transfer that has not begun does not take place. LinkLost when the link goes.
    class Transfer : mb::NonCopyable {
    public:
        Transfer(SpiLink &link, Bytes mosi);
        ~Transfer();
        [[nodiscard]] bool await_ready() const noexcept { return false; }
        bool await_suspend(std::coroutine_handle<> handle);
        [[nodiscard]] Result<Bytes> await_resume();

    private:
        SpiLink &m_link;
        std::shared_ptr<Job> m_job;
    };
    [[nodiscard]] Transfer transfer(Bytes mosi) { return Transfer(*this, std::move(mosi)); }

    /// For stop frames: goes in the place of every transfer that waits, which end with Cancelled: none of them may undo it. Nobody
    /// waits for what comes back. Never waits. Fails with LinkLost when the link is not open.
    Result<void> sendUrgent(Bytes mosi);
    [[nodiscard]] std::size_t backlog() const { return m_jobs.size(); }
    /// For a conversation of several transfers that nobody may break into (but for stop frames).
    [[nodiscard]] Turns &turns() { return m_turns; }

    /// Nothing when no ready line is wired.
    [[nodiscard]] std::optional<bool> ready() const { return m_ready; }
    /// Ends when the ready line is high; Timeout; Unsupported without the line.
    [[nodiscard]] Task<void> waitReady(Duration timeout);
    /// The line rose. Where the link must ask for it, only while somebody waits or watches.
    [[nodiscard]] Listeners<> &readyRaised() { return m_readyRaised; }
    /// Keeps an eye on the line even while nobody waits; a period of 0 ends that.
    void watchReady(Duration period);

    /// Hz of the bus clock, 0 when the link does not know.
    [[nodiscard]] int clockRate() const { return m_clockRate; }
    /// Fraction of the clock in use over the last second of transfers; nothing in the first, and when its rate is not known.
    [[nodiscard]] std::optional<double> load(Instant now) const { return m_load.fraction(now, m_clockRate); }

    /// Pulls the reset line low for 1 ms. Unsupported without the line.
    Result<void> pulseReset();

protected:
    SpiLink(LinkAddress address, Clock &clock, int clockRate = 0)
        : Link(std::move(address), LinkKind::Spi)
        , m_clock(clock)
        , m_clockRate(clockRate)
        , m_load(*this, clock)
        , m_turns(clock)
        , m_poll(clock)
    {
    }
    [[nodiscard]] Clock &clock() const { return m_clock; }
    /// For backends: the transfer that doTransfer() began has ended. Not from inside doTransfer(). One that cannot end loses the link.
    void finishTransfer(Bytes miso);
    void setReady(std::optional<bool> level);
    /// Ends every transfer with LinkLost.
    void dropTransfers();

private:
    struct Job {
        Bytes mosi;
        std::optional<Result<Bytes>> result;
        std::coroutine_handle<> waiting;
    };
    /// Begins a transfer; only one at a time is under way.
    virtual void doTransfer(const Bytes &mosi) = 0;
    /// Asks for the level of the ready line, which setReady() then tells; for links that are not told of changes.
    virtual void doSampleReady() { }
    [[nodiscard]] virtual bool doSignalsReady() const { return true; }
    virtual Result<void> doPulseReset() = 0;

    void begin();
    void forget(const std::shared_ptr<Job> &job);
    void poll(Duration period);
    static void conclude(const std::shared_ptr<Job> &job, Result<Bytes> result);

    Clock &m_clock;
    int m_clockRate;
    LineLoad m_load;
    Turns m_turns;
    std::deque<std::shared_ptr<Job>> m_jobs;
    std::shared_ptr<Job> m_current;
    bool m_dropping = false;
    std::optional<bool> m_ready;
    Listeners<> m_readyRaised;
    Duration m_watchPeriod{};
    int m_waiters = 0;
    Timer m_poll;
};

/// A board's side of an SPI bus, as simulated boards see it. Master and board live on one thread.
class SpiSlave {
public:
    virtual ~SpiSlave() = default;
    /// One assertion of chip select; `miso` is as long as `mosi`.
    virtual void transfer(std::span<const std::uint8_t> mosi, std::span<std::uint8_t> miso) = 0;
    [[nodiscard]] virtual bool isReady() const = 0;
    virtual void reset() = 0;
};

/// Where a simulated board is plugged in.
class SpiSlaveLink : public Link {
public:
    /// The board, nullptr for none; it outlives its being attached.
    void attach(SpiSlave *slave) { m_slave = slave; }
    /// The board's ready line may have changed.
    void readyChanged() { doReadyChanged(); }

protected:
    explicit SpiSlaveLink(LinkAddress address)
        : Link(std::move(address), LinkKind::Spi)
    {
    }
    [[nodiscard]] SpiSlave *slave() const { return m_slave; }

private:
    virtual void doReadyChanged() = 0;

    SpiSlave *m_slave = nullptr;
};

} // namespace mb
