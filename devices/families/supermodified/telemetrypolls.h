// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"
#include "families/supermodified/node.h"
#include "families/supermodified/velocityestimate.h"
#include "telemetry/framerate.h"
#include "telemetry/telemetry.h"

#include <vector>

namespace mb::supermodified {

/// The questions whose answers become the telemetry of one node. Each channel is asked for at its own rate: slowly by itself,
/// faster while the motor is driven, and as fast as somebody wishes (a page that shows it, `watch --rate`); the line shares
/// itself out where all of it is too much. A silent node is asked for its position only, twice a second.
class TelemetryPolls : NonCopyable {
public:
    struct Events {
        std::function<void(const Result<Frame> &)> answered; ///< every answer, error frames and time-outs too
        std::function<void(std::int64_t)> positioned;        ///< a position of the node, before its origin is added
        std::function<void(std::uint8_t)> inputs;            ///< levels of the digital inputs, DIO1 in bit 0
    };

    TelemetryPolls(Line &line, const Node &node, Telemetry &telemetry, Events events);
    ~TelemetryPolls();

    /// Samples per second wished for; 0: as by itself. False for a channel that does not come from the node.
    bool setRate(ChannelIndex channel, double hertz);
    void setDriven(bool driven);
    /// The position in the turn is asked for only while the node cannot be started: the question may hang it (README.md#hang).
    void setKnownOff(bool off);
    /// A silent node leaves the line to the others.
    void setHeard(bool heard);
    /// While an update runs nothing is asked.
    void setPaused(bool paused);
    /// What to add to the node's position.
    void setOrigin(std::int64_t origin) { m_origin = origin; }
    /// The node counts from 0: positions begin a new line there.
    void zeroed();
    /// Ampere per count of D1 and D2; 0: raw counts.
    void setCurrentScale(double scale) { m_currentScale = scale; }
    /// The dialect, the rate or the id of the node is another one.
    void nodeChanged();
    /// Takes a position that was read otherwise.
    void takePosition(const Frame &reply);
    [[nodiscard]] bool isTurning() const { return m_velocity.isTurning(); }

private:
    struct Poll {
        Command command{};
        ChannelIndex first{};
        int channels = 1;
        double idle = 0.0;   ///< Hz
        double driven = 0.0; ///< Hz, while the motor is driven
        FrameRate wishes{};
        LinePolls::Key key = 0;
        bool refused = false; ///< the last answer was an error
    };
    void answered(std::size_t index, const Result<Frame> &reply);
    void take(const Poll &poll, const Frame &reply);
    void append(ChannelIndex channel, double value);
    void interrupt();
    void apply();
    [[nodiscard]] Duration periodOf(const Poll &poll) const;

    Line &m_line;
    const Node &m_node;
    Telemetry &m_telemetry;
    Events m_events;
    std::vector<Poll> m_polls;
    VelocityEstimate m_velocity;
    std::int64_t m_origin = 0;
    double m_currentScale = 0.0;
    bool m_driven = false;
    bool m_knownOff = false;
    bool m_heard = false;
    bool m_paused = false;
};

} // namespace mb::supermodified
