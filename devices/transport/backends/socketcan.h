// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "transport/backends/caninterface.h"
#include "transport/backends/hardwaretime.h"
#include "transport/canlink.h"
#include "transport/canqueue.h"

#include <cstdint>
#include <memory>

class QSocketNotifier;
struct can_frame;
struct msghdr;

namespace mb {

/// A CAN interface of the kernel, watched by the event loop of the thread that opens it.
///
/// Frames are read in batches, without allocation, stamped by the adapter or the kernel; stamps never run backwards and
/// are never in the future. Frames that do not fit the kernel's queue wait here, in order, urgent ones first; none is
/// dropped while the link is open, and past thousands of them send() refuses. Urgent frames also overtake what waits in the kernel (pfifo_fast, the usual queue of
/// CAN). `lost` counts what the kernel dropped because it was not read in time, what the interface and its driver dropped (looked at
/// twice a second, and by recount(); in the background where there is one), and overruns that the controller reports.
class SocketCanLink final : public CanLink {
public:
    /// The interface that the path of the address names.
    SocketCanLink(LinkAddress address, Clock &clock);
    /// Works on a descriptor that keeps message boundaries (SOCK_SEQPACKET), and owns it; can be opened once. For
    /// tests.
    SocketCanLink(LinkAddress address, Clock &clock, int descriptor);
    ~SocketCanLink() override;

    /// For who must be able to send when this process cannot; -1 while not open.
    [[nodiscard]] int descriptor() const { return m_descriptor; }
    /// How many frames the kernel keeps for us while we do not read: what it gave, not what was asked for.
    [[nodiscard]] int receiveBufferFrames() const { return m_receiveBuffer / frameInKernel; }
    void recount() override;
    void catchUp() override;

private:
    static constexpr int frameInKernel = 768; ///< bytes that one frame takes of the receive buffer
    struct Batch;

    Result<void> doOpen() override;
    Task<void> doOpenSoon(Background &background) override;
    void doClose() override;
    [[nodiscard]] Outlet doOutlet() const override { return {Outlet::Form::CanSocket, m_descriptor}; }
    Result<void> doSend(const CanFrame &frame, Priority priority) override;
    [[nodiscard]] std::size_t doBacklog() const override { return m_queue.size(); }
    [[nodiscard]] int doBitrate() const override { return m_interface.bitrate; }
    [[nodiscard]] int doReceiveCapacity() const override { return receiveBufferFrames(); }
    [[nodiscard]] bool doIsListenOnly() const override { return m_interface.listenOnly; }

    void watch();
    void unwatch();
    bool receive();
    void takeBatch(unsigned count);
    void take(const can_frame &raw, Instant time);
    [[nodiscard]] Instant stampOf(const msghdr &message, Duration unixOffset, Instant now);
    void noteDrops(std::uint32_t total);
    void adopt(const CanInterface &interface);
    void take(int descriptor, int receiveBuffer);
    void look();
    void askKernel(Background &background);
    void takeInterface(const CanInterface &now);
    void countInterface();
    void flush();
    [[nodiscard]] bool tryLater(int cause);
    void endLater(Error loss);
    void end(Error loss);

    int m_given = -1;
    int m_descriptor = -1;
    int m_receiveBuffer = 0;
    CanInterface m_interface; ///< as last seen; index 0: none behind this descriptor
    CanInterface m_atOpening;
    std::uint64_t m_overruns = 0; ///< told by error frames
    std::uint64_t m_counted = 0;  ///< losses at the interface that are part of `lost`
    std::uint32_t m_drops = 0;
    Instant m_latest{};
    HardwareTime m_hardware;
    std::unique_ptr<Batch> m_batch;
    CanQueue m_queue;
    std::unique_ptr<QSocketNotifier> m_readable;
    std::unique_ptr<QSocketNotifier> m_writable;
    Timer m_retry;
    Timer m_failed;
    Timer m_look;
    std::shared_ptr<bool> m_asked; ///< true while the kernel is asked in the background; another one after each opening
};

} // namespace mb
