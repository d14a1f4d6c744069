// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/engine/enginecore.h"
#include "async/sleep.h"
#include "widgets/service/servicedesk.h"

#include <set>

namespace mb {

/// Units that are served in the engine's session: the queue, and who may let their motors turn. The links are lent to it, so that
/// the engine asks nothing there meanwhile. Knows no thread; thread of the session.
class ServiceJobs final : private service::MotionPermit {
public:
    struct Surroundings {
        service::ServiceJournal &journal;
        settings::SettingsLog *settings = nullptr;
        tuning::ExperimentJournal *trials = nullptr;
        std::string station;
    };
    ServiceJobs(EngineCore &core, Surroundings surroundings);
    ~ServiceJobs() override;

    /// As ServiceDesk::begin(). Timeout when a link is not there, or busy.
    [[nodiscard]] Result<void> begin(const ServiceDesk::Plan &plan);
    /// Name of this station in the journal. Unsafe while units are served.
    [[nodiscard]] Result<void> setStation(std::string name);
    void pause(bool on);
    void skip(std::uint32_t row);
    void retry(std::uint32_t row);
    void retryFailed();
    void finish();
    void cancel();
    void arm(bool on);
    void renew();
    /// Motors of units stop with all others; nothing is armed any more, and the queue ends.
    void stop();
    [[nodiscard]] ServiceView view() const;
    [[nodiscard]] bool mustStayAwake() const { return m_queue && m_queue->mustStayAwake(); }

    [[nodiscard]] Listeners<> &changed() { return m_changed; }
    [[nodiscard]] Listeners<const service::Visit &> &unitEnded() { return m_unitEnded; }

    /// Words and sound before a motor turns.
    static constexpr Duration announcement = std::chrono::seconds(3);
    /// A unit that waits for arming, and is not heard so long, was taken off.
    static constexpr Duration takenOff = std::chrono::seconds(2);
    /// Without a unit so long, nothing is armed any more.
    static constexpr Duration armedTime = std::chrono::minutes(5);

private:
    [[nodiscard]] Task<void> beforeMotion(
        const Device &device, const service::SelfTest &test, Progress &progress) override;
    [[nodiscard]] Task<void> untilArmed(const Device &device, Progress &progress);
    void queueChanged();
    void choose();
    void ended(const service::Visit &visit);
    void restartArmedTime();
    void leave();
    [[nodiscard]] Result<void> lendAll();
    void giveBack();
    void followLinks();
    [[nodiscard]] bool isRunning() const { return m_queue && m_queue->isRunning(); }
    void again(const std::function<void()> &order);

    EngineCore &m_core;
    Surroundings m_around;
    std::vector<std::string> m_links;
    std::vector<Link *> m_lent;                 ///< the same, while the queue is there
    std::optional<std::set<DeviceId>> m_chosen; ///< as ServiceDesk::Plan::chosen
    std::set<std::uint32_t> m_judged;           ///< rows that were taken or left
    /// Who may let a motor turn.
    struct Station {
        bool armed = false;
        Instant end{};        ///< of it, without a unit
        int announcing = 0;   ///< units whose motor turns in a moment
        int waiting = 0;      ///< units that wait for arming
        bool leaving = false; ///< nobody will arm any more
    };
    Station m_station;
    Message m_trouble;
    ServiceView m_last; ///< of a queue whose link is gone
    Listeners<> m_changed;
    Listeners<const service::Visit &> m_unitEnded;
    Timer m_armedUntil;
    std::unique_ptr<service::ServiceQueue> m_queue;
    Subscription m_queueChanged;
    Subscription m_queueEnded;
    Subscription m_visitEnded;
    Subscription m_sessionChanged;
};

} // namespace mb
