// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"
#include "support/mutedevice.h"
#include "transport/seriallink.h"

#include <array>
#include <string_view>

namespace mb::test {

inline constexpr std::string_view textStop = "STOP\n";
inline constexpr std::string_view textDrive = "DRIVE\n";

/// A motor without watchdog on a serial line that takes lines of text and says nothing. It is there wherever one looks, and stands as soon as
/// it is told.
class TextMotor final : public MuteDevice {
public:
    TextMotor(const Family &family, SerialLink &link, Clock &clock, const Identity &identity)
        : MuteDevice(family, link, clock, identity)
        , m_link(link)
    {
    }

private:
    Result<void> doCommand(const SetPoint &) override { return say(textDrive, Priority::Normal); }
    void doStop() override { (void)say(textStop, Priority::Urgent); }
    [[nodiscard]] StopScript stopScript() const override
    {
        return {{{std::nullopt, {textStop.begin(), textStop.end()}, {}, {}, std::chrono::milliseconds(5), 2}}};
    }
    [[nodiscard]] bool isSeenStopped() const override { return clock().now() > gate().stoppedAt(); }
    Result<void> say(std::string_view text, Priority priority)
    {
        return m_link.send(std::vector<std::uint8_t>(text.begin(), text.end()), priority);
    }

    SerialLink &m_link;
};

inline Task<void> findTextMotor(Link &, Clock &, ScanSink &sink)
{
    Identity identity;
    identity.family = "text";
    identity.address = 1;
    sink.found(identity);
    co_return {};
}

inline std::unique_ptr<Device> openTextMotor(Link &link, Clock &clock, const Identity &identity);

inline constexpr std::array textKinds{LinkKind::Serial};
inline constexpr std::array textModes{Mode::Duty};

inline constexpr Family textFamily = [] {
    Family family;
    family.key = "text";
    family.title = "Text motor";
    family.links = textKinds;
    family.modes = textModes;
    family.scan = findTextMotor;
    family.open = openTextMotor;
    return family;
}();

inline constexpr std::array<const Family *, 1> textFamilies{&textFamily};

inline std::unique_ptr<Device> openTextMotor(Link &link, Clock &clock, const Identity &identity)
{
    return std::make_unique<TextMotor>(textFamily, static_cast<SerialLink &>(link), clock, identity);
}

} // namespace mb::test
