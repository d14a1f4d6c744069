// SPDX-License-Identifier: GPL-3.0-or-later
#include "service/servicesurroundings.h"

#include "experiment/interruption.h"

namespace mb::service {

void MotionPermit::takeBack()
{
    const auto turning = m_turning; // each that ends leaves the list
    for (tuning::Interruption *const one : turning)
        one->interrupt();
}

PermittedMotion::PermittedMotion(MotionPermit &permit, tuning::Interruption *interruption)
    : m_permit(permit)
    , m_interruption(interruption)
{
    if (interruption)
        permit.m_turning.push_back(interruption);
}

PermittedMotion::~PermittedMotion()
{
    std::erase(m_permit.m_turning, m_interruption);
}

} // namespace mb::service
