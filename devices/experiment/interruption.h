// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/setpointstream.h"

namespace mb::tuning {

/// How the user ends an experiment: the motor stops in this call, the story finds out at its next step.
class Interruption {
public:
    void interrupt()
    {
        m_isRequested = true;
        if (m_stream && m_stream->isRunning())
            m_stream->stop();
    }
    [[nodiscard]] bool isRequested() const { return m_isRequested; }
    /// For the story: what to stop; nullptr when it is over.
    void setStream(SetPointStream *stream) { m_stream = stream; }

private:
    SetPointStream *m_stream = nullptr;
    bool m_isRequested = false;
};

} // namespace mb::tuning
