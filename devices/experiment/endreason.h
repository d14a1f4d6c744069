// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>

namespace mb::tuning {

/// Why an experiment has ended.
enum class EndReason : std::uint8_t {
    None, ///< of a trial: nobody saw its end; of what is made of trials: nothing has cut it short
    Done,
    Interrupted, ///< the user stopped it
    Travel,      ///< this and all to User: a guard
    Speed,
    Current,
    Duty,
    Energy,
    Temperature,
    BusVoltage,
    WrongDirection,
    NoMotion,
    Oscillation,
    Time,
    Link,
    User,
    Late, ///< this and all to Refused: as SetPointStream::End
    Slept,
    DeviceRestarted,
    ForeignMaster,
    Unguarded,
    Refused,
    Unconfirmed, ///< the motor was not seen to stand
    Unknown,     ///< a word that this version does not know, of another's notebook
};

/// Its word in JSON and in the notebook, which never changes; empty for None.
[[nodiscard]] std::string_view toString(EndReason reason);
/// The same back; Unknown for a word that no reason has.
[[nodiscard]] EndReason endReasonFrom(std::string_view word);
/// What it is called in front of people, a label of the table: "direction" of "wrong direction"; empty for None.
[[nodiscard]] std::string_view endingLabel(EndReason reason);

} // namespace mb::tuning
