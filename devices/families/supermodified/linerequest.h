// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "async/result.h"
#include "families/supermodified/frame.h"
#include "families/supermodified/protocol.h"

#include <functional>

namespace mb::supermodified {

/// What is to be sent on a line, and what is to come back.
struct LineRequest {
    enum class Rank : std::uint8_t { Stop, Move, Task, Poll };

    Frame frame;                    ///< `from` is filled in, unless it is not 0
    int baudrate = 0;               ///< the line changes to it before it sends
    std::size_t replySize = 0;      ///< data bytes to expect
    Duration patience = answerTime; ///< after the wire time of both frames; longer where answers are known to be late
    Rank rank = Rank::Task;
    bool answered = true;            ///< false for broadcasts
    std::function<void()> left = {}; ///< it is on the wire
    bool settles
        = false; ///< afterwards no answer to an earlier question is still to come: waits for silence where one may be
};

/// The reply, which may be an error frame; Timeout; LinkLost.
using LineReply = std::function<void(Result<Frame>)>;

} // namespace mb::supermodified
