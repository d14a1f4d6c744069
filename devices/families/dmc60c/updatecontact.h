// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/dmc60c/vendor.h"
#include "model/device.h"

#include <optional>
#include <vector>

namespace mb::dmc60c {

/// The conversation with one unit during its update: finds it again after a restart, and never takes a late answer for that to a
/// newer command. Engine thread; outlives its tasks.
class UpdateContact {
public:
    struct Unit {
        std::uint16_t session = 0;
        std::optional<std::uint32_t> productId;
        std::optional<FirmwareVersions> versions;
    };

    explicit UpdateContact(Device &device);

    /// Waits for the unit to answer an enumeration, up to `limit`; takes over its session. Unsafe when several answer, or another one,
    /// which its serial number tells, or its session where that of the unit is not known.
    [[nodiscard]] Task<Unit> findAgain(Duration limit);
    [[nodiscard]] Task<FirmwareVersions> versions();
    [[nodiscard]] Task<VendorReply> send(
        VendorCommand command, std::vector<std::uint8_t> data, Attempts attempts, Duration gap);
    /// A command without data, as often as it needs to be.
    [[nodiscard]] Task<VendorReply> order(Command command);
    /// What was answered was an older command: the answer to the newest one is still to come.
    void noteAnswerOwed() { m_answerOwed = true; }
    /// Of the latest command.
    [[nodiscard]] Instant sentAt() const { return m_sentAt; }
    [[nodiscard]] CanLink &link() const { return m_link; }
    [[nodiscard]] Clock &clock() const { return m_clock; }

private:
    [[nodiscard]] Task<std::vector<Unit>> enumerate(Duration window);
    /// Waits until no answer to an earlier command can come any more: the next one might be taken for its answer.
    [[nodiscard]] Task<void> settle();
    [[nodiscard]] Task<void> expectSame(std::uint16_t session);
    [[nodiscard]] Task<std::string> serialOf(std::uint16_t session);
    void takeSession(std::uint16_t session);

    Device &m_device;
    CanLink &m_link;
    Clock &m_clock;
    std::optional<std::uint16_t> m_known; ///< the session in which it was seen to be this unit
    std::string m_serial;
    std::uint16_t m_session;
    bool m_answerOwed = false; ///< to a command that nobody answered in time
    Instant m_sentAt{};
};

[[nodiscard]] inline bool isInBootloader(const FirmwareVersions &versions)
{
    return versions.image != ImageType::Application;
}

} // namespace mb::dmc60c
