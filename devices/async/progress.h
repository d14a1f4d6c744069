// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/message.h"

#include <cstdint>
#include <functional>
#include <string>
#include <utility>

namespace mb {

enum class Severity { Info, Good, Caution, Danger };

/// State of one numbered part of a long job, such as a flash page.
enum class PartState : std::uint8_t { Waiting, Active, Done, Repeated, Absent };

/// Where a long job reports; outlives the job's task. All calls on the job's thread.
class Progress {
public:
    virtual ~Progress() = default;
    /// What it does now, and how far: `total` 0 means unknown length.
    virtual void step(const Message &what, int done, int total) = 0;
    virtual void part(int number, PartState state) = 0;
    virtual void log(Severity severity, const Message &text) = 0;
    /// While false, the job must not be cut (page 0 of a DMC60C).
    virtual void mayInterrupt(bool) { }
    /// Of an update, as soon as each is known, so that it can be told whatever ends the job: the version before, and how many
    /// parts the device has accepted, with how many were sent again.
    virtual void replaces(const std::string &) { }
    virtual void accepted(int, int) { }
};

/// For callers that do not look.
class NoProgress : public Progress {
public:
    void step(const Message &, int, int) override { }
    void part(int, PartState) override { }
    void log(Severity, const Message &) override { }
};

/// For callers to whom it is lines for people: what it warns of, and what it does now where they follow that.
class ProgressLines final : public NoProgress {
public:
    using Tell = std::function<void(const Message &)>;
    explicit ProgressLines(Tell warn, Tell tellStep = {})
        : m_warn(std::move(warn))
        , m_tellStep(std::move(tellStep))
    {
    }
    void step(const Message &what, int, int) override
    {
        if (m_tellStep)
            m_tellStep(what);
    }
    void log(Severity severity, const Message &text) override
    {
        if (severity != Severity::Info)
            m_warn(text);
    }

private:
    Tell m_warn;
    Tell m_tellStep;
};

} // namespace mb
