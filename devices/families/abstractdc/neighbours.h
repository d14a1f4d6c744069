// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/abstractdc/questionbook.h"
#include "transport/canlink.h"

#include <optional>

namespace mb::abstractdc {

/// Whether drives with offsets other than 0 answer on a link, whoever asks them: what is sent to offset 0 reaches them, too
/// (README.md#offsets). Offset 0 itself, in any dialect, never counts. Engine thread.
class Neighbours {
public:
    Neighbours(CanLink &link, Clock &clock);

    /// One answered within the last seconds.
    [[nodiscard]] bool areHeard() const;

private:
    void pass(const CanFrame &frame);

    CanLink &m_link;
    Clock &m_clock;
    QuestionBook m_book; ///< none is closed by its first answer: all drives answer what offset 0 is asked
    std::optional<Instant> m_heardAt;
    Subscription m_traffic;
};

} // namespace mb::abstractdc
