// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/pagewriter.h"

#include "wire/bytes.h"

#include <algorithm>

namespace mb::dmc60c {
namespace {

using namespace std::chrono_literals;

constexpr int pageTries = 4; ///< the page, and three times again
constexpr int failedWriteTries = 3;
constexpr Duration slowGap = 225us; ///< after a time-out, between the frames of a page
constexpr Duration pageTimeout = 2s;

char letterOf(CrcVariant variant)
{
    return variant == CrcVariant::A ? 'A' : variant == CrcVariant::B ? 'B' : 'C';
}

} // namespace

PageWriter::PageWriter(UpdateContact &contact, const Application &application, Progress &progress)
    : m_contact(contact)
    , m_application(application)
    , m_progress(progress)
{
}

Task<PageWriter::End> PageWriter::writeAll()
{
    m_pages = 0;
    m_progress.accepted(m_pages, m_retries);
    const int total = static_cast<int>(m_application.pages.size());
    for (const Page &page : m_application.pages) {
        m_progress.step(say("Page %1", page.number), m_pages, total);
        m_progress.part(page.number, PartState::Active);
        m_progress.mayInterrupt(page.number != firstPage);
        const Result<End> end = co_await writePage(page).attempt();
        m_progress.mayInterrupt(true);
        if (!end || *end == End::Restart)
            co_return end;
        m_progress.part(page.number, PartState::Done);
        ++m_pages;
        m_progress.accepted(m_pages, m_retries);
    }
    m_progress.step(say("All pages written"), total, total);
    co_return End::Written;
}

std::vector<std::uint8_t> PageWriter::transferOf(const Page &page) const
{
    std::vector<std::uint8_t> bytes(pageTransferSize);
    std::copy(page.bytes.begin(), page.bytes.end(), bytes.begin());
    writeU32le(bytes, pageSize, pageCrc(m_variant, page.bytes));
    return bytes;
}

void PageWriter::repeat(const Page &page, const Message &why)
{
    ++m_retries;
    m_progress.accepted(m_pages, m_retries);
    m_progress.part(page.number, PartState::Repeated);
    m_progress.log(Severity::Caution, say("page %1: %2, sent again", page.number, why));
}

bool PageWriter::nextVariant(const Page &page)
{
    if (m_variantKnown || m_variant == CrcVariant::C)
        return false;
    m_variant = m_variant == CrcVariant::A ? CrcVariant::B : CrcVariant::C;
    repeat(page, say("CRC refused, nothing was erased; trying variant %1", m_variant == CrcVariant::B ? "B" : "C"));
    return true;
}

Task<PageWriter::End> PageWriter::writePage(const Page &page)
{
    const VendorCommand command{Command::EraseWriteFlashPage, static_cast<std::uint16_t>(ImageType::Application),
        static_cast<std::uint16_t>(page.number)};
    m_tries = 0;
    m_failedWrites = 0;
    m_gap = {};
    while (m_tries < pageTries) {
        m_lastSent = m_lastSent || page.number == firstPage;
        auto writing = m_contact.send(command, transferOf(page), Attempts{1, pageTimeout}, m_gap);
        const Result<VendorReply> reply = co_await std::move(writing).attempt();
        if (!reply && reply.error().fault != Fault::Timeout) {
            m_touched = true; // its bytes may have arrived
            co_return fail(reply.error());
        }
        Verdict verdict = Verdict::Again;
        if (reply) {
            verdict = co_await verdictOf(page, reply->status);
        } else {
            verdict = co_await afterSilence(page);
        }
        if (verdict != Verdict::Again)
            co_return verdict == Verdict::Written ? End::Written : End::Restart;
    }
    co_return fail(Fault::Timeout, say("page %1 was not accepted in %2 tries", page.number, pageTries));
}

Result<PageWriter::Verdict> PageWriter::verdictOf(const Page &page, CommandStatus status)
{
    const std::string number = std::to_string(page.number);
    switch (status) {
    case CommandStatus::NoError:
        m_touched = true;
        if (isTooEarly()) {
            m_contact.noteAnswerOwed();
            m_progress.log(
                Severity::Caution, say("page %1 was said to be written before its bytes can have arrived", number));
            return Verdict::Restart;
        }
        if (!m_variantKnown)
            m_progress.log(Severity::Good,
                say("page %1 accepted with CRC variant %2", number, std::string(1, letterOf(m_variant))));
        m_variantKnown = true;
        return Verdict::Written;
    case CommandStatus::CrcMismatch: return afterMismatch(page);
    case CommandStatus::FlashWriteFailed:
        m_touched = true;
        if (++m_failedWrites >= failedWriteTries)
            return fail(Fault::Refused,
                say("page %1 cannot be written: its flash failed the device's own check %2 times", number,
                    m_failedWrites));
        repeat(page, say("the device could not verify its flash"));
        return Verdict::Again;
    case CommandStatus::DataRcvMore:
        ++m_tries;
        m_gap = slowGap;
        repeat(page, say("the byte count was out of step"));
        return Verdict::Again;
    case CommandStatus::BadParameter: return fail(Fault::Refused, say("the bootloader refuses page %1", number));
    default: return Verdict::Restart; // NotSupported: the application runs; InBootloader, AckReset: it was reset
    }
}

bool PageWriter::isTooEarly() const
{
    constexpr std::int64_t bits = 128 * (pageTransferSize / 8); // at least
    const int bitsPerSecond = m_contact.link().bitrate();       // 0 where frames take no time
    return bitsPerSecond > 0 && m_contact.clock().now() - m_contact.sentAt() < bits * Duration(1s) / bitsPerSecond;
}

PageWriter::Verdict PageWriter::afterMismatch(const Page &page)
{
    if (nextVariant(page))
        return Verdict::Again;
    if (!m_variantKnown)
        m_variant = CrcVariant::A; // all were refused: a damaged transfer is likelier than a fourth variant
    ++m_tries;
    repeat(page, say("arrived damaged, nothing was erased"));
    return Verdict::Again;
}

Task<PageWriter::Verdict> PageWriter::afterSilence(const Page &page)
{
    ++m_tries;
    m_touched = true;
    const Result<FirmwareVersions> now = co_await m_contact.versions().attempt();
    if (!now && now.error().fault == Fault::LinkLost)
        co_return fail(now.error());
    if (!now || !isInBootloader(*now))
        co_return Verdict::Restart;
    if (page.number == firstPage && now->application == m_application.version) {
        m_progress.log(
            Severity::Info, say("page 0: its status was lost, but the version is there; it is not written again"));
        co_return Verdict::Written;
    }
    repeat(page, say("no status within 2 s"));
    m_gap = slowGap;
    co_return Verdict::Again;
}

} // namespace mb::dmc60c
