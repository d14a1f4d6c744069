// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/simulator.h"

#include "wire/number.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mb {
namespace {

enum class Needs { Nothing, Seconds, Page, Frame, FrameAndTime };

struct FaultForm {
    FaultKind kind;
    std::string_view word;
    Needs needs;
};

/// As it is written.
std::string textOf(const FaultForm &row)
{
    constexpr std::array<std::string_view, 5> numbers{"", "@S", "@P", "@N", "@N:MS"}; // by Needs
    return std::string(row.word) + std::string(numbers.at(static_cast<std::size_t>(row.needs)));
}

constexpr std::array faultRows{
    FaultForm{FaultKind::Drop, "drop", Needs::Frame},
    FaultForm{FaultKind::Corrupt, "corrupt", Needs::Frame},
    FaultForm{FaultKind::Delay, "delay", Needs::FrameAndTime},
    FaultForm{FaultKind::Silent, "silent", Needs::Frame},
    FaultForm{FaultKind::Power, "power", Needs::Frame},
    FaultForm{FaultKind::PowerPage, "power-page", Needs::Page},
    FaultForm{FaultKind::Reset, "reset", Needs::Seconds},
    FaultForm{FaultKind::BusOff, "busoff", Needs::Seconds},
    FaultForm{FaultKind::EncoderDead, "encoder-dead", Needs::Seconds},
    FaultForm{FaultKind::EncoderReversed, "encoder-reversed", Needs::Nothing},
    FaultForm{FaultKind::Brownout, "brownout", Needs::Seconds},
    FaultForm{FaultKind::Stall, "stall", Needs::Seconds},
    FaultForm{FaultKind::Duplicate, "duplicate", Needs::Nothing},
};

bool parseNumber(std::string_view text, double &out)
{
    return takeNumber(text, out) && out >= 0.0;
}

constexpr double mostCounted = 9007199254740992.0; ///< beyond it a double skips numbers
constexpr double mostSeconds = 1e8;
constexpr double mostDelay = 1e9; ///< ms

/// Frames count from 1, pages from 0; neither comes in parts.
bool isPossible(double at, Needs needs)
{
    if (at > (needs == Needs::Seconds ? mostSeconds : mostCounted))
        return false;
    const bool frame = needs == Needs::Frame || needs == Needs::FrameAndTime;
    return needs == Needs::Seconds || (at == std::floor(at) && at >= (frame ? 1.0 : 0.0));
}

} // namespace

std::string_view toString(FaultKind kind)
{
    return std::ranges::find(faultRows, kind, &FaultForm::kind)->word;
}

Result<SimulatedFault> SimulatedFault::parse(std::string_view text)
{
    const auto at = text.find('@');
    SimulatedFault fault;
    const std::string_view word = text.substr(0, at);
    const auto *const row = std::ranges::find(faultRows, word, &FaultForm::word);
    if (row == faultRows.end()) {
        std::string known;
        for (const FaultForm &each : faultRows)
            known += (known.empty() ? "" : ", ") + textOf(each);
        return fail(Fault::OutOfRange, say("unknown fault '%1'", word), say("legal is %1", known));
    }
    fault.kind = row->kind;
    const auto bad = [text, row] {
        return fail(Fault::OutOfRange, say("fault '%1' does not parse", text), say("legal is %1", textOf(*row)));
    };
    if (row->needs == Needs::Nothing)
        return at == std::string_view::npos ? Result<SimulatedFault>(fault) : bad();
    if (at == std::string_view::npos)
        return bad();
    const std::string_view numbers = text.substr(at + 1);
    const auto colon = numbers.find(':');
    if (!parseNumber(numbers.substr(0, colon), fault.at) || !isPossible(fault.at, row->needs))
        return bad();
    const bool two = colon != std::string_view::npos;
    if (two != (row->needs == Needs::FrameAndTime) || (two && !parseNumber(numbers.substr(colon + 1), fault.argument))
        || fault.argument > mostDelay)
        return bad();
    return fault;
}

Result<SimulatedUnit> SimulatedUnit::parse(std::string_view text)
{
    const auto bad = [text](const Message &why) {
        return fail(Fault::OutOfRange, say("'%1' is not a simulated device: %2", text, why));
    };
    const std::string_view device = text.substr(0, text.find(','));
    const auto colon = device.find(':');
    if (colon == std::string_view::npos || colon == 0)
        return bad(say("FAMILY:ADDRESS is needed, such as dmc60c:5"));
    SimulatedUnit unit;
    unit.family = device.substr(0, colon);
    double address = 0.0;
    if (!parseNumber(device.substr(colon + 1), address) || address > 65535.0 || address != static_cast<int>(address))
        return bad(say("its address is not a number"));
    unit.address = static_cast<int>(address);
    std::string_view rest = text.substr(device.size());
    while (!rest.empty()) {
        rest.remove_prefix(1);
        const std::string_view item = rest.substr(0, rest.find(','));
        rest.remove_prefix(item.size());
        const auto equals = item.find('=');
        if (equals == std::string_view::npos || equals == 0 || equals + 1 == item.size())
            return bad(say("option '%1' is not KEY=VALUE", item));
        if (unit.option(item.substr(0, equals)))
            return bad(say("option '%1' is there twice", item.substr(0, equals)));
        if (item.substr(0, equals) != "fault") {
            unit.options.emplace_back(item.substr(0, equals), item.substr(equals + 1));
            continue;
        }
        MB_TRY(auto fault, SimulatedFault::parse(item.substr(equals + 1)));
        unit.faults.push_back(fault);
    }
    return unit;
}

std::optional<std::string_view> SimulatedUnit::option(std::string_view key) const
{
    for (const auto &[name, value] : options) {
        if (name == key)
            return value;
    }
    return std::nullopt;
}

} // namespace mb
