// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/framedecoder.h"

#include <optional>

namespace mb {

/// A record as a filter looks at it: decoded at most once, and only when a term asks.
class FrameFacts {
public:
    /// `asked`: whom it is from, where it does not tell (FrameFollower).
    /// `said`: the packet that bytes complete.
    FrameFacts(const TrafficRecord &record, const FrameDecoder &decoder, std::optional<int> asked = {},
        const FrameMeaning *said = nullptr)
        : m_record(record)
        , m_decoder(decoder)
        , m_asked(asked)
        , m_said(said)
    {
    }
    [[nodiscard]] const TrafficRecord &record() const { return m_record; }
    /// nullptr when nobody knows it.
    [[nodiscard]] const FrameMeaning *meaning() const;

private:
    const TrafficRecord &m_record;
    const FrameDecoder &m_decoder;
    std::optional<int> m_asked;
    const FrameMeaning *m_said = nullptr;
    mutable bool m_looked = false;
    mutable std::optional<FrameMeaning> m_meaning;
};

} // namespace mb
