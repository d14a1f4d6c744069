// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"
#include "families/dmc60c/pagewriter.h"
#include "model/family.h"

namespace mb::dmc60c {

/// One firmware update of one device: the state of README.md#updates, and a method per paragraph. A link that is lost meanwhile is
/// waited for, `linkPatience` at a time; then the unit may have restarted, so that all pages are sent again (README.md#updates).
class Updater : NonCopyable {
public:
    Updater(Device &device, const Application &application, Progress &progress);

    /// The whole story. Ends with a report whatever the device does; an error only when the link is lost.
    [[nodiscard]] Task<UpdateReport> run(UpdateOptions options);

private:
    [[nodiscard]] Task<void> preflight(UpdateOptions options);
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
    [[nodiscard]] Task<void> leaveBootloader();
    [[nodiscard]] Task<void> verify();
    /// Nothing was erased: the application that is there runs again.
    [[nodiscard]] Task<void> giveBack();
    [[nodiscard]] UpdateReport failed(const Error &error) const;

    Device &m_device;
    const Application &m_application;
    Progress &m_progress;
    UpdateContact m_contact;
    PageWriter m_pages;
    bool m_upToDate = false;
    bool m_runs = false;         ///< the application, before the update
    bool m_entered = false;      ///< its bootloader, by our order
    bool m_inBootloader = false; ///< as it said last
    bool m_isWritten = false;    ///< all pages are in
    bool m_isLeft = false;       ///< and the application runs
    int m_restarts = 0;
    int m_losses = 0; ///< of the link
    UpdateReport m_report;
};

} // namespace mb::dmc60c
