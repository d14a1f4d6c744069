// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/engine/operations.h"
#include "widgets/orders/motionorders.h"

#include <map>
#include <set>

namespace mb {

/// What turns motors and what stops them: set-point streams, and what becomes of every stop. Engine thread.
class Motion {
public:
    /// `guard` watches over motors without a watchdog, and outlives this; may be nullptr.
    Motion(const EngineContext &context, MotionGuard *guard);

    /// Every motor, at once.
    void stopAll(StopCause cause);
    /// The devices of this link are about to go, or to begin anew.
    void forget(const Link &link);

    void carryOut(const orders::StartMotion &order, const Finished &finished);
    void carryOut(const orders::UpdateMotion &order, const Finished &finished);
    void carryOut(const orders::RenewMotion &order, const Finished &finished);
    void carryOut(const orders::StopMotion &order, const Finished &finished);
    void carryOut(const orders::ReleaseMoves &order, const Finished &finished);
    void carryOut(const orders::ZeroPosition &order, const Finished &finished);
    void carryOut(const orders::DismissStops &order, const Finished &finished);

private:
    [[nodiscard]] Result<Device *> freeDevice(DeviceId device) const;
    void streamChanged(DeviceId device);
    void followStop(Device &device);
    void guardianActed(const std::string &name, MotionGuard::Verdict verdict);

    EngineContext m_context;
    std::map<DeviceId, Subscription> m_streams;
    std::set<DeviceId> m_mayTurn; ///< told so
    Subscription m_stopChanged;
    Subscription m_guardianActed;
};

} // namespace mb
