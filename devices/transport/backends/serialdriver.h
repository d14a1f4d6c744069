// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

struct serial_icounter_struct;

namespace mb {

/// What the driver of an open serial port tells and takes beyond QSerialPort. Nothing, or false, where it cannot.

/// The rate that the port really has, bit/s: an odd one is rounded to what the hardware can divide.
[[nodiscard]] std::optional<int> driverBaudrate(int descriptor);

/// False with errno where the driver refuses. May block for as long as an adapter does not answer.
[[nodiscard]] bool setDriverBaudrate(int descriptor, int baudrate);

/// Lets the kernel switch the transmitter of an RS-485 line (TIOCSRS485): on while it sends.
[[nodiscard]] bool setDriverRs485(int descriptor, bool on);

/// Asks to hand over each byte at once: an FTDI adapter otherwise collects for 16 ms.
bool askLowLatency(int descriptor);

/// Since the machine started.
struct DriverErrors {
    std::uint64_t framing = 0; ///< parity errors and breaks too
    std::uint64_t overrun = 0; ///< bytes lost before we could read them, at least
};
[[nodiscard]] DriverErrors errorsOf(const serial_icounter_struct &counted);
[[nodiscard]] std::optional<DriverErrors> driverErrors(int descriptor);

} // namespace mb
