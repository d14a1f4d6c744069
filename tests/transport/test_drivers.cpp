// SPDX-License-Identifier: GPL-3.0-or-later
// What our computers have not: SPI devices, GPIO lines, and UARTs that count errors and switch RS-485. Their drivers are played below the
// system calls, by this program's own ioctl() and libgpiod.
#include "async/virtualclock.h"
#include "support/eventloop.h"
#include "support/pseudoterminal.h"
#include "transport/backends/serialport.h"
#include "transport/backends/spidev.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdarg>
#include <cstdint>
#include <cstring>
#include <functional>
#include <initializer_list>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gpiod.h>
#include <linux/serial.h>
#include <linux/spi/spidev.h>
#include <sys/ioctl.h>
#include <sys/syscall.h>
#include <unistd.h>

struct gpiod_line {
    std::string label;
    bool isUsed = false;
    bool level = false;
    int flags = 0; ///< of an output
    std::array<int, 2> edges{-1, -1};
};

struct gpiod_chip {
    std::array<gpiod_line, 3> lines;
};

struct gpiod_chip_iter {
    gpiod_chip *next = nullptr;
};

namespace {

using Answers = std::map<unsigned long, std::function<int(void *)>>;

Answers *drivers = nullptr;    ///< by request; the kernel answers every other
gpiod_chip *chipOne = nullptr; ///< "gpiochip1"
int openChips = 0;
int lineCause = EBUSY; ///< of one that is used

template <class Refused> Refused refuse(int cause, Refused refused)
{
    errno = cause;
    return refused;
}

} // namespace

extern "C" {

int ioctl(int descriptor, unsigned long request, ...) noexcept
{
    va_list arguments;
    va_start(arguments, request);
    void *const argument = va_arg(arguments, void *);
    va_end(arguments);
    const bool isPlayed = drivers && drivers->contains(request);
    return isPlayed ? drivers->at(request)(argument)
                    : static_cast<int>(::syscall(SYS_ioctl, descriptor, request, argument));
}

gpiod_chip_iter *gpiod_chip_iter_new()
{
    static gpiod_chip_iter all;
    all.next = chipOne;
    return &all;
}
gpiod_chip *gpiod_chip_iter_next(gpiod_chip_iter *all)
{
    return std::exchange(all->next, nullptr);
}
void gpiod_chip_iter_free(gpiod_chip_iter *) { }
gpiod_chip *gpiod_chip_open_lookup(const char *name)
{
    if (!chipOne || name != std::string("gpiochip1"))
        return refuse<gpiod_chip *>(ENOENT, nullptr);
    ++openChips;
    return chipOne;
}
void gpiod_chip_close(gpiod_chip *)
{
    --openChips;
}
const char *gpiod_chip_name(gpiod_chip *)
{
    return "gpiochip1";
}
unsigned gpiod_chip_num_lines(gpiod_chip *chip)
{
    return static_cast<unsigned>(chip->lines.size());
}
gpiod_line *gpiod_chip_get_line(gpiod_chip *chip, unsigned number)
{
    return number < chip->lines.size() ? &chip->lines[number] : refuse<gpiod_line *>(EINVAL, nullptr);
}
const char *gpiod_line_name(gpiod_line *line)
{
    return line->label.empty() ? nullptr : line->label.c_str();
}
bool gpiod_line_is_used(gpiod_line *line)
{
    return line->isUsed;
}
int gpiod_line_request_both_edges_events(gpiod_line *line, const char *)
{
    return line->isUsed ? refuse(lineCause, -1) : ::pipe(line->edges.data());
}
int gpiod_line_request_output_flags(gpiod_line *line, const char *, int flags, int level)
{
    line->flags = flags;
    line->level = level == 1;
    return line->isUsed ? refuse(lineCause, -1) : 0;
}
void gpiod_line_release(gpiod_line *line)
{
    for (int &end : line->edges) {
        if (end >= 0)
            ::close(std::exchange(end, -1));
    }
}
int gpiod_line_get_value(gpiod_line *line)
{
    return line->level ? 1 : 0;
}
int gpiod_line_set_value(gpiod_line *line, int level)
{
    line->level = level == 1;
    return 0;
}
int gpiod_line_event_get_fd(gpiod_line *line)
{
    return line->edges[0];
}
int gpiod_line_event_read(gpiod_line *line, gpiod_line_event *)
{
    char edge = 0;
    return ::read(line->edges[0], &edge, 1) == 1 ? 0 : -1;
}

} // extern "C"

namespace mb {
namespace {

using namespace std::chrono_literals;
using Bytes = std::vector<std::uint8_t>;

struct PlayedDrivers : testing::Test {
    PlayedDrivers()
    {
        drivers = &answers;
        chipOne = &chip;
    }
    ~PlayedDrivers() override
    {
        drivers = nullptr;
        chipOne = nullptr;
    }
    /// What is asked for with `request` comes from there; what is set goes there.
    template <class T> void tell(unsigned long request, const T &from)
    {
        answers[request] = [&from](void *to) { return std::memcpy(to, &from, sizeof from) ? 0 : -1; };
    }
    template <class T> void take(unsigned long request, T &to)
    {
        answers[request] = [&to](const void *from) { return std::memcpy(&to, from, sizeof to) ? 0 : -1; };
    }

    Answers answers;
    gpiod_chip chip;
    test::EventLoop loop;
};

/// Answers each byte with its complement.
struct PlayedSpi : PlayedDrivers {
    PlayedSpi()
    {
        take(SPI_IOC_WR_MODE, mode);
        take(SPI_IOC_WR_BITS_PER_WORD, bits);
        take(SPI_IOC_WR_MAX_SPEED_HZ, speed);
        answers[SPI_IOC_MESSAGE(1)] = [](void *asked) {
            const auto &transfer = *static_cast<const spi_ioc_transfer *>(asked);
            const auto *const mosi = reinterpret_cast<const std::uint8_t *>(transfer.tx_buf);
            std::transform(mosi, mosi + transfer.len, reinterpret_cast<std::uint8_t *>(transfer.rx_buf),
                [](std::uint8_t byte) { return static_cast<std::uint8_t>(~byte); });
            return static_cast<int>(transfer.len);
        };
    }
    std::unique_ptr<SpidevLink> made(const std::string &options)
    {
        return std::move(SpidevLink::make(*LinkAddress::parse("spidev:/dev/null?" + options), clock).value());
    }
    Result<Bytes> exchange(SpiLink &link, Bytes mosi)
    {
        const auto both = [](SpiLink &on, Bytes out) -> Task<Bytes> {
            Result<Bytes> in = co_await on.transfer(std::move(out));
            co_return in;
        };
        Task<Bytes> task = both(link, std::move(mosi));
        task.start();
        EXPECT_TRUE(loop.runUntil([&task] { return task.isFinished(); }));
        return task.result();
    }
    void change(unsigned number, bool level)
    {
        chip.lines[number].level = level;
        EXPECT_EQ(::write(chip.lines[number].edges[1], "x", 1), 1);
    }

    VirtualClock clock;
    std::uint8_t mode = 0;
    std::uint8_t bits = 0;
    std::uint32_t speed = 0;
};

TEST_F(PlayedSpi, IsSetUpForMode1AtTheSpeedOfItsAddressAndBytesGoBothWays)
{
    const auto link = made("speed=250000");
    ASSERT_TRUE(link->open());
    EXPECT_EQ(mode, SPI_MODE_1);
    EXPECT_EQ(bits, 8);
    EXPECT_EQ(speed, 250'000U);
    EXPECT_FALSE(link->ready()) << "no line is wired";
    EXPECT_EQ(exchange(*link, {1, 2, 3}).value(), (Bytes{0xFE, 0xFD, 0xFC}));
    EXPECT_EQ(exchange(*link, {4}).value(), Bytes{0xFB});
    EXPECT_EQ(link->pulseReset().error().fault, Fault::Unsupported);
}

TEST_F(PlayedSpi, WhatItsDriverRefusesFailsToOpenWithTheRemedy)
{
    for (const unsigned long request :
        std::initializer_list<unsigned long>{SPI_IOC_WR_MODE, SPI_IOC_WR_BITS_PER_WORD, SPI_IOC_WR_MAX_SPEED_HZ}) {
        const auto before = std::exchange(answers[request], [](void *) { return refuse(EINVAL, -1); });
        const auto opened = made("speed=250000")->open();
        ASSERT_FALSE(opened);
        EXPECT_EQ(opened.error().text(), "/dev/null cannot do SPI mode 1 at this speed; try a lower speed=");
        answers[request] = before;
    }
}

TEST_F(PlayedSpi, ATransferThatFailsLosesTheLink)
{
    const auto link = made("speed=250000");
    ASSERT_TRUE(link->open());
    answers[SPI_IOC_MESSAGE(1)] = [](void *) { return refuse(EIO, -1); };
    EXPECT_EQ(exchange(*link, {1}).error().fault, Fault::LinkLost);
    EXPECT_EQ(link->state(), LinkState::Lost);
}

TEST_F(PlayedSpi, EachCauseHasItsRemedyWhetherItIsOpenedOrUsed)
{
    const auto none = SpidevLink::make(*LinkAddress::parse("spidev:/dev/mbnone0.0"), clock).value()->open();
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().ailment, Ailment::NotThere);
    EXPECT_EQ(none.error().text(),
        "there is no /dev/mbnone0.0; enable SPI in the device tree (on a Raspberry Pi: dtparam=spi=on) and restart");
    const auto link = made("speed=250000");
    const auto lossBy = [&](int cause) {
        EXPECT_TRUE(link->open());
        answers[SPI_IOC_MESSAGE(1)] = [cause](void *) { return refuse(cause, -1); };
        EXPECT_EQ(exchange(*link, {1}).error().fault, Fault::LinkLost);
        return std::pair(link->loss().text(), link->loss().ailment);
    };
    EXPECT_EQ(lossBy(EBUSY), std::pair(std::string("/dev/null is used by another program"), Ailment::Busy));
    EXPECT_EQ(lossBy(EACCES),
        std::pair(
            std::string("no permission to use /dev/null; become a member of its group: sudo usermod -aG spi $USER"),
            Ailment::NoPermission));
    EXPECT_EQ(lossBy(EIO), std::pair(std::string("/dev/null: Input/output error"), Ailment::None));
}

TEST_F(PlayedSpi, TellsTheGuardianItsDescriptorWhileItIsOpen)
{
    const auto link = made("speed=250000");
    EXPECT_FALSE(link->outlet().isInheritable());
    ASSERT_TRUE(link->open());
    EXPECT_EQ(link->outlet().form, Outlet::Form::SpiDevice);
    EXPECT_GE(link->outlet().descriptor, 0);
    link->close();
    EXPECT_FALSE(link->outlet().isInheritable());
}

TEST_F(PlayedSpi, KnowsItsReadyLineFromTheBeginningAndHearsEveryEdge)
{
    for (const bool first : {true, false}) {
        chip.lines[2].level = first;
        const auto link = made("ready=gpiochip1:2");
        ASSERT_TRUE(link->open());
        EXPECT_EQ(link->ready(), first);
        int raised = 0;
        const Subscription rising = link->readyRaised().add([&raised] { ++raised; });
        change(2, !first);
        EXPECT_TRUE(loop.runUntil([&] { return link->ready() == !first; }));
        change(2, first);
        EXPECT_TRUE(loop.runUntil([&] { return link->ready() == first; }));
        EXPECT_EQ(raised, 1);
        chip.lines[2].level = !first; // its edge is not told yet
        EXPECT_TRUE(exchange(*link, {1}));
        EXPECT_EQ(link->ready(), !first) << "looked at after each transfer";
    }
}

TEST_F(PlayedSpi, ItsResetLineIsOpenDrainAndLowForAMillisecond)
{
    const auto link = made("reset=gpiochip1:0");
    ASSERT_TRUE(link->open());
    const gpiod_line &line = chip.lines[0];
    EXPECT_EQ(line.flags, GPIOD_LINE_REQUEST_FLAG_OPEN_DRAIN);
    EXPECT_TRUE(line.level) << "released";
    ASSERT_TRUE(link->pulseReset());
    EXPECT_FALSE(line.level);
    clock.advance(999us);
    EXPECT_FALSE(line.level);
    clock.advance(1us);
    EXPECT_TRUE(line.level);
}

TEST_F(PlayedSpi, ALineThatIsNotThereOrIsUsedFailsToOpenWithItsName)
{
    chip.lines[1].isUsed = true;
    for (const std::string option : {"ready=", "reset="}) {
        const auto causeOf = [&](const std::string &line) { return made(option + line)->open().error().text(); };
        EXPECT_EQ(causeOf("gpiochip1:1"), "GPIO line gpiochip1:1 is used by another program or driver");
        EXPECT_EQ(causeOf("gpiochip7:1"), "there is no GPIO chip for gpiochip7:1; gpiodetect lists those there are");
        EXPECT_EQ(causeOf("gpiochip1:3"), "GPIO line gpiochip1:3: Invalid argument");
        EXPECT_EQ(causeOf("25"), "a GPIO line is CHIP:LINE, as in gpiochip0:25, not '25'");
        lineCause = EACCES;
        EXPECT_EQ(causeOf("gpiochip1:1"),
            "no permission to use gpiochip1:1; become a member of its group: sudo usermod -aG gpio $USER");
        lineCause = EBUSY;
        GpioLine line;
        for (const char *refused : {"gpiochip1:1", "gpiochip7:1", "gpiochip1:3"})
            EXPECT_FALSE(option == "ready=" ? line.openInput(refused, {}) : line.openOpenDrain(refused)) << refused;
        EXPECT_EQ(openChips, 0) << "nothing stays open of what was refused";
    }
}

TEST_F(PlayedDrivers, GpioLinesAreListedWithTheirLabelsAndWhetherTheyAreUsed)
{
    chip.lines[1] = {"GPIO25", true};
    const auto lines = gpioLines();
    ASSERT_EQ(lines.size(), 3U);
    EXPECT_EQ(lines[0].name, "gpiochip1:0");
    EXPECT_EQ(lines[0].label, "");
    EXPECT_FALSE(lines[0].used);
    EXPECT_EQ(lines[1].name, "gpiochip1:1");
    EXPECT_EQ(lines[1].label, "GPIO25");
    EXPECT_TRUE(lines[1].used);
    chipOne = nullptr;
    EXPECT_TRUE(gpioLines().empty());
}

struct PlayedUart : PlayedDrivers {
    std::unique_ptr<SerialLink> opened(const std::string &options)
    {
        auto link = makeSerialPortLink(LinkAddress::parse("serial:" + terminal.path() + options).value(), loop.clock());
        EXPECT_TRUE(link && (*link)->open());
        return std::unique_ptr<SerialLink>(static_cast<SerialLink *>(link->release()));
    }
    test::PseudoTerminal terminal;
};

TEST_F(PlayedUart, CountsWhatItsDriverCountedSinceItWasOpened)
{
    serial_icounter_struct counted{};
    counted.frame = 7;
    counted.overrun = 50;
    tell(TIOCGICOUNT, counted);
    const auto link = opened("");
    counted.frame += 1;
    counted.parity += 1;
    counted.overrun += 3;
    for (int look = 0; look < 2; ++look) {
        link->recount();
        EXPECT_EQ(link->counters().errors, 2U);
        EXPECT_EQ(link->counters().lost, 3U);
    }
}

TEST_F(PlayedUart, IsLookedAtOnceASecondWhileBytesCome)
{
    VirtualClock clock;
    serial_icounter_struct counted{};
    tell(TIOCGICOUNT, counted);
    auto made = makeSerialPortLink(LinkAddress::parse("serial:" + terminal.path()).value(), clock);
    ASSERT_TRUE(made && (*made)->open());
    Link &link = **made;
    counted.frame = 3;
    const auto hear = [&] {
        const std::uint64_t before = link.counters().rx;
        terminal.write({1});
        EXPECT_TRUE(loop.runUntil([&] { return link.counters().rx > before; }));
        return link.counters().errors;
    };
    clock.advance(1s - 1ns);
    EXPECT_EQ(hear(), 0U);
    clock.advance(1ns);
    EXPECT_EQ(hear(), 3U);
    counted.frame = 4;
    EXPECT_EQ(hear(), 3U) << "not for every byte";
}

TEST_F(PlayedUart, HandsOverItsBytesAtOnceWhereItsDriverCan)
{
    serial_struct now{};
    now.flags = ASYNC_SPD_HI;
    now.baud_base = 24'000'000;
    serial_struct set{};
    tell(TIOCGSERIAL, now);
    take(TIOCSSERIAL, set);
    const auto link = opened("");
    EXPECT_EQ(set.flags, ASYNC_SPD_HI | ASYNC_LOW_LATENCY);
    EXPECT_EQ(set.baud_base, 24'000'000);
}

/// As <asm/termbits.h> has it, which does not go together with <termios.h>.
struct Termios2 {
    std::array<std::uint32_t, 4> flags{};
    std::array<std::uint8_t, 20> line{};
    std::uint32_t inRate = 0;
    std::uint32_t outRate = 0;
};
constexpr unsigned long getTermios2 = _IOR('T', 0x2A, Termios2);
constexpr unsigned long setTermios2 = _IOW('T', 0x2B, Termios2);

TEST_F(PlayedUart, ARateThatItCannotDoIsRefusedWithTheNearestAndTheOneBeforeIsKept)
{
    Termios2 has;
    std::vector<std::uint32_t> asked;
    std::int64_t off = 0;
    tell(getTermios2, has);
    answers[setTermios2] = [&](const void *from) {
        std::memcpy(&has, from, sizeof has);
        asked.push_back(has.outRate);
        has.outRate = static_cast<std::uint32_t>(has.outRate + off);
        return 0;
    };
    const auto link = opened("?baud=9600");
    EXPECT_EQ(asked, std::vector<std::uint32_t>{9600});
    const std::string name = link->address().shortName();
    off = 2304; // of 115200 two per cent
    EXPECT_TRUE(link->setBaudrate(115200));
    off = -2305;
    auto refused = link->setBaudrate(115201);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().fault, Fault::OutOfRange);
    EXPECT_EQ(refused.error().text(), name + " cannot do 115201 bit/s; the nearest it can is 112896");
    EXPECT_EQ(link->baudrate(), 115200);
    EXPECT_EQ(asked, (std::vector<std::uint32_t>{9600, 115200, 115201, 115200}));
    asked.clear();
    answers[setTermios2] = [](const void *) { return refuse(EINVAL, -1); };
    refused = link->setBaudrate(57600);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().text(), name + " cannot do 57600 bit/s: Invalid argument");
    link->close();
    const auto again = link->open();
    ASSERT_FALSE(again);
    EXPECT_EQ(again.error().fault, Fault::LinkLost);
    EXPECT_EQ(again.error().text(), name + " cannot do 115200 bit/s: Invalid argument");
}

TEST_F(PlayedUart, WhoseDriverSwitchesRs485IsAskedToAndHasNoRemark)
{
    serial_rs485 now{};
    now.flags = SER_RS485_RTS_AFTER_SEND;
    serial_rs485 set{};
    tell(TIOCGRS485, now);
    take(TIOCSRS485, set);
    EXPECT_TRUE(opened("")->remark().empty());
    EXPECT_EQ(set.flags, 0U) << "nobody asked for it";
    EXPECT_TRUE(opened("?rs485=1")->remark().empty());
    EXPECT_EQ(set.flags, SER_RS485_ENABLED | SER_RS485_RTS_ON_SEND);
}

} // namespace
} // namespace mb
