// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/answersagain.h"

#include "async/sleep.h"
#include "model/family.h"

namespace mb {
namespace {

using namespace std::chrono_literals;

constexpr Duration answerEvery = 500ms;
constexpr int answerTries = 10;

/// As a scan does: nothing is known of one that was silent.
Task<void> lookFor(Device &device)
{
    struct Finding final : ScanSink {
        explicit Finding(Device &sought)
            : device(sought)
        {
        }
        void found(const Identity &identity) override
        {
            if (identity.address != device.identity().address)
                return;
            device.setIdentity(identity);
            any = true;
        }
        void progress(const Message &, int, int) override { }
        Device &device;
        bool any = false;
    };
    Finding finding(device);
    const Family &family = device.family();
    auto looking = family.probe ? family.probe(device.link(), device.clock(), device.identity().address, finding)
                                : family.scan(device.link(), device.clock(), finding);
    co_await std::move(looking);
    co_return finding.any ? Result<void>() : fail(Fault::Timeout, say("%1 does not answer", device.selector()));
}

} // namespace

Task<bool> answersAgain(Device &device)
{
    for (int attempt = 0; attempt < answerTries; ++attempt) {
        co_await Sleep(device.clock(), answerEvery);
        const bool wasSilent = device.identity().state == DeviceState::Bootloader;
        auto asking = wasSilent ? lookFor(device) : device.refresh();
        const Result<void> answer = co_await std::move(asking).attempt();
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
