// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/engine/motion.h"
#include "model/unknownframes.h"
#include "traffic/trafficlog.h"
#include "traffic/trafficrecorder.h"
#include "widgets/orders/recordingorders.h"

#include <map>
#include <memory>
#include <string>

namespace mb {

/// What passes the links: the log of each, recordings into files, and recordings that are played. Engine thread.
class Recordings {
public:
    Recordings(const EngineContext &context, Motion &motion);
    /// Ends what is being written.
    ~Recordings();

    /// From now on files are made there. Outlives this.
    void setBackground(Background *background) { m_background = background; }
    /// A link has been opened. From now on its traffic is kept.
    void follow(Link &link);
    /// A link is about to go.
    void forget(Link &link);
    /// The devices of a recording are known: the first time, it is let go.
    void playWhenKnown(Link &link);
    /// Its part of what is shown of a link.
    void describe(const Link &link, LinkView &view) const;

    void carryOut(const orders::StartRecording &order, const Finished &finished);
    void carryOut(const orders::StopRecording &order, const Finished &finished);
    void carryOut(const orders::SteerReplay &order, const Finished &finished);

private:
    struct Kept {
        bool played = false; ///< a recording, let go for the first time
        std::shared_ptr<TrafficLog> traffic;
        std::unique_ptr<TrafficRecorder> recorder;
        Subscription recorderChanged;
        bool toldOfEnd = false;
        std::unique_ptr<UnknownFrames> unknown;
        Subscription tap;
    };

    void keepTraffic(Link &link);
    [[nodiscard]] Link *linkUnder(const std::string &address) const;
    [[nodiscard]] Result<void> mayRecord(const std::string &link) const;
    [[nodiscard]] Task<void> record(std::string link, std::string path);
    [[nodiscard]] Task<std::unique_ptr<BackgroundFile>> makeFile(std::string path);
    void recorderChanged(Link &link);
    [[nodiscard]] Result<void> steer(Link &link, ReplayLink &replay, const ReplayOrder &order);

    EngineContext m_context;
    Motion &m_motion;
    Background *m_background = nullptr;
    std::map<const Link *, Kept> m_kept;
    Scope m_files; ///< that are being made; last: its tasks use everything above
};

} // namespace mb
