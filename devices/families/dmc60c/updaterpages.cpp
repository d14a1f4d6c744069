// SPDX-License-Identifier: GPL-3.0-or-later
// The pages of an update: README.md#updates.
#include "families/dmc60c/updater.h"

#include "wire/bytes.h"

#include <algorithm>

namespace mb::dmc60c {
namespace {

using namespace std::chrono_literals;

constexpr int pageTries = 4; ///< the page, and three times again
constexpr int failedWriteTries = 3;
constexpr Duration slowGap = 225us; ///< 7.5: after a time-out, between the frames of a page
constexpr Duration pageTimeout = 2s;

char letterOf(CrcVariant variant)
{
    return variant == CrcVariant::A ? 'A' : variant == CrcVariant::B ? 'B' : 'C';
}

} // namespace

Task<Updater::PageEnd> Updater::writePages()
{
    m_report.pages = 0;
    const int total = static_cast<int>(m_application.pages.size());
    for (const Page &page : m_application.pages) {
        m_progress.step("Page " + std::to_string(page.number), m_report.pages, total);
        m_progress.part(page.number, PartState::Active);
        m_progress.mayInterrupt(page.number != firstPage);
        auto writing = writePage(page);
        const Result<PageEnd> end = co_await std::move(writing).attempt();
        m_progress.mayInterrupt(true);
        if (!end || *end == PageEnd::Restart)
            co_return end;
        m_progress.part(page.number, PartState::Done);
        ++m_report.pages;
    }
    m_progress.step("All pages written", total, total);
    co_return PageEnd::Written;
}

std::vector<std::uint8_t> Updater::transferOf(const Page &page) const
{
    std::vector<std::uint8_t> bytes(pageTransferSize);
    std::copy(page.bytes.begin(), page.bytes.end(), bytes.begin());
    writeU32le(bytes, pageSize, pageCrc(m_variant, page.bytes));
    return bytes;
}

void Updater::repeat(const Page &page, const std::string &why)
{
    ++m_report.retries;
    m_progress.part(page.number, PartState::Repeated);
    m_progress.log(Severity::Caution, "page " + std::to_string(page.number) + ": " + why + ", sent again");
}

bool Updater::nextVariant(const Page &page)
{
    if (m_variantKnown || m_variant == CrcVariant::C)
        return false;
    m_variant = m_variant == CrcVariant::A ? CrcVariant::B : CrcVariant::C;
    repeat(page,
        std::string("CRC refused, nothing was erased; trying variant ") + (m_variant == CrcVariant::B ? "B" : "C"));
    return true;
}

Task<Updater::PageEnd> Updater::writePage(const Page &page)
{
    const VendorCommand command{Command::EraseWriteFlashPage, static_cast<std::uint16_t>(ImageType::Application),
        static_cast<std::uint16_t>(page.number)};
    m_tries = 0;
    m_failedWrites = 0;
    m_gap = {};
    while (m_tries < pageTries) {
        m_lastSent = m_lastSent || page.number == firstPage;
        auto writing = send(command, transferOf(page), Attempts{1, pageTimeout}, m_gap);
        const Result<VendorReply> reply = co_await std::move(writing).attempt();
        if (!reply && reply.error().fault != Fault::Timeout)
            co_return fail(reply.error());
        Verdict verdict = Verdict::Again;
        if (reply) {
            const Result<Verdict> judged = judge(page, reply->status);
            if (!judged)
                co_return fail(judged.error());
            verdict = *judged;
        } else {
            auto asking = afterSilence(page);
            verdict = co_await std::move(asking);
        }
        if (verdict != Verdict::Again)
            co_return verdict == Verdict::Written ? PageEnd::Written : PageEnd::Restart;
    }
    co_return fail(Fault::Timeout,
        "page " + std::to_string(page.number) + " was not accepted in " + std::to_string(pageTries) + " tries");
}

Result<Updater::Verdict> Updater::judge(const Page &page, CommandStatus status)
{
    const std::string number = std::to_string(page.number);
    switch (status) {
    case CommandStatus::NoError:
        m_touched = true;
        if (isTooEarly()) {
            m_answerOwed = true; // the one to this page
            m_progress.log(
                Severity::Caution, "page " + number + " was said to be written before its bytes can have arrived");
            return Verdict::Restart;
        }
        if (!m_variantKnown)
            m_progress.log(Severity::Good, "page " + number + " accepted with CRC variant " + letterOf(m_variant));
        m_variantKnown = true;
        return Verdict::Written;
    case CommandStatus::CrcMismatch: return afterMismatch(page);
    case CommandStatus::FlashWriteFailed:
        m_touched = true;
        if (++m_failedWrites >= failedWriteTries)
            return fail(Fault::Refused,
                "page " + number + " cannot be written: its flash failed the device's own check "
                    + std::to_string(m_failedWrites) + " times");
        repeat(page, "the device could not verify its flash");
        return Verdict::Again;
    case CommandStatus::DataRcvMore:
        ++m_tries;
        m_gap = slowGap;
        repeat(page, "the byte count was out of step");
        return Verdict::Again;
    case CommandStatus::BadParameter: return fail(Fault::Refused, "the bootloader refuses page " + number);
    default: return Verdict::Restart; // NotSupported: the application runs; InBootloader, AckReset: it was reset
    }
}

bool Updater::isTooEarly() const
{
    constexpr std::int64_t bits = 128 * (pageTransferSize / 8); // at least
    const int bitsPerSecond = m_link.bitrate();                 // 0 where frames take no time
    return bitsPerSecond > 0 && m_clock.now() - m_sentAt < bits * Duration(1s) / bitsPerSecond;
}

Updater::Verdict Updater::afterMismatch(const Page &page)
{
    if (nextVariant(page))
        return Verdict::Again;
    if (!m_variantKnown)
        m_variant = CrcVariant::A; // all were refused: a damaged transfer is likelier than a fourth variant
    ++m_tries;
    repeat(page, "arrived damaged, nothing was erased");
    return Verdict::Again;
}

Task<Updater::Verdict> Updater::afterSilence(const Page &page)
{
    ++m_tries;
    m_touched = true;
    auto asking = versions();
    const Result<FirmwareVersions> now = co_await std::move(asking).attempt();
    if (!now && now.error().fault == Fault::LinkLost)
        co_return fail(now.error());
    if (!now || !isInBootloader(*now))
        co_return Verdict::Restart;
    if (page.number == firstPage && now->application == m_application.version) {
        m_progress.log(
            Severity::Info, "page 0: its status was lost, but the version is there; it is not written again");
        co_return Verdict::Written;
    }
    repeat(page, "no status within 2 s");
    m_gap = slowGap;
    co_return Verdict::Again;
}

} // namespace mb::dmc60c
