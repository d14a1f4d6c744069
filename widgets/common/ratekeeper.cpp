// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/ratekeeper.h"

#include <algorithm>

namespace mb {
namespace {

/// Longer than a snapshot takes to tell of an operation that began.
constexpr std::chrono::milliseconds betweenRequests{100};

} // namespace

RateKeeper &RateKeeper::of(Workbench &workbench)
{
    if (auto *known = workbench.findChild<RateKeeper *>(QString(), Qt::FindDirectChildrenOnly))
        return *known;
    return *new RateKeeper(workbench);
}

RateKeeper::RateKeeper(Workbench &workbench)
    : QObject(&workbench)
    , m_workbench(workbench)
{
    m_timer.setInterval(betweenRequests);
    connect(&m_timer, &QTimer::timeout, this, &RateKeeper::sendNext);
}

void RateKeeper::wish(const QObject *page, const std::vector<Wish> &wishes)
{
    std::map<Place, double> wanted;
    for (const Wish &one : wishes) {
        double &hertz = wanted[{one.device, one.channel}];
        hertz = std::max(hertz, one.hertz);
    }
    const auto known = m_wishes.find(page);
    if (known == m_wishes.end() ? wanted.empty() : known->second == wanted)
        return;
    if (known == m_wishes.end())
        connect(page, &QObject::destroyed, this, [this, page] {
            wish(page, {});
            m_wishes.erase(page);
        });
    m_wishes[page] = std::move(wanted);
    if (!m_timer.isActive()) // a page that appears reads first, and a snapshot tells of it
        m_timer.start();
}

double RateKeeper::wished(const Place &place) const
{
    double most = 0.0;
    for (const auto &[page, wishes] : m_wishes) {
        if (const auto one = wishes.find(place); one != wishes.end())
            most = std::max(most, one->second);
    }
    return most;
}

bool RateKeeper::isFreeNow(DeviceId device) const
{
    const DeviceView *view = m_workbench.snapshot().device(device);
    const OperationView *operation = m_workbench.snapshot().operation(device);
    return view && view->liveness.heard && view->busy.empty()
        && !(operation && operation->status.state == OperationStatus::State::Running);
}

/// What somebody waits to see comes first.
void RateKeeper::sendNext()
{
    std::map<Place, double> open;
    for (const auto &[place, hertz] : m_sent) {
        if (m_workbench.snapshot().device(place.first) && wished(place) != hertz)
            open[place] = wished(place);
    }
    for (const auto &[page, wishes] : m_wishes) {
        for (const auto &[place, hertz] : wishes) {
            if (m_sent.count(place) == 0 && m_workbench.snapshot().device(place.first))
                open[place] = wished(place);
        }
    }
    if (open.empty()) {
        m_timer.stop();
        return;
    }
    const auto next = [&](bool faster) {
        return std::find_if(open.begin(), open.end(),
            [&](const auto &one) { return (one.second > 0.0) == faster && isFreeNow(one.first.first); });
    };
    auto chosen = next(true);
    if (chosen == open.end())
        chosen = next(false);
    if (chosen == open.end())
        return;
    const auto [place, hertz] = *chosen;
    if (hertz > 0.0)
        m_sent[place] = hertz;
    else
        m_sent.erase(place);
    m_workbench.send(orders::SetRate{place.first, place.second, hertz});
}

} // namespace mb
