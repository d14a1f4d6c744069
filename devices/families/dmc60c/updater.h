// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/dmc60c/pages.h"
#include "families/dmc60c/vendor.h"
#include "model/device.h"
#include "model/family.h"

#include <vector>

namespace mb::dmc60c {

/// One firmware update of one device: the state of README.md#updates, and a method per paragraph. A link that is lost meanwhile is
/// waited for, `linkPatience` at a time; then the unit may have restarted, so that all pages are sent again (README.md#updates).
class Updater {
public:
    Updater(Device &device, const Application &application, Progress &progress);
    Updater(const Updater &) = delete;
    Updater &operator=(const Updater &) = delete;

    /// The whole story. Ends with a report whatever the device does; an error only when the link is lost.
    [[nodiscard]] Task<UpdateReport> run(UpdateOptions options);

private:
    struct Unit {
        std::uint16_t session = 0;
        std::optional<std::uint32_t> productId;
        std::optional<FirmwareVersions> versions;
    };
    enum class PageEnd {
        Written,
        Restart, ///< the device may have restarted: begin again at page 30
    };

    enum class Verdict { Written, Again, Restart };

    [[nodiscard]] Task<std::vector<Unit>> enumerate(Duration window);
    /// Waits for the unit to answer an enumeration, up to `limit`; takes over its session.
    [[nodiscard]] Task<Unit> findAgain(Duration limit);
    [[nodiscard]] Task<FirmwareVersions> versions();
    [[nodiscard]] Task<VendorReply> send(
        VendorCommand command, std::vector<std::uint8_t> data, Attempts attempts, Duration gap);
    /// Waits until no answer to an earlier command can come any more: the next one might be taken for its answer.
    [[nodiscard]] Task<void> settle();
    [[nodiscard]] Task<void> preflight(bool force);
    /// A restart takes what is not in flash yet.
    [[nodiscard]] Task<void> keepParameters();
    [[nodiscard]] Task<void> enterBootloader();
    /// All that changes the unit, as often as the link comes back.
    [[nodiscard]] Task<void> install();
    [[nodiscard]] Task<void> installOnce();
    [[nodiscard]] Task<void> awaitLink(Error lost);
    /// Where the unit stands after the link was away.
    [[nodiscard]] Task<void> lookAgain();
    [[nodiscard]] Task<void> writeAll();
    [[nodiscard]] Task<PageEnd> writePages();
    [[nodiscard]] Task<PageEnd> writePage(const Page &page);
    /// What the status of a page means.
    [[nodiscard]] Result<Verdict> judge(const Page &page, CommandStatus status);
    [[nodiscard]] Verdict afterMismatch(const Page &page);
    /// A page cannot be written before its bytes were on the wire.
    [[nodiscard]] bool isTooEarly() const;
    [[nodiscard]] Task<Verdict> afterSilence(const Page &page);
    [[nodiscard]] Task<void> leaveBootloader();
    [[nodiscard]] Task<void> verify();
    [[nodiscard]] bool nextVariant(const Page &page);
    [[nodiscard]] std::vector<std::uint8_t> transferOf(const Page &page) const;
    void repeat(const Page &page, const std::string &why);
    [[nodiscard]] UpdateReport failed(const Error &error) const;
    void takeSession(std::uint16_t session);
    [[nodiscard]] static bool isInBootloader(const FirmwareVersions &versions)
    {
        return versions.image != ImageType::Application;
    }

    Device &m_device;
    CanLink &m_link;
    Clock &m_clock;
    const Application &m_application;
    Progress &m_progress;
    std::uint16_t m_session;
    CrcVariant m_variant = CrcVariant::A;
    bool m_variantKnown = false;
    bool m_touched = false; ///< page 30 was sent: the old application may be gone
    bool m_upToDate = false;
    bool m_runs = false;       ///< the application, before the update
    bool m_lastSent = false;   ///< page 0 was sent; it brings the version
    bool m_isWritten = false;  ///< all pages are in
    bool m_isLeft = false;     ///< and the application runs
    bool m_answerOwed = false; ///< to a command that nobody answered in time
    Instant m_sentAt{};        ///< the latest command
    Duration m_gap{};
    int m_tries = 0; ///< of the present page
    int m_failedWrites = 0;
    int m_restarts = 0;
    int m_losses = 0; ///< of the link
    UpdateReport m_report;
};

} // namespace mb::dmc60c
