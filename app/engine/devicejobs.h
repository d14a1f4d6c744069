// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/engine/parameterjobs.h"
#include "widgets/orders/deviceorders.h"

namespace mb {

/// What is done to one device besides moving it and writing its parameters: who and how it is. Engine thread.
class DeviceJobs {
public:
    DeviceJobs(const EngineContext &context, const ParameterJobs &parameters)
        : m_context(context)
        , m_parameters(parameters)
    {
    }

    void carryOut(const orders::Identify &order, const Finished &finished);
    void carryOut(const orders::Rename &order, const Finished &finished);
    void carryOut(const orders::Renumber &order, const Finished &finished);
    void carryOut(const orders::ClearFaults &order, const Finished &finished);
    void carryOut(const orders::Calibrate &order, const Finished &finished);
    void carryOut(const orders::SetDialect &order, const Finished &finished);

private:
    EngineContext m_context;
    const ParameterJobs &m_parameters;
};

} // namespace mb
