// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/engine/enginecore.h"

namespace mb {
namespace {

constexpr Duration lookPeriod = std::chrono::seconds(1);

template <class Part, class O>
concept Takes = requires(Part &part, const O &order, std::function<void(Result<AnswerOf<O>>)> finished)
{
    part.carryOut(order, finished);
};

/// The one part of all that carries this order out does it.
template <class O, class... Parts> void giveTo(const O &order, const Reply &reply, Parts &...parts)
{
    static_assert((Takes<Parts, O> + ...) == 1, "an order has exactly one handler");
    const auto offer = [&order, &reply]<class Part>(Part &part) {
        if constexpr (Takes<Part, O>) {
            const auto finished = reply.as<AnswerOf<O>>();
            part.carryOut(
                order, finished ? finished : [](const Result<AnswerOf<O>> &) {});
        }
    };
    (offer(parts), ...);
}

} // namespace

EngineCore::EngineCore(Clock &clock, std::span<const Family *const> families, bool opensByItself, MotionGuard *guard)
    : m_session(clock, families, guard)
    , m_log(m_session)
    , m_operations(clock, m_session, m_log)
    , m_context{clock, m_session, m_log, m_operations}
    , m_motion(m_context, guard)
    , m_recordings(m_context, m_motion)
    , m_scans(m_context, m_recordings)
    , m_links(m_context, m_motion, m_recordings, m_scans, opensByItself)
    , m_provisional(m_context)
    , m_parameters(m_context, m_provisional)
    , m_jobs(m_context, m_parameters)
    , m_firstSnapshots(m_context, m_parameters, m_provisional)
    , m_rates(m_context)
    , m_owed(m_context)
    , m_trials(m_context, m_parameters, m_owed, m_rates)
    , m_firmware(m_context, m_parameters, m_scans)
    , m_presence(m_context, m_parameters, m_firstSnapshots, m_trials)
    , m_service(m_context, m_scans)
    , m_publisher(m_context, m_links, m_provisional)
    , m_look(clock)
{
    m_look.startIn(Duration::zero(), [this] { look(); });
}

EngineCore::~EngineCore()
{
    m_session.stopAll(StopCause::Program);
    m_operations.clear(); // while what their tasks use is there
}

void EngineCore::carryOut(const Order &order, const Reply &reply)
{
    std::visit(
        [this, &reply](const auto &one) {
            giveTo(one, reply, m_operations, m_motion, m_recordings, m_scans, m_links, m_jobs, m_parameters,
                m_provisional, m_rates, m_owed, m_trials, m_firmware, m_service);
        },
        order);
}

void EngineCore::stopAll(StopCause cause)
{
    m_motion.stopAll(cause);
    cause == StopCause::User ? m_service.stop() : m_service.arm(false);
}

void EngineCore::setBackground(Background *background)
{
    m_session.setBackground(background);
    m_recordings.setBackground(background);
    m_firmware.setBackground(background);
}

void EngineCore::setSettingsLog(settings::SettingsLog *log)
{
    m_provisional.setLog(log);
    m_parameters.setLog(log);
}

void EngineCore::setJournal(tuning::ExperimentJournal *journal)
{
    m_trials.setJournal(journal);
    m_owed.setJournal(journal);
}

void EngineCore::look()
{
    m_look.startIn(lookPeriod, [this] { look(); });
    m_links.look();
    m_presence.look();
    m_presence.refreshRestarted();
    m_owed.look();
    m_firstSnapshots.look();
    m_scans.look();
}

} // namespace mb
