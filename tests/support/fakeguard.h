// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/motionguard.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace mb::test {

/// A guardian without a process: the test says when it stands, acts or dies, and reads what it was told.
class FakeGuard final : public MotionGuard {
public:
    Result<std::unique_ptr<GuardWatch>> watch(Link &, const StopScript &script, const std::string &name) override
    {
        if (!refusal.empty())
            return fail(Fault::Unsafe, Message::verbatim(refusal));
        ++calls;
        lastScript = script;
        lastName = name;
        auto watch = std::make_unique<Watch>(*this);
        present = watch.get();
        if (standsAtOnce)
            present->become(GuardWatch::State::Standing);
        return watch;
    }
    bool own(Link &) override
    {
        ++asked;
        return !isWithOthers;
    }
    [[nodiscard]] std::vector<OwedStop> owed(Instant) const override { return book; }
    bool owe(const OwedStop &stop, Instant) override
    {
        settle(stop.line, stop.device);
        book.push_back(stop);
        return true;
    }
    void settle(const std::string &line, const std::string &device) override
    {
        settled.push_back(line + ' ' + device);
        std::erase_if(book, [&](const OwedStop &one) { return one.line == line && one.device == device; });
    }
    void leave(const std::string &line) override { left.push_back(line); }
    void become(GuardWatch::State state, std::string reason = {})
    {
        ASSERT_NE(present, nullptr);
        present->become(state, std::move(reason));
    }
    [[nodiscard]] bool isWatching() const { return present != nullptr; }

    bool standsAtOnce = true;
    std::string refusal; ///< of watch(); empty: it succeeds
    int calls = 0;
    int renewals = 0;
    int released = 0;
    int abandoned = 0; ///< destroyed without release(): the motor would be stopped
    StopScript lastScript;
    std::string lastName;
    int asked = 0;                    ///< for a line
    bool isWithOthers = false;        ///< somebody else has every line
    std::vector<OwedStop> book;       ///< of every line
    std::vector<std::string> settled; ///< "line device"
    std::vector<std::string> left;    ///< lines

private:
    class Watch final : public GuardWatch {
    public:
        explicit Watch(FakeGuard &guard)
            : m_guard(guard)
        {
        }
        ~Watch() override
        {
            m_guard.abandoned += m_released ? 0 : 1;
            m_guard.present = nullptr;
        }
        void renew() override { ++m_guard.renewals; }
        void release() override
        {
            m_released = true;
            ++m_guard.released;
        }
        void become(State state, std::string reason = {}) { enter(state, Message::verbatim(std::move(reason))); }

    private:
        FakeGuard &m_guard;
        bool m_released = false;
    };

    Watch *present = nullptr;
};

} // namespace mb::test
