// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/stopthread.h"

#include "transport/qtclock.h"

#include <QSocketNotifier>

#include <algorithm>

namespace mb {

StopThread::StopThread()
{
    setObjectName(QStringLiteral("stop"));
    start(QThread::TimeCriticalPriority);
}

StopThread::~StopThread()
{
    m_orders.post([] { QThread::currentThread()->exit(); });
    wait();
}

void StopThread::run()
{
    QtClock clock;
    StopLane lane(clock);
    m_lane = &lane;
    QSocketNotifier arrivals(m_orders.descriptor(), QSocketNotifier::Read);
    connect(&arrivals, &QSocketNotifier::activated, &arrivals, [this] { m_orders.drain(); });
    exec();
    m_orders.close();
}

void StopThread::press(StopCause cause)
{
    m_pressed = true;
    m_orders.postUrgent([this, cause] { m_lane->press(cause); });
}

void StopThread::served()
{
    m_pressed = false;
    m_orders.post([this] { m_lane->served(); });
}

void StopThread::follow(const Session &session)
{
    std::vector<StopOrders> now = stopOrdersOf(session, m_known);
    const bool same = now.size() == m_known.size()
        && std::equal(now.begin(), now.end(), m_known.begin(), [](const StopOrders &a, const StopOrders &b) {
               return a.outlet == b.outlet && a.scripts == b.scripts && a.own == b.own;
           });
    if (same)
        return;
    m_known = std::move(now);
    m_orders.post([this, orders = m_known] { m_lane->setOrders(orders); });
}

} // namespace mb
