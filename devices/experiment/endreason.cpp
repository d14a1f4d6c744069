// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/endreason.h"

#include "async/message.h"

#include <algorithm>
#include <array>

namespace mb::tuning {
namespace {

struct ReasonWords {
    EndReason reason;
    std::string_view word;
    std::string_view label;
};

constexpr std::array reasonWords{
    ReasonWords{EndReason::None, "", ""},
    ReasonWords{EndReason::Done, "done", MB_LABEL("done")},
    ReasonWords{EndReason::Interrupted, "interrupted", MB_LABEL("interrupted")},
    ReasonWords{EndReason::Travel, "travel", MB_LABEL("travel")},
    ReasonWords{EndReason::Speed, "speed", MB_LABEL("speed")},
    ReasonWords{EndReason::Current, "current", MB_LABEL("current")},
    ReasonWords{EndReason::Duty, "duty", MB_LABEL("duty")},
    ReasonWords{EndReason::Energy, "energy", MB_LABEL("energy")},
    ReasonWords{EndReason::Temperature, "temperature", MB_LABEL("temperature")},
    ReasonWords{EndReason::BusVoltage, "bus V", MB_LABEL("bus voltage")},
    ReasonWords{EndReason::WrongDirection, "wrong direction", MB_LABEL("direction")},
    ReasonWords{EndReason::NoMotion, "no motion", MB_LABEL("no motion")},
    ReasonWords{EndReason::Oscillation, "oscillation", MB_LABEL("oscillation")},
    ReasonWords{EndReason::Time, "time", MB_LABEL("time")},
    ReasonWords{EndReason::Link, "link", MB_LABEL("link")},
    ReasonWords{EndReason::User, "user", MB_LABEL("user")},
    ReasonWords{EndReason::Late, "late", MB_LABEL("lateness")},
    ReasonWords{EndReason::Slept, "slept", MB_LABEL("sleep")},
    ReasonWords{EndReason::DeviceRestarted, "device restarted", MB_LABEL("restart")},
    ReasonWords{EndReason::ForeignMaster, "foreign master", MB_LABEL("foreign master")},
    ReasonWords{EndReason::Unguarded, "unguarded", MB_LABEL("missing guardian")},
    ReasonWords{EndReason::Refused, "refused", MB_LABEL("refusal")},
    ReasonWords{EndReason::Unconfirmed, "unconfirmed", MB_LABEL("stop not confirmed")},
    ReasonWords{EndReason::Unknown, "unknown", MB_LABEL("unknown")},
};

const ReasonWords &rowOf(EndReason reason)
{
    return *std::ranges::find(reasonWords, reason, &ReasonWords::reason);
}

} // namespace

std::string_view toString(EndReason reason)
{
    return rowOf(reason).word;
}

EndReason endReasonFrom(std::string_view word)
{
    const auto *const row = std::ranges::find(reasonWords, word, &ReasonWords::word);
    return row == reasonWords.end() ? EndReason::Unknown : row->reason;
}

std::string_view endingLabel(EndReason reason)
{
    return rowOf(reason).label;
}

} // namespace mb::tuning
