// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/engine/servicejobs.h"

namespace mb {

/// Tells somebody what became of the units that are served. Engine thread, where it also calls.
class ServiceFeed {
public:
    using Viewed = std::function<void(const ServiceView &)>;
    using Ended = std::function<void(const service::Visit &)>;

    explicit ServiceFeed(ServiceJobs &service)
        : m_service(service)
        , m_changed(service.changed().add([this] { m_isNew = true; }))
        , m_unitEnded(service.unitEnded().add([this](const service::Visit &visit) {
            if (m_ended)
                m_ended(visit);
        }))
    {
    }
    void follow(Viewed viewed, Ended ended)
    {
        m_viewed = std::move(viewed);
        m_ended = std::move(ended);
    }
    /// The view, where it is another than it was told last.
    void tell()
    {
        if (m_viewed && std::exchange(m_isNew, false))
            m_viewed(m_service.view());
    }

private:
    ServiceJobs &m_service;
    bool m_isNew = false;
    Viewed m_viewed;
    Ended m_ended;
    Subscription m_changed;
    Subscription m_unitEnded;
};

} // namespace mb
