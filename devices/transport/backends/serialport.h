// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "transport/backends/echofilter.h"
#include "transport/backends/serialdriver.h"
#include "transport/seriallink.h"
#include "transport/serialqueue.h"

#include <memory>

class QSerialPort;

namespace mb {

/// A serial port of the system, or any terminal, watched by the event loop of the thread that opens it. Opened for this
/// program alone, raw, without flow control. Whatever a driver may take long for when it is opened can be done in the background.
///
/// Options of the address: `baud` (SerialLink::fixedBaudrate); `rs485=1` lets the driver of the port switch the
/// transmitter where it can, and otherwise leaves a remark that the adapter must; `echo=1` for adapters that read what
/// they send; `format` for what is not 8N1: 8E1, 8O1, 8N2. With either of the two the line is half duplex: nothing is sent before one byte time has passed since the
/// last byte from others. `errors` and `lost` also count what the driver reports, looked at once a second while bytes
/// come, and when recounted.
class SerialPortLink final : public SerialLink {
public:
    struct Options {
        bool rs485 = false;
        bool echo = false;
        std::string format = "8N1";
    };
    SerialPortLink(LinkAddress address, Clock &clock, Options options);
    ~SerialPortLink() override;

    void recount() override { lookAtDriver(); }

private:
    struct Order;
    struct Opened;

    Result<void> doOpen() override;
    Task<void> doOpenSoon(Background &background) override;
    void doClose() override;
    [[nodiscard]] Outlet doOutlet() const override;
    Result<void> doSend(std::span<const std::uint8_t> bytes, Priority priority) override;
    [[nodiscard]] std::size_t doBacklog() const override;
    Result<void> doSetBaudrate(int baudrate) override;
    Task<void> doSetBaudrateSoon(Background &background, int baudrate) override;

    [[nodiscard]] Order order() const;
    [[nodiscard]] static Result<Opened> openPort(const Order &order);
    void take(Opened opened);
    void sendUrgent(QSerialPort &port);
    void closeBehind(QSerialPort &port);
    void watch();
    void receive();
    void pump();
    [[nodiscard]] bool isHeldUp(Instant now);
    void dropHeldUp(QSerialPort &port);
    void lookAtDriver();
    void end(Error loss);
    [[nodiscard]] Error lossOfPort() const; ///< of a port that has gone
    [[nodiscard]] std::string name() const { return address().shortName(); }
    [[nodiscard]] bool isHalfDuplex() const { return m_options.rs485 || m_options.echo; }

    Options m_options;
    std::string m_path; ///< of the device file, links followed
    std::unique_ptr<QSerialPort> m_port;
    SerialQueue m_queue;
    EchoFilter m_echo;
    Instant m_sentAt{};  ///< the last byte handed over has left by then
    Instant m_heardAt{}; ///< the last byte of others
    Instant m_lookedAt{};
    int m_emptyReads = 0;
    std::optional<Instant> m_heldUpSince; ///< the driver has taken nothing since
    std::int64_t m_heldUp = 0;            ///< bytes that it had not taken then
    std::optional<DriverErrors> m_driverErrors;
    Timer m_timer;
    bool m_isWriting = false;
    Timer m_failed; ///< in a write: whoever sends does not expect to be called back
};

/// OutOfRange for an option that serial links do not have.
[[nodiscard]] Result<std::unique_ptr<Link>> makeSerialPortLink(const LinkAddress &address, Clock &clock);

} // namespace mb
