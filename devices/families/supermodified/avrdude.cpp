// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/avrdude.h"

#include "transport/programoutput.h"

#include <QtGlobal>

#include <algorithm>
#include <array>

namespace mb::supermodified::avrdude {
namespace {

constexpr std::size_t keptText = 20'000;
constexpr int barLength = 50;

bool isName(std::string_view text)
{
    return !text.empty() && text.front() != '-'
        && text.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_")
        == std::string_view::npos;
}

constexpr Advice noPort{QT_TRANSLATE_NOOP("table", "the port cannot be opened"),
    QT_TRANSLATE_NOOP("table", "check its name and that it is plugged in")};
constexpr Advice noProgrammer{QT_TRANSLATE_NOOP("table", "avrdude finds no such programmer on USB"),
    QT_TRANSLATE_NOOP("table", "plug it in, and check that its kind is the one named after avrdude:")};
constexpr Advice unequal{QT_TRANSLATE_NOOP("table", "the microcontroller does not hold what was written"),
    QT_TRANSLATE_NOOP("table", "run it again, with a shorter cable")};
constexpr Advice noController{QT_TRANSLATE_NOOP("table", "the programmer is there, but no microcontroller answers it"),
    QT_TRANSLATE_NOOP("table", "check the six pins and the supply")};
/// The first that is found counts.
constexpr std::array meanings{
    ProgramMeaning{"cannot find programmer", Fault::OutOfRange,
        {QT_TRANSLATE_NOOP("table", "avrdude knows no programmer of this name"),
            QT_TRANSLATE_NOOP("table", "'avrdude -c ?' lists them")}},
    ProgramMeaning{"permission denied", Fault::LinkLost,
        {QT_TRANSLATE_NOOP("table", "the port may not be opened"),
            QT_TRANSLATE_NOOP("table", "add yourself to the group dialout and log in again")}},
    ProgramMeaning{"cannot open port", Fault::LinkLost, noPort},
    ProgramMeaning{"unable to open port", Fault::LinkLost, noPort},
    ProgramMeaning{"did not find any usb device", Fault::LinkLost, noProgrammer},
    ProgramMeaning{"cannot find usb device", Fault::LinkLost, noProgrammer},
    ProgramMeaning{"verification mismatch", Fault::BadCheck, unequal},
    ProgramMeaning{"content mismatch", Fault::BadCheck, unequal},
    ProgramMeaning{"verification error", Fault::BadCheck, unequal},
    ProgramMeaning{"expected signature", Fault::Refused,
        {QT_TRANSLATE_NOOP("table", "what answers is no ATmega328P"),
            QT_TRANSLATE_NOOP("table", "check that the programmer sits on the controller")}},
    ProgramMeaning{"not in sync", Fault::Timeout,
        {QT_TRANSLATE_NOOP("table", "no bootloader answers"),
            QT_TRANSLATE_NOOP(
                "table", "restart the controller just before the start, or use a programmer on its pins")}},
    ProgramMeaning{"not responding", Fault::Timeout,
        {QT_TRANSLATE_NOOP("table", "nothing answers the programmer"),
            QT_TRANSLATE_NOOP("table", "check its cable and the supply of the controller")}},
    ProgramMeaning{"initialization failed", Fault::Timeout, noController},
    ProgramMeaning{"target doesn't answer", Fault::Timeout, noController},
};

/// How far a line with a bar is: `Writing | ####…` of 50.
int barOf(std::string_view line)
{
    const auto marks = std::ranges::count(line, '#');
    return std::min(100, static_cast<int>(marks) * 100 / barLength);
}

} // namespace

Result<Job> jobOf(std::string_view via)
{
    constexpr std::string_view usage = "avrdude:PROGRAMMER:PORT, such as avrdude:arduino:/dev/ttyUSB0 for the serial "
                                       "bootloader or avrdude:usbasp:usb for a programmer";
    const auto colon = via.find(':');
    const auto second = colon == std::string_view::npos ? colon : via.find(':', colon + 1);
    if (via.empty())
        return fail(Fault::OutOfRange, say("a Supermodified is written by avrdude"), say("add --via %1", usage));
    if (via.substr(0, colon) != scheme || second == std::string_view::npos || second + 1 == via.size()
        || !isName(via.substr(colon + 1, second - colon - 1)) || via[second + 1] == '-')
        return fail(Fault::OutOfRange, say("--via: '%1' is no way into a Supermodified", via), say("write %1", usage));
    Job job;
    job.programmer = via.substr(colon + 1, second - colon - 1);
    job.port = via.substr(second + 1);
    return job;
}

ExternalProgram::Command commandOf(const Job &job)
{
    std::vector<std::string> arguments{"-p", "m328p", "-c", job.programmer, "-P", job.port};
    if (job.rate > 0) {
        arguments.emplace_back("-b");
        arguments.push_back(std::to_string(job.rate));
    }
    if (job.isBootloader())
        arguments.emplace_back("-D"); // it erases page by page, and cannot erase itself
    arguments.emplace_back("-U");
    arguments.push_back("flash:w:" + job.file + ":i"); // read back and compared unless told otherwise
    return {"avrdude", std::move(arguments)};
}

Message titleOf(Stage stage)
{
    switch (stage) {
    case Stage::Connecting: return say("Connecting through avrdude");
    case Stage::Erasing: return say("Erasing flash");
    case Stage::Writing: return say("Writing flash");
    case Stage::Verifying: return say("Verifying flash");
    }
    return Message();
}

void Reading::take(std::string_view line, bool complete)
{
    const std::string low = lowered(line);
    const auto begins = [&low](std::string_view word) { return low.starts_with(word) && low.find('|') != low.npos; };
    if (low.find("erasing chip") != std::string::npos)
        m_stage = Stage::Erasing;
    if (begins("writing") && m_stage < Stage::Writing)
        m_stage = Stage::Writing;
    if (low.find("of flash written") != std::string::npos) {
        m_stage = Stage::Verifying;
        m_percent = 0;
    } else if (begins("writing") || (begins("reading") && m_stage == Stage::Verifying)) {
        m_percent = barOf(low);
    }
    if (!complete)
        return;
    if (m_all.size() < keptText)
        m_all += low + '\n';
    if (low.find("of flash verified") != std::string::npos)
        m_verified = true;
    if (low.find("error") != std::string::npos && low.find("0 errors") == std::string::npos)
        m_lastError = line;
}

Error Reading::failure(const Job &job) const
{
    if (const auto meaning = meaningOf(meanings, m_all))
        return *meaning;
    if (m_lastError.empty())
        return {
            Fault::BadReply, say("avrdude ended without saying why"), say("run it by hand with -c %1", job.programmer)};
    return {Fault::BadReply, Message::verbatim(m_lastError), say("run avrdude by hand to see all it says")};
}

} // namespace mb::supermodified::avrdude
