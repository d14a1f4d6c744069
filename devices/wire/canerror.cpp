// SPDX-License-Identifier: GPL-3.0-or-later
#include "wire/canerror.h"

#include <array>
#include <utility>

namespace mb {
namespace {

// linux/can/error.h; classes in the identifier, detail in the data bytes.
enum Class : std::uint32_t {
    TransmitTimeout = 0x001,
    LostArbitration = 0x002,
    Controller = 0x004,
    Protocol = 0x008,
    Transceiver = 0x010,
    NoAcknowledge = 0x020,
    BusOffClass = 0x040,
    BusErrorClass = 0x080,
    Restarted = 0x100,
    Counters = 0x200,
};
enum ControllerBit : std::uint8_t {
    ReceiveOverflow = 0x01,
    TransmitOverflow = 0x02,
    ReceiveWarning = 0x04,
    TransmitWarning = 0x08,
    ReceivePassive = 0x10,
    TransmitPassive = 0x20,
    ErrorActive = 0x40,
};
constexpr std::uint8_t placeAcknowledge = 0x19;

using Named = std::pair<std::uint8_t, const char *>;

constexpr auto violations = std::to_array<Named>({
    {0x01, MB_LABEL("bit error")},
    {0x02, MB_LABEL("form error")},
    {0x04, MB_LABEL("stuff error")},
    {0x08, MB_LABEL("dominant bit not sent")},
    {0x10, MB_LABEL("recessive bit not sent")},
    {0x20, MB_LABEL("bus overload")},
    {0x40, MB_LABEL("active error flag")},
});

constexpr auto places = std::to_array<Named>({
    {0x02, MB_LABEL("the identifier")},
    {0x03, MB_LABEL("the start of frame")},
    {0x04, MB_LABEL("the substitute remote bit")},
    {0x05, MB_LABEL("the identifier extension bit")},
    {0x06, MB_LABEL("the identifier")},
    {0x07, MB_LABEL("the identifier")},
    {0x08, MB_LABEL("the checksum")},
    {0x09, MB_LABEL("a reserved bit")},
    {0x0A, MB_LABEL("the data")},
    {0x0B, MB_LABEL("the length")},
    {0x0C, MB_LABEL("the remote bit")},
    {0x0D, MB_LABEL("a reserved bit")},
    {0x0E, MB_LABEL("the identifier")},
    {0x0F, MB_LABEL("the identifier")},
    {0x12, MB_LABEL("the intermission")},
    {0x18, MB_LABEL("the checksum delimiter")},
    {0x19, MB_LABEL("the acknowledge slot")},
    {0x1A, MB_LABEL("the end of frame")},
    {0x1B, MB_LABEL("the acknowledge delimiter")},
});

constexpr auto wirings = std::to_array<Named>({
    {0x04, MB_LABEL("CAN high is not connected")},
    {0x05, MB_LABEL("CAN high is short to battery")},
    {0x06, MB_LABEL("CAN high is short to supply")},
    {0x07, MB_LABEL("CAN high is short to ground")},
    {0x40, MB_LABEL("CAN low is not connected")},
    {0x50, MB_LABEL("CAN low is short to battery")},
    {0x60, MB_LABEL("CAN low is short to supply")},
    {0x70, MB_LABEL("CAN low is short to ground")},
    {0x80, MB_LABEL("CAN low is short to CAN high")},
});

template <std::size_t Size> const char *nameOf(const std::array<Named, Size> &table, std::uint8_t code)
{
    for (const auto &[known, name] : table) {
        if (known == code)
            return name;
    }
    return nullptr;
}

std::optional<BusState> stateOf(std::uint32_t classes, std::uint8_t controller)
{
    if ((classes & BusOffClass) != 0U)
        return BusState::BusOff;
    if ((classes & Controller) != 0U) {
        if ((controller & (ReceivePassive | TransmitPassive)) != 0)
            return BusState::Passive;
        if ((controller & (ReceiveWarning | TransmitWarning)) != 0)
            return BusState::Warning;
        if ((controller & ErrorActive) != 0)
            return BusState::Active;
    }
    if ((classes & Restarted) != 0U)
        return BusState::Active;
    return std::nullopt;
}

Message violationText(const CanErrorReport &report)
{
    Message text;
    for (const auto &[bit, name] : violations) {
        if ((report.violation & bit) != 0)
            text = text.empty() ? Message::label(name) : say("%1 and %2", text, Message::label(name));
    }
    if (text.empty())
        text = say("protocol error");
    if (const char *place = nameOf(places, report.place))
        text = say("%1 in %2", text, Message::label(place));
    return text;
}

Message wiringText(std::uint8_t code)
{
    const char *name = nameOf(wirings, code);
    return name != nullptr ? Message::label(name) : say("the transceiver reports an error");
}

Message stateText(BusState state)
{
    switch (state) {
    case BusState::Active: return say("error-active");
    case BusState::Warning: return say("error-warning");
    case BusState::Passive: return say("error-passive");
    case BusState::BusOff: return say("bus-off");
    }
    return {};
}

} // namespace

std::string_view toString(BusState state)
{
    switch (state) {
    case BusState::Active: return "error-active";
    case BusState::Warning: return "error-warning";
    case BusState::Passive: return "error-passive";
    case BusState::BusOff: return "bus-off";
    }
    return "";
}

CanErrorReport decodeError(const CanFrame &frame)
{
    const auto has = [&frame](Class wanted) { return (frame.id & wanted) != 0U; };
    const auto &data = frame.data;
    CanErrorReport report;
    report.state = stateOf(frame.id, data[1]);
    report.transmitTimeout = has(TransmitTimeout);
    report.arbitrationLost = has(LostArbitration);
    report.arbitrationBit = report.arbitrationLost ? data[0] : 0;
    report.overrun = has(Controller) && (data[1] & ReceiveOverflow) != 0;
    report.transmitOverrun = has(Controller) && (data[1] & TransmitOverflow) != 0;
    // Some controllers tell of a missing acknowledge as a protocol error in that slot.
    const bool inSlot = has(Protocol) && data[3] == placeAcknowledge;
    report.noAcknowledge = has(NoAcknowledge) || inSlot;
    report.protocol = has(Protocol) && !inSlot;
    report.violation = report.protocol ? data[2] : std::uint8_t{0};
    report.place = report.protocol ? data[3] : std::uint8_t{0};
    report.transceiver = has(Transceiver);
    report.wiring = report.transceiver ? data[4] : std::uint8_t{0};
    report.busError = has(BusErrorClass);
    report.restarted = has(Restarted);
    // The class that says so came with Linux 6.0; before, controllers put the counters beside their state.
    if (has(Counters) || (has(Controller) && (data[6] != 0 || data[7] != 0))) {
        report.transmitErrors = data[6];
        report.receiveErrors = data[7];
    }
    return report;
}

Message describe(const CanErrorReport &report)
{
    Message text;
    const auto add = [&text](bool holds, const Message &clause) {
        if (holds)
            text = text.empty() ? clause : say("%1, %2", text, clause);
    };
    add(report.transmitTimeout, say("transmission timed out"));
    add(report.arbitrationLost,
        report.arbitrationBit > 0 ? say("arbitration lost at bit %1", report.arbitrationBit) : say("arbitration lost"));
    add(report.noAcknowledge, say("nobody acknowledged"));
    add(report.protocol, violationText(report));
    add(report.overrun, say("the controller lost received frames"));
    add(report.transmitOverrun, say("the controller lost frames to send"));
    add(report.transceiver, wiringText(report.wiring));
    add(report.restarted, say("the controller started again"));
    if (report.transmitErrors && report.receiveErrors)
        add(true, say("%1 transmit and %2 receive errors", *report.transmitErrors, *report.receiveErrors));
    if (report.state)
        add(true, stateText(*report.state));
    add(text.empty(), report.busError ? say("bus error") : say("unknown error"));
    return text;
}

} // namespace mb
