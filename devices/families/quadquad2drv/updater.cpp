// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/quadquad2drv/updater.h"

#include "async/sleep.h"
#include "families/quadquad2drv/protocol.h"
#include "transport/spilink.h"

#include <algorithm>
#include <cctype>

namespace mb::quadquad2drv {
namespace {

using namespace std::chrono_literals;

constexpr Duration verifyPeriod = 500ms;
constexpr Duration verifyTime = 60s; ///< the jumper is taken out by hand
constexpr int resetEvery = 4;        ///< questions for the version

std::string lower(std::string text)
{
    std::transform(
        text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

bool holds(const std::string &text, const std::string &word)
{
    return !word.empty() && lower(text).find(lower(word)) != std::string::npos;
}

} // namespace

Updater::Updater(
    Device &device, SerialLink &link, const FirmwareImage &image, Progress &progress, BootSettings settings)
    : m_device(device)
    , m_link(link)
    , m_clock(device.clock())
    , m_image(image)
    , m_progress(progress)
    , m_settings(std::move(settings))
    , m_console(link, device.clock(), m_settings.ending)
{
    m_report.from = device.identity().firmware;
}

bool Updater::isFailure(const std::string &text) const
{
    return std::ranges::any_of(m_settings.failures, [&text](const std::string &word) { return holds(text, word); });
}

bool Updater::isBanner(const std::string &text) const
{
    return holds(text, m_settings.banner);
}

void Updater::heard(const std::string &text)
{
    m_progress.log(isFailure(text) ? Severity::Danger : Severity::Info, Message::verbatim("< " + text));
}

void Updater::resetBoard()
{
    auto &spi = static_cast<SpiLink &>(m_device.link());
    if (spi.pulseReset())
        m_progress.log(Severity::Info, say("the reset line was pulsed"));
}

UpdateReport Updater::failed(const Error &error) const
{
    UpdateReport report = m_report;
    report.outcome = UpdateOutcome::Failed;
    report.pages = static_cast<int>(m_sent);
    report.fault = error.fault;
    report.evidence = error.detail;
    report.remedy = error.help();
    if (m_sent > 0)
        report.remedy = joined(report.remedy,
            say("%1 of %2 lines were confirmed. The bootloader keeps waiting: leave the jumper in and run the update "
                "again",
                m_sent, m_image.lines().size()));
    return report;
}

Task<UpdateReport> Updater::run(bool dryRun)
{
    if (dryRun) {
        m_report.outcome = UpdateOutcome::Done;
        m_report.evidence
            = say("dry run: %1 lines would be sent over %2", m_image.lines().size(), m_link.address().text());
        co_return m_report;
    }
    m_progress.replaces(m_report.from);
    Result<void> done = co_await openLine().attempt();
    if (done) {
        done = co_await awaitBanner().attempt();
    }
    if (done) {
        done = co_await sendAll().attempt();
    }
    if (done) {
        done = co_await leave().attempt();
    }
    if (done) {
        done = co_await verify().attempt();
    }
    if (!done)
        co_return failed(done.error());
    co_return m_report;
}

Task<void> Updater::openLine()
{
    if (!m_link.fixedBaudrate())
        co_await m_link.setBaudrate(m_settings.baudrate);
    co_await m_link.openSoon();
    co_return {};
}

Task<void> Updater::awaitBanner()
{
    m_progress.step(say("close the jumper between AUX1 and AUX2, then reset the board or switch it off and on"), 0, 0);
    for (const Step later : {Step::Sending, Step::OpenJumper, Step::Compare})
        m_progress.part(static_cast<int>(later), PartState::Waiting);
    for (const Step now : {Step::CloseJumper, Step::Reset, Step::Greeting})
        enter(now);
    m_device.stop();
    resetBoard();
    const Instant deadline = m_clock.now() + m_settings.bannerTime;
    while (m_clock.now() < deadline) {
        const Result<std::string> text = co_await m_console.line(deadline - m_clock.now()).attempt();
        if (!text && text.error().fault != Fault::Timeout)
            co_return fail(text.error());
        if (!text)
            break;
        heard(*text);
        if (isBanner(*text)) {
            for (const Step done : {Step::CloseJumper, Step::Reset, Step::Greeting})
                leaveStep(done);
            co_return {};
        }
    }
    co_return fail(Fault::Timeout, say("the bootloader did not announce itself"),
        say("check the jumper AUX1–AUX2, the crossed wires TX and RX, and the 3.3 V levels, then reset the board"));
}

Task<void> Updater::sendAll()
{
    const std::size_t total = m_image.lines().size();
    enter(Step::Sending);
    for (std::size_t i = 0; i < total; ++i) {
        m_progress.step(say("sending the firmware"), static_cast<int>(i), static_cast<int>(total));
        co_await sendLine(i);
        m_sent = i + 1;
        m_progress.accepted(static_cast<int>(m_sent), 0);
    }
    m_report.pages = static_cast<int>(total);
    leaveStep(Step::Sending);
    m_progress.step(say("sending the firmware"), static_cast<int>(total), static_cast<int>(total));
    co_return {};
}

/// Every line is confirmed before the next, and never sooner than 50 ms after it.
Task<void> Updater::sendLine(std::size_t index)
{
    m_console.clear();
    const Instant begin = m_clock.now();
    const std::string &text = m_image.lines()[index];
    tell(text);
    co_await m_console.send(text);
    bool confirmed = false;
    while (!confirmed) {
        const Duration left = begin + m_settings.answerTime - m_clock.now();
        const Result<std::string> answer = co_await m_console.line(std::max<Duration>(left, 1ms)).attempt();
        const Message line = say("line %1", index + 1);
        if (!answer && answer.error().fault == Fault::Timeout)
            co_return fail(Fault::Timeout, say("%1 was not confirmed", line));
        if (!answer)
            co_return fail(answer.error());
        if (auto good = checkAnswer(index, *answer); !good)
            co_return good;
        confirmed = *answer != text;
    }
    const Instant next = begin + m_settings.lineTime;
    if (next > m_clock.now())
        co_await Sleep(m_clock, next - m_clock.now());
    while (const auto more
        = m_console.take()) { // a second answer does not confirm the next line, but it may take back the first
        if (auto good = checkAnswer(index, *more); !good)
            co_return good;
    }
    co_return {};
}

/// What the bootloader says to a line.
Result<void> Updater::checkAnswer(std::size_t index, const std::string &answer)
{
    if (answer == m_image.lines()[index]) { // an echo, and a record may spell a word of failure
        m_progress.log(Severity::Info, Message::verbatim("< " + answer));
        return {};
    }
    heard(answer);
    const Message line = say("line %1", index + 1);
    if (isBanner(answer))
        return fail(Fault::Refused, say("the board restarted at %1", line));
    if (isFailure(answer))
        return fail(Fault::Refused, say("%1 was refused: %2", line, answer));
    return {};
}

Task<void> Updater::leave()
{
    enter(Step::OpenJumper);
    if (!m_settings.farewell.empty()) {
        tell(m_settings.farewell);
        co_await m_console.send(m_settings.farewell);
    }
    m_progress.step(say("take the jumper out; the board is asked for its version"), 0, 0);
    co_await Sleep(
        m_clock, 200ms); // no pulse on the reset line: with the jumper in, that would enter the bootloader again
    co_return {};
}

/// A bootloader that greets again was reset with the jumper in: the user is told, and the reset line pulsed now and then.
void Updater::hearBoot()
{
    while (const auto text = m_console.take()) {
        heard(*text);
        if (isBanner(*text))
            m_progress.step(say("the jumper is still in: take it out, then reset the board"), 0, 0);
    }
}

Task<void> Updater::verify()
{
    enter(Step::Compare);
    const Instant deadline = m_clock.now() + verifyTime;
    for (int asked = 1; m_clock.now() < deadline; ++asked) {
        hearBoot();
        if (asked % resetEvery == 0) {
            resetBoard();
            co_await Sleep(m_clock, resetTime);
        }
        const Result<void> answered = co_await m_device.refresh().attempt();
        if (answered) {
            leaveStep(Step::OpenJumper);
            leaveStep(Step::Compare);
            m_report.to = m_device.identity().firmware;
            m_report.verified = m_report.to != m_report.from; // the file does not name its version
            m_report.outcome = UpdateOutcome::Done;
            m_report.evidence = m_report.verified
                ? say("every line was confirmed, and the board answers with version %1", m_report.to)
                : say("every line was confirmed, and the board answers with version %1, the same as before, so that "
                      "nothing "
                      "proves the new firmware",
                    m_report.to);
            co_return {};
        }
        if (answered.error().fault == Fault::LinkLost)
            co_return fail(answered.error());
        co_await Sleep(m_clock, verifyPeriod);
    }
    co_return fail(Fault::Timeout, say("every line was confirmed, but the board does not answer over SPI"),
        say("take the jumper out and reset it"));
}

} // namespace mb::quadquad2drv
