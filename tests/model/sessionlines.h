// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/virtualclock.h"
#include "model/sessionstops.h"
#include "support/fakeguard.h"
#include "support/mutedevice.h"
#include "support/pseudoterminal.h"
#include "transport/seriallink.h"

#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <array>
#include <filesystem>

#include <poll.h>

namespace mb::test {

using Bytes = std::vector<std::uint8_t>;

inline constexpr Mode wireModes[] = {Mode::Duty};
inline constexpr std::uint8_t driveByte = 0x11;
inline constexpr std::uint8_t stopByte = 0x22;
inline constexpr std::uint8_t scriptByte = 0x33, releaseByte = 0x44;

std::unique_ptr<Device> openWired(Link &link, Clock &clock, const Identity &identity);

/// A motor without watchdog on a serial line: one byte drives it, another stops it, a third one is its script.
inline constexpr Family wiredFamily = [] {
    Family family{};
    family.key = "wired";
    family.title = "Wired motor";
    family.modes = wireModes;
    family.open = openWired;
    return family;
}();

class WiredMotor final : public MuteDevice {
public:
    WiredMotor(SerialLink &link, Clock &clock, Identity identity)
        : MuteDevice(wiredFamily, link, clock, std::move(identity))
        , m_line(link)
    {
    }
    /// As another master drives it.
    void turn()
    {
        Liveness now = liveness();
        now.moving = true;
        setLiveness(now);
    }
    bool seen = false;

private:
    Result<void> doCommand(const SetPoint &) override { return m_line.send(Bytes{driveByte}); }
    Result<void> doReleaseMoves() override { return m_line.send(Bytes{releaseByte}); }
    void doStop() override { (void)m_line.send(Bytes{stopByte}, Priority::Urgent); }
    [[nodiscard]] StopScript stopScript() const override
    {
        return {{{{}, {scriptByte}, {}, {}, std::chrono::milliseconds(5), 1}}};
    }
    [[nodiscard]] bool isSeenStopped() const override { return seen; }

    SerialLink &m_line;
};

inline std::unique_ptr<Device> openWired(Link &link, Clock &clock, const Identity &identity)
{
    return std::make_unique<WiredMotor>(static_cast<SerialLink &>(link), clock, identity);
}

/// Two lines with names of their own that can go away and come back.
class SessionLines : public testing::Test {
protected:
    SessionLines()
    {
        book.setIdentify([](const LinkAddress &address) { // the terminal, whatever it is called
            std::error_code failed;
            return std::filesystem::canonical(address.path, failed).string();
        });
        for (std::size_t i = 0; i < lines.size(); ++i) {
            plug(i);
            links[i] = openLine(i);
        }
    }
    [[nodiscard]] std::string pathOf(std::size_t line) const
    {
        return folder.path().toStdString() + "/line" + std::to_string(line);
    }
    void plug(std::size_t line) const { plug(line, line); }
    /// An adapter under the name of another one.
    void plug(std::size_t line, std::size_t name) const
    {
        std::filesystem::create_symlink(lines.at(line).path(), pathOf(name));
    }
    void unplug(std::size_t line) const { std::filesystem::remove(pathOf(line)); }
    Link *openLine(std::size_t line)
    {
        const auto opened = book.open(LinkAddress{"serial", pathOf(line), {}});
        EXPECT_TRUE(opened) << (opened ? "" : opened.error().text());
        return opened.value_or(nullptr);
    }
    WiredMotor &motorOn(Link &link, int number = 3, DeviceState state = DeviceState::Online)
    {
        Identity identity;
        identity.family = "wired";
        identity.address = number;
        identity.state = state;
        return static_cast<WiredMotor &>(devices.adopt(link, wiredFamily, identity, {}));
    }
    /// As a guardian of an earlier program writes it down.
    [[nodiscard]] OwedStop owedTo(const Device &motor, Duration ago = {}) const
    {
        return {motor.link().line(), motor.selector(), {{{{}, {scriptByte}, {}, {}, std::chrono::milliseconds(5), 1}}},
            clock.now() - ago};
    }
    void run(Device &motor)
    {
        SetPoint setPoint;
        setPoint.mode = Mode::Duty;
        ASSERT_TRUE(devices.stream(motor).start(setPoint, std::chrono::hours(1)));
        clock.advance(std::chrono::milliseconds(10));
    }
    /// As Session::closeLink().
    void close(Link &link)
    {
        stops.beforeClose(link);
        devices.forget(link);
        stops.leave(link);
        book.close(link);
    }
    /// The adapter of a line comes out.
    void lose(std::size_t line)
    {
        unplug(line);
        links.at(line)->close();
        links.at(line)->closedFor(say("it came out"));
    }
    [[nodiscard]] Subscription tap(std::size_t line, Bytes &to) const
    {
        return links.at(line)->traffic().add(
            [&to](const Traffic &traffic) { to.insert(to.end(), traffic.bytes.begin(), traffic.bytes.end()); });
    }
    /// The next bytes that the other end of a line gets; the kernel hands them over in its own time.
    Bytes heard(std::size_t line, std::size_t count) const
    {
        Bytes all;
        pollfd waiting{lines.at(line).descriptor(), POLLIN, 0};
        while (all.size() < count && ::poll(&waiting, 1, 5000) == 1 && (waiting.revents & POLLIN) != 0) {
            const Bytes more = lines.at(line).read();
            all.insert(all.end(), more.begin(), more.end());
        }
        return all;
    }

    std::array<PseudoTerminal, 2> lines;
    QTemporaryDir folder;
    VirtualClock clock;
    FakeGuard guard;
    std::array<const Family *, 1> families{&wiredFamily};
    LinkBook book{clock, families};
    SessionMemory memory{clock};
    DeviceBook devices{clock, book, memory, &guard};
    SessionStops stops{clock, book, devices, &guard};
    std::array<Link *, 2> links{};
};

} // namespace mb::test
