// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/progress.h"
#include "families/dmc60c/pages.h"
#include "families/dmc60c/updatecontact.h"

#include <cstdint>
#include <vector>

namespace mb::dmc60c {

/// Writes the pages of an application into a unit that is in its bootloader, and repeats those that did not arrive
/// (README.md#updates). Engine thread; outlives its tasks.
class PageWriter {
public:
    enum class End {
        Written,
        Restart, ///< the device may have restarted: begin again at page 30
    };

    PageWriter(UpdateContact &contact, const Application &application, Progress &progress);

    [[nodiscard]] Task<End> writeAll();
    /// The old application may be gone: page 30 was sent.
    [[nodiscard]] bool hasTouched() const { return m_touched; }
    /// Page 0 was sent; it brings the version.
    [[nodiscard]] bool hasSentLast() const { return m_lastSent; }
    /// Of the last round.
    [[nodiscard]] int pages() const { return m_pages; }
    [[nodiscard]] int retries() const { return m_retries; }

private:
    enum class Verdict { Written, Again, Restart };

    [[nodiscard]] Task<End> writePage(const Page &page);
    /// What the status of a page means.
    [[nodiscard]] Result<Verdict> verdictOf(const Page &page, CommandStatus status);
    [[nodiscard]] Verdict afterMismatch(const Page &page);
    /// A page cannot be written before its bytes were on the wire.
    [[nodiscard]] bool isTooEarly() const;
    [[nodiscard]] Task<Verdict> afterSilence(const Page &page);
    [[nodiscard]] bool nextVariant(const Page &page);
    [[nodiscard]] std::vector<std::uint8_t> transferOf(const Page &page) const;
    void repeat(const Page &page, const Message &why);

    UpdateContact &m_contact;
    const Application &m_application;
    Progress &m_progress;
    CrcVariant m_variant = CrcVariant::A;
    bool m_variantKnown = false;
    bool m_touched = false;
    bool m_lastSent = false;
    int m_pages = 0;
    int m_retries = 0;
    int m_tries = 0; ///< of the present page
    int m_failedWrites = 0;
    Duration m_gap{};
};

} // namespace mb::dmc60c
