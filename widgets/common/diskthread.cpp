// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/diskthread.h"

#include <QCoreApplication>
#include <QEvent>
#include <QRunnable>

#include <utility>

namespace mb {

DiskThread::DiskThread()
{
    m_pool.setMaxThreadCount(1);
}

DiskThread::~DiskThread()
{
    finish();
}

void DiskThread::finish()
{
    m_pool.waitForDone();
    QCoreApplication::sendPostedEvents(this, QEvent::MetaCall);
}

void DiskThread::order(const QString &name, Work work, Done done)
{
    const std::lock_guard lock(m_mutex);
    m_waiting[name] = {std::move(work), std::move(done)};
    m_pool.start(QRunnable::create([this, name] { carryOut(name); }));
}

void DiskThread::carryOut(const QString &name)
{
    Order order;
    {
        const std::lock_guard lock(m_mutex);
        const auto newest = m_waiting.extract(name);
        if (newest.empty())
            return; // done with an older one
        order = newest.mapped();
    }
    QMetaObject::invokeMethod(
        this, [done = std::move(order.done), result = order.work()] { done(result); }, Qt::QueuedConnection);
}

} // namespace mb
