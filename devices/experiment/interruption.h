// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"
#include "model/setpointstream.h"

#include <utility>

namespace mb::tuning {

/// How the user ends what moves a motor: it stops in this call, and from then on no stream is started and no gain written for whoever
/// is Interruptible by it, who finds out by that.
class Interruption {
public:
    void interrupt()
    {
        m_isRequested = true;
        if (m_stream && m_stream->isRunning())
            m_stream->stop();
    }
    [[nodiscard]] bool isRequested() const { return m_isRequested; }
    /// A story is under way that ends by it, and puts back what it has changed.
    [[nodiscard]] bool hasStory() const { return m_stream; }

private:
    friend class Interruptible;

    SetPointStream *m_stream = nullptr; ///< of the story that may be interrupted now
    bool m_isRequested = false;
};

/// A story that moves the motor by this stream, from its construction to its destruction; one in the other where a tuning makes
/// experiments. Interruption and stream outlive it.
class Interruptible : NonCopyable {
public:
    /// nullptr: nobody can interrupt.
    Interruptible(Interruption *interruption, SetPointStream &stream)
        : m_interruption(interruption)
    {
        if (!m_interruption)
            return;
        m_outer = std::exchange(m_interruption->m_stream, &stream);
        stream.setCalledOff(&m_interruption->m_isRequested);
    }
    ~Interruptible()
    {
        if (!m_interruption)
            return;
        if (!m_outer)
            m_interruption->m_stream->setCalledOff(nullptr);
        m_interruption->m_stream = m_outer;
    }

    [[nodiscard]] bool isRequested() const { return m_interruption && m_interruption->isRequested(); }
    /// Before what no stream does: a gain that is tried or kept, an order that gives the motor a current. Cancelled once it was
    /// requested, as a stream's start is.
    [[nodiscard]] Result<void> mayGoOn() const
    {
        return isRequested() ? fail(Fault::Cancelled, say("the user stopped it")) : Result<void>();
    }

private:
    Interruption *m_interruption;
    SetPointStream *m_outer = nullptr;
};

} // namespace mb::tuning
