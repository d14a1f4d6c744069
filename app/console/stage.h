// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/console.h"
#include "app/console/notebook.h"
#include "app/console/target.h"
#include "async/noncopyable.h"
#include "experiment/experiment.h"
#include "model/leaserenewal.h"
#include "model/session.h"
#include "model/setpointstream.h"

#include <functional>
#include <memory>

namespace mb::console {

/// Where the device of an experiment lives: this program's session, or for a simulated one a session of its own on exact time.
class Stage {
public:
    Stage(Console &console, const LinkAddress &link);
    ~Stage();

    [[nodiscard]] Session &session() { return m_session ? *m_session : m_console.session(); }
    /// In its application, and listened to long enough that another master was heard.
    [[nodiscard]] Task<Device *> find(Target target);

private:
    Console &m_console;
    std::unique_ptr<Clock> m_clock;
    std::unique_ptr<Session> m_session;
};

/// What a verb does with the device that it names, on a stage of its own.
using Performance = std::function<Task<int>(Session &, Device &)>;
/// A signal ends it through its own stop.
[[nodiscard]] Task<int> performOn(Console &console, Target target, Performance performance);

/// Of a notebook that cannot be opened, where an experiment writes gains that it owes back.
[[nodiscard]] Error putsNothingBack(const Error &trouble);

/// What the experiments of one verb share with this program while they run: the notebook, the signals that end them, its notes.
class Experimenting : NonCopyable {
public:
    Experimenting(Console &console, Session &session, Device &device, Notebook &notebook, int axis);

    [[nodiscard]] SetPointStream &stream() { return m_stream; }
    [[nodiscard]] tuning::ExperimentSurroundings surroundings();

private:
    Console &m_console;
    Notebook &m_notebook;
    SetPointStream &m_stream;
    tuning::DirectionBook m_directions;
    tuning::Interruption m_interruption;
    Subscription m_signal;
    LeaseRenewal m_renewal;
};

} // namespace mb::console
