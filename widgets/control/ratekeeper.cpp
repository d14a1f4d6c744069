// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/ratekeeper.h"

#include <algorithm>

namespace mb {
namespace {

/// Longer than a snapshot takes to tell of an operation that began.
constexpr std::chrono::milliseconds betweenRequests{100};

} // namespace

RateKeeper::RateKeeper(Workbench &workbench, std::vector<Wish> wishes, QObject *parent)
    : QObject(parent)
    , m_workbench(workbench)
    , m_wishes(std::move(wishes))
{
    m_timer.setInterval(betweenRequests);
    connect(&m_timer, &QTimer::timeout, this, &RateKeeper::sendNext);
}

void RateKeeper::follow(DeviceId device)
{
    if (device == m_device)
        return;
    queue(m_device, false);
    m_device = device;
    queue(m_device, true);
    if (m_requests.empty() || m_timer.isActive())
        return;
    m_timer.start();
    sendNext();
}

void RateKeeper::queue(DeviceId device, bool fast)
{
    const DeviceView *view = m_workbench.snapshot().device(device);
    if (!view)
        return;
    for (const Wish &wish : m_wishes) {
        const auto channel = findChannel(view->family->channels, wish.channel);
        if (!channel)
            continue;
        const auto old = std::find_if(m_requests.begin(), m_requests.end(),
            [&](const Request &r) { return r.device == device && r.channel == *channel; });
        const double hertz = fast ? wish.hertz : 0.0;
        if (old != m_requests.end())
            old->hertz = hertz;
        else
            m_requests.push_back({device, *channel, hertz});
    }
}

void RateKeeper::sendNext()
{
    if (m_requests.empty()) {
        m_timer.stop();
        return;
    }
    const Request next = m_requests.front();
    const DeviceView *view = m_workbench.snapshot().device(next.device);
    const OperationView *operation = m_workbench.snapshot().operation(next.device);
    const bool busy
        = view && (!view->busy.empty() || (operation && operation->status.state == OperationStatus::State::Running));
    if (busy)
        return;
    m_requests.pop_front();
    if (view && view->liveness.heard)
        m_workbench.setRate(next.device, next.channel, next.hertz);
}

} // namespace mb
