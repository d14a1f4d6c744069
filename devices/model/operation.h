// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "async/progress.h"
#include "async/task.h"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace mb {

struct LogLine {
    Instant time{};
    Severity severity = Severity::Info;
    Message text;
};

/// What a long job does, for who has to know: its title is for people. Other: nobody asks, and it may change something. Look: nothing is
/// lost when it is cut. Trial: puts back what it changed when it is told to stop.
enum class OperationKind { Other, Look, ReadParameters, RewriteSettings, UpdateFirmware, FamilyExperiment, Trial };

/// How far an update is.
struct UpdateStanding {
    std::string from; ///< version before, empty until it was read and where there was none
    int pages = 0;    ///< written and accepted
    int retries = 0;
};

/// What a long job looks like from outside, by value.
struct OperationStatus {
    enum class State { Running, Done, Failed, Cancelled };
    Message title;
    OperationKind kind = OperationKind::Other;
    State state = State::Running;
    Message step;
    int done = 0;
    int total = 0;
    Instant startedAt{};
    Instant endedAt{};
    bool mayInterrupt = true;
    std::map<int, PartState> parts;
    UpdateStanding update; ///< nothing of other jobs
    std::vector<LogLine> log;
    Error error; ///< of Failed
};

/// Owns one long job: its task, its progress, its log and its cancel. Engine thread. The callbacks come from the clock, so
/// they may destroy the operation; by then all that the task held is gone.
class Operation final : public Progress {
public:
    Operation(Clock &clock, Message title, OperationKind kind = OperationKind::Other);
    ~Operation() override;

    /// Once. `finished` gets the result, Cancelled included.
    template <class T> void run(Task<T> task, std::function<void(Result<T>)> finished = {})
    {
        auto job = std::make_shared<Job<T>>(std::move(task), std::move(finished));
        m_job = job;
        job->task.start([this] {
            m_timer.startIn(Duration::zero(), [this] {
                const auto keep = m_job; // the callback may destroy this operation
                keep->finish(*this);
            });
        });
    }
    /// Posted: the task ends before its next step, and `finished` gets Cancelled. Nothing happens while the job must not be
    /// interrupted; it can be asked again then.
    bool cancel();
    /// Ends the job at once, whatever it does, and `finished` gets `error`: what it works with is about to go. Not from inside
    /// the job. A job that is simply destroyed with its operation answers nobody.
    void dismiss(const Error &error);

    [[nodiscard]] const OperationStatus &status() const { return m_status; }
    [[nodiscard]] bool isRunning() const { return m_status.state == OperationStatus::State::Running; }
    [[nodiscard]] std::uint64_t revision() const { return m_revision; }

    void step(const Message &what, int done, int total) override;
    void part(int number, PartState state) override;
    void log(Severity severity, const Message &text) override;
    void mayInterrupt(bool may) override;
    void replaces(const std::string &version) override;
    void accepted(int parts, int retries) override;

private:
    struct AnyJob {
        virtual ~AnyJob() = default;
        virtual void finish(Operation &operation) = 0;
        virtual void cut(Operation &operation, const Error &error) = 0;
        virtual void abandon() = 0;
    };
    template <class T> struct Job final : AnyJob {
        Job(Task<T> work, std::function<void(Result<T>)> callback)
            : task(std::move(work))
            , finished(std::move(callback))
        {
        }
        void finish(Operation &operation) override
        {
            Result<T> result = std::move(task.result());
            task.cancel(); // one that failed in its middle still holds what it worked with, such as a motion
            end(operation, std::move(result));
        }
        void cut(Operation &operation, const Error &error) override
        {
            if (task.isFinished()) {
                finish(operation);
                return;
            }
            task.cancel();
            end(operation, fail(error));
        }
        void abandon() override { task.cancel(); }
        void end(Operation &operation, Result<T> result)
        {
            const auto callback = std::move(finished);
            operation.ended(result ? nullptr : &result.error());
            if (callback)
                callback(std::move(result));
        }
        Task<T> task;
        std::function<void(Result<T>)> finished;
    };
    void ended(const Error *error);

    Clock &m_clock;
    OperationStatus m_status;
    std::uint64_t m_revision = 0;
    std::shared_ptr<AnyJob> m_job;
    Timer m_timer;
};

} // namespace mb
