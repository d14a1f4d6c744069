// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/engine/links.h"
#include "app/engine/provisionalchanges.h"

namespace mb {

/// A picture as it differs from the one before: what grows long and seldom changes is only there when it has changed.
struct SnapshotChanges {
    Snapshot snapshot;                   ///< its operations are those that have changed
    std::vector<OperationId> operations; ///< all that there are, oldest first
};

/// The whole picture again. Every change is taken once, in order.
[[nodiscard]] Snapshot merged(Snapshot before, SnapshotChanges changes);

/// Takes the pictures that the window shows. Engine thread.
class SnapshotPublisher {
public:
    SnapshotPublisher(const EngineContext &context, const Links &links, const ProvisionalChanges &provisional)
        : m_context(context)
        , m_links(links)
        , m_provisional(provisional)
    {
    }

    /// All of it.
    [[nodiscard]] Snapshot take() const;
    /// The same since changes() was called last, or since the beginning: logs of operations are not copied again and again.
    [[nodiscard]] SnapshotChanges changes();

private:
    [[nodiscard]] Snapshot withoutOperations() const;

    EngineContext m_context;
    const Links &m_links;
    const ProvisionalChanges &m_provisional;
    std::map<OperationId, std::uint64_t> m_shown; ///< revisions of operations
};

} // namespace mb
