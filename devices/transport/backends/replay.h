// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "transport/canlink.h"
#include "transport/pacedclock.h"
#include "transport/recordingfile.h"

namespace mb {

/// Where a replay stands. All from the first frame of the recording on.
struct ReplayState {
    Duration start{}; ///< of the first frame, since 1970, or since whatever the recording counts from
    Duration position{};
    Duration length{};   ///< as far as the file has been looked through
    double surveyed = 0; ///< fraction of the file that has been looked through
    double pace = 1.0;   ///< 0: as fast as possible
    bool running = false;
    bool ended = false;

    friend bool operator==(const ReplayState &, const ReplayState &) = default;
};

/// What to do with a replay; what is not set stays as it is.
struct ReplayOrder {
    std::optional<double> pace;       ///< 0: as fast as possible
    std::optional<Duration> position; ///< from the first frame on
    std::optional<bool> run;
};

namespace detail {

/// Made before the link that is built on it.
struct ReplayTime {
    explicit ReplayTime(Clock &real)
        : outer(real)
        , time(real)
    {
    }
    Clock &outer;
    PacedClock time;
};

} // namespace detail

/// A recording (RecordingFile) as a link: `replay:FILE`, options `speed` (0.01…1000, `max`: as fast as possible)
/// and `interface` (only frames of this one). It opens standing at its first frame; who has found the devices in it, by
/// survey(), lets it play().
///
/// Frames carry the recording's time stamps, on the line of timeLine(): whoever follows the link must live on that
/// clock, where time stands while the replay stands. Nothing can be sent: send() fails with Unsupported. Frames
/// that the recorder had sent itself are seen by traffic(), not by received(), as in the original. A file that is cut
/// while it is played loses the link.
class ReplayLink final : private detail::ReplayTime, public CanLink {
public:
    static constexpr double slowest = 0.01;
    static constexpr double fastest = 1000.0;

    /// OutOfRange for an option that is not known or does not parse.
    [[nodiscard]] static Result<std::unique_ptr<ReplayLink>> create(const LinkAddress &address, Clock &clock);

    [[nodiscard]] Clock &timeLine() { return time; }
    [[nodiscard]] ReplayState replay() const;

    /// From where it stands; does nothing at the end.
    void play();
    void pause();
    /// 0, or slowest…fastest; anything else is OutOfRange.
    [[nodiscard]] Result<void> setPace(double pace);
    /// To the first frame at or after `position`; clipped to what survey() has seen. Those who follow the link must be
    /// made anew: time may go back.
    [[nodiscard]] Result<void> seek(Duration position);
    /// See RecordingFile::survey().
    [[nodiscard]] Result<bool> survey(const std::function<void(const LoggedFrame &)> &seen);
    /// What survey() has seen that is left out, or may not be whole, for people; empty: nothing.
    [[nodiscard]] Message remark() const { return m_file ? m_file->remark() : Message(); }

    /// The last frame has been delivered; time stands.
    [[nodiscard]] Listeners<> &ended() { return m_ended; }

private:
    ReplayLink(const LinkAddress &address, Clock &clock, double pace, std::string interface);
    Result<void> doOpen() override;
    Task<void> doOpenSoon(Background &background) override;
    void take(std::unique_ptr<RecordingFile> file);
    void doClose() override;
    Result<void> doSend(const CanFrame &frame, Priority priority) override;
    [[nodiscard]] std::size_t doBacklog() const override { return 0; }
    [[nodiscard]] int doBitrate() const override { return 0; }
    void armNext();
    void readOn();
    void deliverNext();
    void tellEnd();
    [[nodiscard]] Instant instantOf(Duration recorded) const { return Instant(recorded - time.unixOffset()); }

    double m_pace;
    std::string m_interface;
    std::unique_ptr<RecordingFile> m_file;
    std::optional<LoggedFrame> m_next;
    bool m_atEnd = false;
    bool m_goesOn = false; ///< time stands while it is read on, and then runs
    Timer m_timer;
    Timer m_read; ///< the next piece, of a file in which nothing wanted comes for long
    Listeners<> m_ended;
};

} // namespace mb
