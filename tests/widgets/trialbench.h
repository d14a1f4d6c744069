// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tunehand.h"
#include "widgets/control/metricspanel.h"
#include "widgets/control/responseplot.h"
#include "widgets/control/stimulusbar.h"
#include "widgets/control/triallist.h"
#include "widgets/control/trialsview.h"
#include "widgets/plots/plotstack.h"

#include <QTableView>
#include <QTableWidget>

namespace mb::test {

/// What the engine would answer: a second-order step with this damping.
inline tuning::Trial responseOf(
    const tuning::ExperimentPlan &plan, std::int64_t number, double damping, const std::string &unit)
{
    tuning::Trial trial;
    trial.number = number;
    trial.unit = unit;
    trial.device = "sim:can/dmc60c:5";
    trial.simulated = true;
    trial.mode = plan.mode;
    trial.axis = plan.axis;
    trial.stimulus = *tuning::Stimulus::make(plan.profile, plan.from.value_or(0.0), plan.to, plan.seconds, 0.02);
    trial.repeat = plan.repeat;
    trial.envelope = {1e6, 1e6, 60.0, 0.55};
    trial.gains = {{"slot0.p", 1.0 + damping}, {"slot0.i", 0.003}};
    trial.reason = tuning::EndReason::Done;
    trial.stopped = true;
    trial.holds = {{0.0, 1.0}};
    trial.returns = {{1.0, 2.0}};
    tuning::Signal velocity{"velocity", "counts/s", {}};
    tuning::Signal duty{"duty", "fraction", {}};
    constexpr double omega = 15.0;
    const double damped = omega * std::sqrt(1.0 - damping * damping);
    const auto step = [&](double t) {
        return t <= 0.0 ? 0.0
                        : 1.0
                - std::exp(-damping * omega * t)
                    * (std::cos(damped * t) + damping * omega / damped * std::sin(damped * t));
    };
    for (int i = -40; i < 400; ++i) {
        const double t = i * 0.005;
        velocity.trace.add(t, trial.stimulus.to * (step(t) - step(t - 1.0)));
        duty.trace.add(t, t < 0.0 ? 0.0 : t < 0.08 ? 0.55 : 0.3);
    }
    trial.signals = {velocity, duty};
    trial.metrics = tuning::readResponse(velocity.trace.part(-0.2, 1.0), trial.stimulus.to, 5.0).metrics;
    trial.metrics.saturated = 0.08;
    return trial;
}

/// The page in its first view, with a notebook.
struct TrialBench : TuneBench {
    explicit TrialBench(const Theme &look = lightTheme(), QSize size = {1208, 760})
        : TuneBench(look, size)
    {
        page->showLive(false);
        device().selector = "sim:can/dmc60c:5";
        device().liveness.heard = true;
        workbench.publish();
    }
    [[nodiscard]] std::string unit() { return device().unit; }
    void choose(double to, int repeat = 1)
    {
        StimulusChoice choice;
        choice.to = to;
        choice.repeat = repeat;
        page->form().chooseStimulus(Mode::Velocity, choice);
    }
    /// As the engine ends it: kept, then told.
    tuning::Trial finish(double damping)
    {
        const auto planned = workbench.given<orders::RunTrial>().back();
        const tuning::Trial trial = responseOf(
            planned.plan, static_cast<std::int64_t>(workbench.given<orders::RunTrial>().size()), damping, unit());
        KeptTrial kept;
        kept.number = *trial.number;
        kept.trial = trial;
        workbench.book.recorded[kept.number] = trial.signals;
        kept.trial.signals.clear();
        workbench.book.kept.push_back(kept);
        planned.finished(trial);
        QCoreApplication::processEvents();
        QCoreApplication::processEvents();
        return trial;
    }
    [[nodiscard]] QString metric(int row, int column)
    {
        return page->trials().metrics().table().item(row, column)->text();
    }
};

} // namespace mb::test
