// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/engine/rates.h"

namespace mb {
namespace {

constexpr Duration ratesAgain = std::chrono::milliseconds(100);

} // namespace

Rates::Rates(const EngineContext &context)
    : m_context(context)
    , m_again(context.clock)
{
}

void Rates::carryOut(const orders::SetRate &order, const Finished &finished)
{
    const Place place{order.device, order.channel};
    m_wished[place] = order.hertz;
    set(place, order.hertz, finished);
}

void Rates::set(const Place &place, double hertz, const Finished &finished)
{
    if (m_context.operations.has(place.first)) { // it began after the window had seen that the device is free
        Waiting &waiting = m_waiting[place];
        waiting.hertz = hertz;
        waiting.finished.push_back(finished);
        m_again.startIn(ratesAgain, [this] { setWaiting(); });
        return;
    }
    m_context.operations.begin<void>(
        place.first, say("Set telemetry rate"),
        [channel = place.second, hertz](Device &device, Progress &) { return device.setRate(channel, hertz); },
        [this, id = place.first, finished](Operations::Job &, const Result<void> &result) {
            if (!result && result.error().fault != Fault::Unsupported) // then it stays as it is
                m_context.log.tell(Severity::Caution, id, say("Set telemetry rate: %1", result.error().message()));
            finished(result);
        },
        finished);
}

void Rates::setWaiting()
{
    for (const auto &[place, waiting] : std::exchange(m_waiting, {})) {
        set(place, waiting.hertz, [all = waiting.finished](const Result<void> &result) {
            for (const Finished &finished : all)
                finished(result);
        });
    }
}

void Rates::restore(DeviceId device)
{
    for (const auto &[place, hertz] : std::map(m_wished)) {
        if (place.first == device && hertz > 0.0)
            set(place, hertz, [](const Result<void> &) {});
    }
}

} // namespace mb
