// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/answersagain.h"

#include "async/sleep.h"

namespace mb {
namespace {

using namespace std::chrono_literals;

constexpr Duration answerEvery = 500ms;
constexpr int answerTries = 10;

} // namespace

Task<bool> answersAgain(Device &device)
{
    for (int attempt = 0; attempt < answerTries; ++attempt) {
        co_await Sleep(device.clock(), answerEvery);
        const Result<void> answer = co_await device.refresh().attempt();
        if (answer)
            co_return true;
        if (answer.error().fault == Fault::LinkLost)
            co_return fail(answer.error());
    }
    co_return false;
}

Error anotherUnit(const Device &device)
{
    return {Fault::BadCheck, say("the programmer wrote another unit: %1 answered all the while", device.selector()),
        say("put the programmer on it, and look at the other one")};
}

void HeldDevice::hold(std::function<void()> silent)
{
    m_asking.spawn<void>(m_device.refresh(), [this, silent = std::move(silent)](const Result<void> &answer) {
        m_hasAnswered = answer.has_value();
        if (!answer)
            silent();
    });
}

} // namespace mb
