// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/engine/servicejobs.h"

#include <utility>

namespace mb {

/// Tells somebody what becomes of the units that are served, and where their journal goes. Engine thread, where it also calls.
class ServiceFeed {
public:
    using Ended = std::function<void(const service::Visit &)>;
    using Chosen = std::function<void(const JournalPlace &, const orders::KeepJournal &)>;

    ServiceFeed(ServiceJobs &service, Ended ended, Chosen chosen)
        : m_service(service)
        , m_changed(service.changed().add([this] { m_isNew = true; }))
        , m_unitEnded(service.unitEnded().add(std::move(ended)))
        , m_journalChosen(service.journalChosen().add(std::move(chosen)))
    {
    }
    /// The view, where it is another than it was the last time.
    [[nodiscard]] std::optional<ServiceView> news()
    {
        return std::exchange(m_isNew, false) ? std::optional(m_service.view()) : std::nullopt;
    }

private:
    ServiceJobs &m_service;
    bool m_isNew = false;
    Subscription m_changed;
    Subscription m_unitEnded;
    Subscription m_journalChosen;
};

} // namespace mb
