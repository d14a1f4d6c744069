// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/supermodified/drivennodes.h"
#include "model/setpoint.h"

#include <functional>
#include <optional>
#include <utility>

namespace mb::supermodified {

/// The buffered move that one node keeps. One DoMove begins those of all nodes of a line, so each is asked before it and told of it.
class KeptMove {
public:
    struct Owner {
        std::function<Result<void>()> mayBegin;
        std::function<void(const SetPoint &)> begun;
    };

    /// The nodes outlive it.
    KeptMove(DrivenNodes &nodes, Owner owner)
        : m_owner(std::move(owner))
        , m_asked(nodes.releasing().add([this](Result<void> &allowed) {
            if (allowed)
                allowed = m_owner.mayBegin();
        }))
        , m_begun(nodes.released().add([this] {
            if (const auto begun = std::exchange(m_order, std::nullopt))
                m_owner.begun(*begun);
        }))
    {
    }

    /// The node has acknowledged it.
    void keep(const SetPoint &order) { m_order = order; }
    void reset() { m_order.reset(); }
    [[nodiscard]] const std::optional<SetPoint> &order() const { return m_order; }

private:
    Owner m_owner;
    std::optional<SetPoint> m_order;
    Subscription m_asked;
    Subscription m_begun;
};

} // namespace mb::supermodified
