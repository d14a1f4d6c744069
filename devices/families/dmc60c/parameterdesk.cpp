// SPDX-License-Identifier: GPL-3.0-or-later
// Controller: parameters, faults, rates, and the proof that flash has them.
#include "families/dmc60c/parameterdesk.h"

#include "async/noncopyable.h"
#include "async/sleep.h"
#include "families/dmc60c/channels.h"
#include "families/dmc60c/parameters.h"

#include <algorithm>
#include <array>
#include <utility>

namespace mb::dmc60c {
namespace {

using namespace std::chrono_literals;

constexpr Duration sequencePollPeriod = 250ms;
constexpr int counterTries = 4;

/// False for as long as this lives, and then what it was.
class Remembered : NonCopyable {
public:
    explicit Remembered(bool &flag)
        : m_flag(flag)
        , m_was(std::exchange(flag, false))
    {
    }
    ~Remembered() { m_flag = m_flag || m_was; }

private:
    bool &m_flag;
    const bool m_was;
};

constexpr std::array<std::string_view, 5> faultKeys{
    "over_current", "over_temperature", "under_voltage", "gate_driver", "communication"};

} // namespace

ParameterDesk::ParameterDesk(const UnitContact &contact, VendorOrders &orders, ParameterStore &known)
    : m_contact(contact)
    , m_orders(orders)
    , m_known(known)
    , m_exchange(contact.link, contact.clock)
    , m_flash(contact.clock.now())
{
}

void ParameterDesk::restarted()
{
    m_flashLost = m_flashLost || (m_flash.isPending() && !m_flash.isGivenUp()); // what was given up has been told
    m_flash.restarted();
}

Task<std::int64_t> ParameterDesk::read(std::uint8_t parameter)
{
    const Parameter &row = parameterTable()[parameterWithId(parameter)->value];
    Result<ParamResponse> response = co_await m_exchange.get(m_contact.target(), parameter).attempt();
    if (response && response->status == ParameterStatus::BadParameter && row.nature == Nature::Counter) {
        auto setting = m_exchange.set(m_contact.target(), parameter, 0); // "keep": reads as well (README.md#parameters)
        response = co_await std::move(setting).attempt();
    }
    if (!response) {
        if (response.error().fault == Fault::Timeout)
            m_contact.unanswered();
        co_return fail(response.error().about(row.key));
    }
    co_await dmc60c::check(*response, row.key);
    co_return rawOf(row.type, response->field);
}

Task<std::int64_t> ParameterDesk::write(const Parameter &parameter, std::int64_t raw)
{
    const auto number = static_cast<std::uint8_t>(parameter.id);
    if (parameter.persistent && parameter.nature == Nature::Setting) {
        const std::int64_t present = co_await read(number);
        if (present == raw)
            co_return raw; // nothing changes, so flash must not be expected to
        if (m_flash.wantsBaseline()) {
            const Result<std::uint32_t> sequence = co_await m_orders.flashSequence().attempt();
            m_flash.setBaseline(sequence ? std::optional(*sequence) : std::nullopt);
        }
        m_flash.changed(m_contact.clock.now()); // also when the answer is lost
    }
    auto setting = m_exchange.set(m_contact.target(), number, fieldOf(parameter.type, raw));
    const Result<ParamResponse> response = co_await std::move(setting).attempt();
    if (!response)
        co_return fail(response.error().about(parameter.key));
    co_await dmc60c::check(*response, parameter.key);
    co_return rawOf(parameter.type, response->field);
}

/// The answer to a clear carries the count before it, and so does that to any question before it, such as the fault watch's; so a
/// clear is believed, and repeated, by a reading after it (README.md#counters). Sticky bits of what is still present come back at once.
Task<std::int64_t> ParameterDesk::clearCounter(const Parameter &parameter, std::int64_t raw)
{
    const auto number = static_cast<std::uint8_t>(parameter.id);
    std::int64_t before = co_await read(number);
    for (int attempt = 0; attempt < counterTries; ++attempt) {
        auto setting = m_exchange.setOnce(m_contact.target(), number, fieldOf(parameter.type, raw));
        const Result<ParamResponse> response = co_await std::move(setting).attempt();
        if (response) {
            co_await dmc60c::check(*response, parameter.key);
            const std::int64_t told = rawOf(parameter.type, response->field);
            before = std::max(before, told);
            if (number == param::stickyFaults || before == 0)
                co_return told;
        } else if (response.error().fault != Fault::Timeout) {
            co_return fail(response.error());
        }
        const std::int64_t now = co_await read(number);
        if (now < before || now == 0)
            co_return before;
    }
    co_return fail(Fault::Timeout, say("%1 was %2 and is not known to be cleared", parameter.key, before));
}

Task<bool> ParameterDesk::store(Progress &progress)
{
    if (std::exchange(m_flashLost, false))
        co_return fail(Fault::BadCheck, say("the device restarted before its flash was proved to be written"),
            say("read it again"));
    const Instant begun = m_contact.clock.now();
    m_flash.ask(begun);
    const Instant end = std::max(m_flash.deadline(), begun + 1s);
    bool advanced = false;
    while (m_flash.isPending()) {
        const Result<std::uint32_t> sequence = co_await m_orders.flashSequence().attempt();
        const Instant now = m_contact.clock.now();
        if (m_flashLost)
            continue; // restarted meanwhile, and so no longer pending
        if (!sequence && sequence.error().fault == Fault::LinkLost)
            co_return fail(sequence.error());
        const bool answers = sequence || sequence.error().fault == Fault::Unsupported;
        if ((sequence && m_flash.isProvedBy(*sequence, now)) || (answers && m_flash.hasRested(now)))
            break;
        advanced = advanced || (sequence && m_flash.hasAdvanced(*sequence));
        if (now >= end) {
            m_flash.giveUp();
            if (advanced || (!sequence && sequence.error().fault == Fault::Unsupported))
                co_return false;
            co_return fail(
                Fault::BadCheck, say("the device did not write its flash within %1 s", FlashProof::limit / 1s));
        }
        progress.step(say("Waiting until the device has written its flash"), static_cast<int>((now - begun) / 1s),
            static_cast<int>((end - begun) / 1s));
        co_await Sleep(m_contact.clock, sequencePollPeriod);
    }
    if (std::exchange(m_flashLost, false))
        co_return fail(Fault::BadCheck, say("the device restarted before its flash was proved to be written"),
            say("read it again"));
    m_flash.settle();
    m_known.setAllStored();
    co_return true;
}

Task<void> ParameterDesk::storeWhatWaits()
{
    const Remembered lost(m_flashLost);
    const bool isOurs
        = m_flash.isPending(); // else a change of others may wait, and a unit that does not tell keeps nobody
    NoProgress unheard;
    const Result<bool> stored = co_await store(unheard).attempt();
    if (!stored && (isOurs || stored.error().fault != Fault::BadCheck))
        co_return fail(stored.error());
    co_return {};
}

Task<std::vector<FaultRecord>> ParameterDesk::faults(bool clear)
{
    const std::int64_t active = co_await read(param::activeFaults);
    std::array<std::int64_t, 1 + faultKeys.size()> values{}; // sticky bits, then counts in the order of the bits
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto number = static_cast<std::uint8_t>(param::stickyFaults + i);
        const Parameter &row = parameterTable()[parameterWithId(number)->value];
        auto task = clear ? clearCounter(row, 1) : read(number);
        values.at(i) = co_await std::move(task);
        m_known.setRead(*parameterWithId(number), clear ? 0 : values.at(i));
    }
    m_known.setRead(*parameterWithId(param::activeFaults), active);
    std::vector<FaultRecord> records;
    for (std::size_t i = 0; i < faultKeys.size(); ++i) {
        const std::int64_t bit = std::int64_t{1} << i;
        records.push_back(
            {std::string(faultKeys.at(i)), (active & bit) != 0, (values[0] & bit) != 0, values.at(i + 1)});
    }
    co_return records;
}

} // namespace mb::dmc60c
