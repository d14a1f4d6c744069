// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/servicedoor.h"

#include "app/engine/serviceroom.h"

#include <QPointer>

namespace mb {

ServiceDoor::ServiceDoor(Engine &engine)
    : ServiceDesk(&engine)
    , m_engine(engine)
{
    engine.followService(
        [self = QPointer<ServiceDoor>(this)](const ServiceView &view) {
            if (!self)
                return;
            self->m_view = view;
            Q_EMIT self->changed();
        },
        [self = QPointer<ServiceDoor>(this)](const service::Visit &visit) {
            if (self)
                Q_EMIT self->unitEnded(visit);
        });
}

void ServiceDoor::begin(const Plan &plan, Finished finished)
{
    m_engine.askService([plan](ServiceRoom &room) { return room.begin(plan); }, std::move(finished));
}

void ServiceDoor::pause(bool on)
{
    m_engine.askService([on](ServiceRoom &room) -> Result<void> { return room.pause(on), Result<void>(); }, {});
}

void ServiceDoor::skip(std::uint32_t row)
{
    m_engine.askService([row](ServiceRoom &room) -> Result<void> { return room.skip(row), Result<void>(); }, {});
}

void ServiceDoor::retry(std::uint32_t row)
{
    m_engine.askService([row](ServiceRoom &room) -> Result<void> { return room.retry(row), Result<void>(); }, {});
}

void ServiceDoor::finish()
{
    m_engine.askService([](ServiceRoom &room) -> Result<void> { return room.finish(), Result<void>(); }, {});
}

void ServiceDoor::arm(bool on)
{
    m_engine.askService([on](ServiceRoom &room) -> Result<void> { return room.arm(on), Result<void>(); }, {});
}

void ServiceDoor::renew()
{
    m_engine.askService([](ServiceRoom &room) -> Result<void> { return room.renew(), Result<void>(); }, {});
}

} // namespace mb
