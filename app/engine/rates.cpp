// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/engine/rates.h"

#include "app/engine/operations.h"

#include <algorithm>
#include <utility>

namespace mb {
namespace {

/// A page that appears reads first.
constexpr Duration betweenRates = std::chrono::milliseconds(100);
constexpr Duration longestEnd = std::chrono::seconds(1);

} // namespace

void Rates::carryOut(const orders::WishRates &order, const Finished &finished)
{
    std::map<Place, double> wanted;
    for (const RateWish &wish : order.wishes) {
        if (wish.hertz <= 0.0)
            continue;
        double &hertz = wanted[{wish.device, wish.channel}];
        hertz = std::max(hertz, wish.hertz);
    }
    if (wanted.empty())
        m_wishes.erase(order.wisher);
    else
        m_wishes[order.wisher] = std::move(wanted);
    wait();
    finished({});
}

void Rates::restore(DeviceId device)
{
    std::erase_if(m_inForce, [device](const auto &one) { return one.first.first == device; });
    setNext();
}

void Rates::end(std::function<void()> done)
{
    m_wishes.clear();
    m_done = std::move(done);
    m_limit.startIn(longestEnd, [this] { finish(); });
    m_next.startIn(Duration::zero(), [this] { setNext(); });
}

void Rates::finish()
{
    m_next.stop();
    m_limit.stop();
    if (const auto done = std::exchange(m_done, {}))
        done();
}

/// Of each channel the highest.
std::map<Rates::Place, double> Rates::wished() const
{
    std::map<Place, double> most;
    for (const auto &[wisher, wishes] : m_wishes) {
        for (const auto &[place, hertz] : wishes)
            most[place] = std::max(most[place], hertz);
    }
    return most;
}

/// What is not in force yet, or perhaps not, of devices that are there.
std::map<Rates::Place, double> Rates::open() const
{
    std::map<Place, double> found = wished();
    for (const auto &[place, hertz] : m_inForce)
        found.try_emplace(place, 0.0);
    for (const Place &place : m_lost)
        found.try_emplace(place, 0.0);
    std::erase_if(found, [this](const auto &one) {
        const auto present = m_inForce.find(one.first);
        const double told = present == m_inForce.end() ? 0.0 : present->second;
        return !m_context.session.find(one.first.first) || (one.second == told && !m_lost.contains(one.first));
    });
    return found;
}

bool Rates::isFree(DeviceId id) const
{
    const Device *device = m_context.session.find(id);
    return device->liveness().heard && device->gate().busy().empty() && !m_context.operations.has(id);
}

void Rates::wait()
{
    if (!m_next.isActive())
        m_next.startIn(betweenRates, [this] { setNext(); });
}

void Rates::setNext()
{
    const auto isGone = [this](const Place &place) { return !m_context.session.find(place.first); };
    std::erase_if(m_inForce, [&](const auto &one) { return isGone(one.first); });
    std::erase_if(m_lost, isGone);
    const std::map<Place, double> waiting = open();
    if (waiting.empty() && m_done && m_underWay == 0)
        return finish();
    if (waiting.empty())
        return;
    wait();
    for (const bool faster : {true, false}) {
        const auto chosen = std::ranges::find_if(
            waiting, [&](const auto &one) { return (one.second > 0.0) == faster && isFree(one.first.first); });
        if (chosen != waiting.end())
            return set(chosen->first, chosen->second);
    }
}

void Rates::set(const Place &place, double hertz)
{
    if (hertz > 0.0)
        m_inForce[place] = hertz;
    else
        m_inForce.erase(place);
    const bool begun = m_context.operations.begin<void>(
        place.first, {say("Set telemetry rate"), OperationKind::Look},
        [channel = place.second, hertz](Device &device, Progress &) { return device.setRate(channel, hertz); },
        [this, place](const Operations::Job &job, const Result<void> &result) { ended(place, job.device, result); },
        [](const Result<void> &) {});
    if (begun)
        ++m_underWay;
}

void Rates::ended(const Place &place, DeviceId device, const Result<void> &result)
{
    const bool isLost = !result && (result.error().fault == Fault::Timeout || result.error().fault == Fault::LinkLost);
    const bool isNews = isLost ? m_lost.insert(place).second : !result;
    if (!isLost)
        m_lost.erase(place);
    if (isNews && result.error().fault != Fault::Unsupported) // then it stays as it is
        m_context.log.tell(Severity::Caution, device, say("Set telemetry rate: %1", result.error().message()));
    --m_underWay;
    if (m_done)
        setNext();
    else if (isLost)
        wait();
}

} // namespace mb
