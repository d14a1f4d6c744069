// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/task.h"
#include "families/dmc60c/codec.h"
#include "transport/exchange.h"

#include <optional>
#include <vector>

namespace mb::dmc60c {

/// One vendor command, README.md#late-answers. At most one may be under way per device number: statuses carry neither session nor
/// command.
struct VendorRequest {
    int device = 0;
    std::uint16_t session = 0;
    VendorCommand command{};
    std::vector<std::uint8_t> data{}; ///< sent in VENDORDOUT frames behind the command
    std::optional<int> alsoFrom{};    ///< SetDevNumber: its success comes from the new number
    Duration gap{};                   ///< between VENDORDOUT frames; zero hands them all to the link at once
};

struct VendorReply {
    int device = 0; ///< the number it came from
    CommandStatus status = CommandStatus::NoError;
    std::uint8_t test = 0;
    std::vector<std::uint8_t> data; ///< of VENDORDIN frames, complete
    int unanswered = 0;             ///< earlier tries whose answers may still come
};

/// Time-outs and tries of README.md#late-answers for this command.
[[nodiscard]] Attempts attemptsOf(Command command);

/// Sends, collects the status and the bytes it announces, repeats the whole command on a time-out or a gap in the
/// bytes. A status that cannot belong to this command, by what it announces or says, is passed over. The reply may hold any status: check() judges it. Timeout after the last try, LinkLost at once. The link and
/// the clock outlive the task.
[[nodiscard]] Task<VendorReply> vendorExchange(CanLink &link, Clock &clock, VendorRequest request, Attempts attempts);

/// The status that means success: InBootloader for EnterBootloader, AckReset for SoftReset, TestPassed for tests.
[[nodiscard]] CommandStatus successOf(Command command);
/// Success, or what the device objected to.
[[nodiscard]] Result<void> check(Command command, const VendorReply &reply);
/// What an answer to GetDescriptors says: BadReply when it ends too early.
[[nodiscard]] Result<DescriptorList> descriptorsIn(const VendorReply &reply);
[[nodiscard]] std::string_view toString(CommandStatus status);

/// Names that a person knows, for messages: "SetDevName".
[[nodiscard]] std::string_view toString(Command command);

} // namespace mb::dmc60c
