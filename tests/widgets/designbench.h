// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tunebench.h"
#include "widgets/common/applytheme.h"
#include "widgets/design/designpage.h"
#include "widgets/design/ownproposal.h"
#include "widgets/design/proposalcard.h"
#include "widgets/design/tuningsteps.h"

#include <QLabel>

namespace mb::test {

/// For what depends on sizes: letters and theme as the program has them without a desktop.
inline void dressAsTheProgram()
{
    QFont font = QApplication::font();
    font.setPointSizeF(10.0);
    QApplication::setFont(font);
    applyTheme(*qApp, darkTheme());
}

/// A report as an identification of the simulated drive gives it.
inline tuning::TuneReport identified()
{
    using namespace tuning;
    TuneReport report;
    report.result = TuneResult::Proposed;
    report.simulated = true;
    report.motor = MotorFound{};
    report.motor->line.gain = 350000.0;
    report.motor->pushes.tau = 0.12;
    report.motor->line.gainError = 9000.0;
    report.motor->pushes.tauError = 0.004;
    report.motor->pushes.delayError = 0.002;
    report.plant = {350000.0, 0.12, 0.03, 0.02};
    report.envelope = dmc60c().trials->bench;
    report.gates = {{"fit", say("the fit leaves 1.1 of what whole counts explain"), true}};
    for (const Aim aim : {Aim::Calm, Aim::Normal, Aim::Brisk}) {
        Proposal proposal;
        proposal.aim = aim;
        proposal.design = design(Mode::Velocity, report.plant, responseOf(Mode::Velocity, aim, report.plant), {});
        proposal.gains.made = proposal.design.gains;
        proposal.gains.rows = {{"slot0.p", 40000, 0.6}, {"slot0.i", 113, 0.0017}};
        proposal.gains.changes = {{named("slot0.p"), 40000 + static_cast<int>(aim)}};
        proposal.margins = marginsOf(Mode::Velocity, report.plant, proposal.gains.made);
        proposal.step = 60000.0;
        proposal.predicted = predictStep(Mode::Velocity, report.plant, proposal.gains.made, 0.0, 60000.0, 2.0);
        report.proposals.push_back(proposal);
    }
    return report;
}

struct DesignBench {
    FakeWorkbench workbench;
    Selection selection;
    ThemeSource theme{darkTheme()};
    Arming arming{workbench};
    Recording recording{workbench.time};
    std::unique_ptr<DesignPage> page;

    explicit DesignBench(const Theme &look = darkTheme())
        : theme(look)
    {
        workbench.shot.devices.push_back(tunableDrive(recording.telemetry()));
        LinkView link;
        link.address = link.name = "sim:can";
        link.simulated = true;
        workbench.shot.links.push_back(link);
        selection.select({1});
        page = std::make_unique<DesignPage>(workbench, selection, arming, theme, nullptr);
        page->resize(1208, 760);
        page->show();
        QApplication::setActiveWindow(page.get());
    }
    void arm() { arming.arm({1}); }
    void finish(const Result<tuning::TuneReport> &report)
    {
        const auto finished = workbench.given<orders::RunTuning>().back().finished;
        finished(report);
    }
    [[nodiscard]] OwnProposal *own() { return page->findChild<OwnProposal *>(); }
    [[nodiscard]] QList<ProposalCard *> cards() { return page->findChildren<ProposalCard *>(); }
};

/// What is said to come, or what came.
inline QString courseOf(const DesignBench &bench)
{
    QStringList words;
    for (const QLabel *label : bench.page->findChild<TuningSteps *>()->findChildren<QLabel *>())
        words << label->text();
    return words.join(QLatin1Char('|'));
}

} // namespace mb::test
