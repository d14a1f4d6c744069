// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/backends/serialdriver.h"

#include <asm/termbits.h> // termios2; does not go together with <termios.h>
#include <linux/serial.h>
#include <sys/ioctl.h>

namespace mb {

std::optional<int> driverBaudrate(int descriptor)
{
    termios2 settings{};
    if (::ioctl(descriptor, TCGETS2, &settings) != 0 || settings.c_ospeed == 0)
        return std::nullopt;
    return static_cast<int>(settings.c_ospeed);
}

bool setDriverBaudrate(int descriptor, int baudrate)
{
    termios2 settings{};
    if (::ioctl(descriptor, TCGETS2, &settings) != 0)
        return false;
    settings.c_cflag &= ~static_cast<tcflag_t>(CBAUD | (CBAUD << IBSHIFT));
    settings.c_cflag |= static_cast<tcflag_t>(BOTHER | (BOTHER << IBSHIFT));
    settings.c_ospeed = settings.c_ispeed = static_cast<speed_t>(baudrate);
    return ::ioctl(descriptor, TCSETS2, &settings) == 0;
}

bool setDriverRs485(int descriptor, bool on)
{
    serial_rs485 settings{};
    if (::ioctl(descriptor, TIOCGRS485, &settings) != 0)
        return false;
    settings.flags &= ~static_cast<decltype(settings.flags)>(SER_RS485_ENABLED | SER_RS485_RTS_AFTER_SEND);
    if (on)
        settings.flags |= SER_RS485_ENABLED | SER_RS485_RTS_ON_SEND;
    return ::ioctl(descriptor, TIOCSRS485, &settings) == 0;
}

bool askLowLatency(int descriptor)
{
    serial_struct settings{};
    if (::ioctl(descriptor, TIOCGSERIAL, &settings) != 0)
        return false;
    settings.flags |= static_cast<int>(ASYNC_LOW_LATENCY);
    return ::ioctl(descriptor, TIOCSSERIAL, &settings) == 0;
}

DriverErrors errorsOf(const serial_icounter_struct &counted)
{
    return {static_cast<std::uint64_t>(counted.frame) + static_cast<std::uint64_t>(counted.parity)
            + static_cast<std::uint64_t>(counted.brk),
        static_cast<std::uint64_t>(counted.overrun) + static_cast<std::uint64_t>(counted.buf_overrun)};
}

std::optional<DriverErrors> driverErrors(int descriptor)
{
    serial_icounter_struct counted{};
    if (::ioctl(descriptor, TIOCGICOUNT, &counted) != 0)
        return std::nullopt;
    return errorsOf(counted);
}

} // namespace mb
