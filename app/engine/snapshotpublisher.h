// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/engine/links.h"

namespace mb {

/// Takes the pictures that the window shows. Engine thread.
class SnapshotPublisher {
public:
    SnapshotPublisher(const EngineContext &context, const Links &links)
        : m_context(context)
        , m_links(links)
    {
    }

    [[nodiscard]] Snapshot take() const;

private:
    EngineContext m_context;
    const Links &m_links;
};

} // namespace mb
