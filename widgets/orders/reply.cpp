// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/orders/reply.h"

#include <QtGlobal>

#include <utility>

namespace mb {

struct Reply::Owed {
    explicit Owed(Finished whom)
        : finished(std::move(whom))
    {
    }
    Owed(const Owed &) = delete;
    Owed &operator=(const Owed &) = delete;
    ~Owed() { give(fail(Fault::Cancelled, say("the order was dropped: what it was for has ended"))); }

    void give(Result<Answer> answer)
    {
        if (const Finished whom = std::exchange(finished, {}))
            whom(std::move(answer));
    }

    Finished finished;
};

Reply::Reply(Finished finished)
    : m_owed(finished ? std::make_shared<Owed>(std::move(finished)) : nullptr)
{
}

void Reply::give(Result<Answer> answer) const
{
    if (m_owed)
        m_owed->give(std::move(answer));
}

} // namespace mb
