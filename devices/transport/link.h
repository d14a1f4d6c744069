// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/background.h"
#include "async/listeners.h"
#include "async/noncopyable.h"
#include "async/result.h"
#include "transport/linkaddress.h"
#include "transport/linkidentity.h"
#include "transport/patience.h"
#include "wire/canframe.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>

namespace mb {

enum class LinkState {
    Closed, ///< not open yet, or closed by us
    Open,
    Lost, ///< was open; the interface or adapter went away, or the controller is bus-off
};

/// Since the link was opened by its user: frames on CAN, bytes on the others; a link that was lost and came back goes on
/// counting. `lost` counts what is known missing: receive buffer overruns, frames dropped by the interface.
struct LinkCounters {
    std::uint64_t rx = 0;
    std::uint64_t tx = 0;
    std::uint64_t lost = 0;
    std::uint64_t errors = 0;
};

enum class Direction { Received, Sent };

/// One thing that passed a link, valid during the notification only.
struct Traffic {
    Instant time{};
    Direction direction = Direction::Received;
    const CanFrame *can = nullptr;       ///< on a CAN link
    std::span<const std::uint8_t> bytes; ///< on the others
};

/// How another process can send on an open link after this one died: what it inherits, and how it writes there.
struct Outlet {
    enum class Form {
        None,      ///< there is no way: a driver inside this process holds the hardware
        InProcess, ///< the devices live in this process and stop with it
        CanSocket, ///< struct can_frame, one a write
        Stream,    ///< plain bytes: a terminal
        SpiDevice, ///< SPI_IOC_MESSAGE
        SpiSocket, ///< 16-bit length, then the bytes (docs/names.md#links)
    };
    Form form = Form::None;
    int descriptor = -1; ///< the link's own; whoever keeps it duplicates it
    /// Any thread of this process: sends one message as another process would, past the link, and waits for nothing; false when it
    /// cannot now. Set where answers of the line must be told apart; elsewhere a duplicate of the descriptor does. May outlive the link.
    std::function<bool(std::span<const std::uint8_t>)> aside{};

    [[nodiscard]] bool isInheritable() const { return descriptor >= 0; }
};

/// How a link goes about its work, whichever it is.
struct LinkSettings {
    Background *background = nullptr; ///< without one openSoon() is open(); outlives the link
    Patience patience;                ///< for every question that a task asks from now on
    std::function<std::string(const LinkAddress &)> identify = linkIdentity; ///< what tells Link::line()
};

/// A way to devices. Owns its backend; address, state, counters and the trace tap are common, the rest is in CanLink,
/// SerialLink and SpiLink. Single-threaded: everything, notifications too, on the thread that made it.
class Link : NonCopyable {
public:
    virtual ~Link();

    [[nodiscard]] const LinkAddress &address() const { return m_address; }
    [[nodiscard]] LinkKind kind() const { return m_kind; }
    [[nodiscard]] LinkState state() const { return m_state; }
    /// What is behind it (linkIdentity) since it was open for the first time; empty before. It stays that: a link that is lost comes
    /// back on its own line only. Who answers behind another adapter of its name was told nothing of what was told here.
    [[nodiscard]] const std::string &line() const { return m_line; }
    /// Why the link is lost; without a cause while nothing is wrong.
    [[nodiscard]] const Error &loss() const { return m_loss; }
    /// What to fail with when the link is not open: LinkLost and the reason.
    [[nodiscard]] Error notOpen() const;
    [[nodiscard]] const LinkCounters &counters() const { return m_counters; }

    /// For the guardian; of the open link. Simulated links are InProcess, backends with a descriptor of the system say so.
    [[nodiscard]] Outlet outlet() const;

    /// Fails with LinkLost and a cause that names the remedy, also where another line has its name (isReplaced). Opening an open link does nothing; a lost one
    /// starts afresh, and keeps its counters.
    [[nodiscard]] Result<void> open();
    /// open() for a thread that must not wait for a driver: what may block is done in the background that was given, for openLimit at
    /// most, then it ends with LinkLost. One at a time. Ends before the link does.
    [[nodiscard]] Task<void> openSoon();
    [[nodiscard]] bool isOpening() const { return m_opening; }
    static constexpr Duration openLimit = std::chrono::seconds(5);
    [[nodiscard]] LinkSettings &settings() { return m_settings; }
    /// Allowed in notifications of this link; destroying it there is not.
    void close();
    /// A closed link becomes a lost one: whoever opens those again opens it too.
    void closedFor(Message reason);
    /// Asks the backend for losses that are told on request only, so that counters() holds every one up to now; where a driver may
    /// hold the answer up and a background was given, a moment later. Some microseconds; not for every frame.
    virtual void recount() { }
    /// Delivers what came before this moment and was not read yet, for who ends a log: what is left unread at closing is neither
    /// delivered nor lost. Nothing to do for backends that keep no deep queue.
    virtual void catchUp() { }

    [[nodiscard]] Listeners<LinkState> &stateChanged() { return m_stateChanged; }
    /// Everything received and sent, in order. What listens here must be quick: it runs once per frame.
    [[nodiscard]] Listeners<const Traffic &> &traffic() { return m_traffic; }
    /// After each batch of received frames: the moment to commit what was decoded from it.
    [[nodiscard]] Listeners<> &batchEnded() { return m_batchEnded; }

protected:
    Link(LinkAddress address, LinkKind kind);

    /// For backends: the link is gone. The cause reads well after "link lost:".
    void lose(Error loss);
    void setState(LinkState state);
    void countLost(std::uint64_t frames) { m_counters.lost += frames; }
    void countError() { ++m_counters.errors; }
    void passed(const Traffic &traffic);

private:
    virtual Result<void> doOpen() = 0;
    /// For backends whose doOpen() may block.
    [[nodiscard]] virtual Task<void> doOpenSoon(Background &) { co_return doOpen(); }
    virtual void doClose() = 0;
    [[nodiscard]] Result<void> beginOpening();
    [[nodiscard]] Result<void> endOpening();
    [[nodiscard]] virtual Outlet doOutlet() const { return {}; }

    LinkAddress m_address;
    LinkKind m_kind;
    LinkSettings m_settings;
    std::string m_line;
    LinkState m_state = LinkState::Closed;
    Error m_loss{Fault::LinkLost};
    bool m_opening = false;
    int m_attempt = 0; ///< of opening or closing it: whatever comes of an earlier one is too late
    LinkCounters m_counters;
    Listeners<LinkState> m_stateChanged;
    Listeners<const Traffic &> m_traffic;
    Listeners<> m_batchEnded;
};

/// Another line has the name of this link by now, and it cannot be opened. Takes a look at the computer's hardware.
[[nodiscard]] bool isReplaced(Link &link);

} // namespace mb
