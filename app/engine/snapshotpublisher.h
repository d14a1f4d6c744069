// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/engine/links.h"
#include "app/engine/provisionalchanges.h"

namespace mb {

/// Takes the pictures that the window shows. Engine thread.
class SnapshotPublisher {
public:
    SnapshotPublisher(const EngineContext &context, const Links &links, const ProvisionalChanges &provisional)
        : m_context(context)
        , m_links(links)
        , m_provisional(provisional)
    {
    }

    [[nodiscard]] Snapshot take() const;

private:
    EngineContext m_context;
    const Links &m_links;
    const ProvisionalChanges &m_provisional;
};

} // namespace mb
