// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/motionstop.h"

#include <utility>

namespace mb::supermodified {
namespace {

using namespace std::chrono_literals;

constexpr int hurriedStops = 20;        ///< without a pause
constexpr Duration stopPeriod = 100ms;  ///< after that
constexpr Duration stopPatience = 10ms; ///< shorter than usual: a stop may be repeated at any time

} // namespace

MotionStop::MotionStop(Line &line, const Node &node, Events events)
    : m_line(line)
    , m_node(node)
    , m_events(std::move(events))
    , m_timer(line.clock())
{
}

void MotionStop::begin()
{
    m_tries = 0;
    if (std::exchange(m_pending, true) && m_timer.isActive())
        m_timer.stop();
    send(Duration::zero());
}

void MotionStop::send(Duration delay)
{
    if (delay > Duration::zero()) {
        m_timer.startIn(delay, [this] { send(Duration::zero()); });
        return;
    }
    if (m_line.link().state() != LinkState::Open)
        return; // resume() goes on
    Line::Request request = asking(m_node, Command::Stop);
    request.rank = Line::Rank::Stop;
    request.patience = stopPatience;
    m_ticket = m_line.submit(request, [this](const Result<Frame> &reply) { answered(reply); });
}

void MotionStop::answered(const Result<Frame> &reply)
{
    if (reply && reply->is(Command::Stop)) {
        m_pending = false;
        m_acknowledgedAt = m_line.clock().now();
        m_events.acknowledged();
        return;
    }
    if (const auto codes = reply ? codesOf(*reply) : std::nullopt) {
        const std::vector<std::uint8_t> kept(codes->begin(), codes->end());
        m_events.codes(kept);
    }
    if (!reply && reply.error().fault == Fault::LinkLost)
        return;
    send(++m_tries < hurriedStops ? Duration::zero() : stopPeriod);
}

void MotionStop::resume()
{
    if (m_pending)
        send(Duration::zero());
}

} // namespace mb::supermodified
