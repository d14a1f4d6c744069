// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/family.h"
#include "model/registry.h"
#include "report/report.h"
#include "report/svgplot.h"

#include <gtest/gtest.h>

#include <QXmlStreamReader>

#include <cmath>

namespace mb {
namespace {

using namespace tuning;

const Family *familyNamed(std::string_view key)
{
    for (const Family *family : families()) {
        if (family->key == key)
            return family;
    }
    return nullptr;
}

Trace rising(double to)
{
    Trace trace;
    for (int i = -20; i < 400; ++i)
        trace.add(0.005 * i, i < 0 ? 0.0 : to * (1.0 - std::exp(-0.05 * i)));
    return trace;
}

KeptTrial trial()
{
    KeptTrial kept;
    kept.number = 12;
    kept.time = 1.7e9;
    kept.note = "with the <new> belt";
    Trial &trial = kept.trial;
    trial.number = 12;
    trial.device = "sim:can/dmc60c:7";
    trial.unit = "simulated dmc60c 210334ABCDEF";
    trial.firmware = "1.23";
    trial.simulated = true;
    trial.stimulus = *Stimulus::make(Profile::Step, 0.0, 60'000.0, {}, 0.02);
    trial.repeat = 2;
    trial.holds = {{0.0, 2.0}};
    trial.gains = {{"slot0.p", 1.165}, {"slot0.i", std::nullopt}};
    trial.metrics.overshoot = 0.204;
    trial.metrics.settle = 0.524;
    trial.reason = EndReason::Done;
    trial.stopped = true;
    trial.samples = 4711;
    trial.signals = {{"velocity", "counts/s", rising(60'000.0)}, {"duty", "fraction", rising(0.3)}};
    return kept;
}

KeptTuning tuned()
{
    KeptTuning kept;
    kept.number = 1;
    TuneReport &report = kept.report;
    report.result = TuneResult::Kept;
    report.simulated = true;
    report.evidence = say("the steps in both directions did what was predicted");
    report.plant = {105'000.0, 0.168, 0.052, 0.021};
    report.motor.emplace();
    report.motor->line.gainError = 120.0;
    report.motor->line.offset = 0.0123;
    report.motor->line.offsetError = 0.0045;
    report.motor->line.forward = 106'000.0;
    report.motor->line.reverse = 103'000.0;
    report.motor->restNoise = 0.37;
    report.motor->latency = 0.0137;
    report.profile = ProfileLimits{82'000.0, 491'000.0};
    report.gates = {{"fit", say("what the fit leaves is 1.4 times"), true, {}}};
    report.proposed.rows = {{"slot0.p", 38083, 0.5811}};
    report.proposed.made = {1e-5, 6e-5, 0.0, 0.0};
    report.before = {{"slot0.p", 1.165}};
    report.margins = Margins{1.44, 3.9, 67.0, 4.0};
    report.predicted.emplace();
    report.predicted->measured = rising(30'000.0);
    report.predicted->metrics.settle = 0.5;
    report.measured.overshoot = 0.013;
    report.proof = {trial().trial};
    report.trials = {12};
    return kept;
}

Report reportOf(bool simulated)
{
    Report report;
    report.time = 1.7e9;
    report.program = "MotorBench 0.1.0";
    ReportUnit unit;
    unit.family = familyNamed("dmc60c");
    unit.identity.family = "dmc60c";
    unit.identity.address = 7;
    unit.identity.serial = "210334ABCDEF";
    unit.identity.firmware = "1.23";
    unit.simulated = simulated;
    unit.selector = "sim:can/dmc60c:7";
    unit.tunings = {tuned()};
    unit.trials = {trial()};
    unit.history = {trial()};
    for (const Parameter &parameter : unit.family->parameters)
        unit.parameters.push_back({std::llround(parameter.fallback * parameter.one), ParameterState::Stored});
    *unit.parameters[findParameter(unit.family->parameters, "slot0.p")->value].raw += 4711;
    report.units.push_back(std::move(unit));
    return report;
}

TEST(Report, TellsTheUnitItsTuningItsTrialItsParametersAndItsHistory)
{
    const QString html = htmlOf(reportOf(true));
    for (const char *word : {"DMC60C 7", "210334ABCDEF", "sim:can/dmc60c:7", "1.23", "Tuning of the velocity loop",
             "Kept", "slot0.p", "0.5811", "38083", "105000", "Sensitivity peak Ms", "Trial 12", "20.4", "524", "60000",
             "4711 samples, 0 lost", "1 of 55 differ", "History of the unit", "MotorBench 0.1.0"})
        EXPECT_TRUE(html.contains(QString::fromUtf8(word))) << word << "\n";
    EXPECT_TRUE(html.contains(QStringLiteral("with the &lt;new&gt; belt")));
    EXPECT_EQ(html.count(QStringLiteral("<svg ")), 3); // the proof, the loop, the trial
}

TEST(Report, TellsBothDirectionsApartAndWhatASetPointMayAskFor)
{
    const QString html = htmlOf(reportOf(true));
    for (const char *word : {"Load one way kG", "1.23", "0.45", "Gain forwards", "106000", "Gain backwards", "103000",
             "Noise at rest", "0.37", "Order to motion", "13.7", "82000", "491000", "counts/s²"})
        EXPECT_TRUE(html.contains(QString::fromUtf8(word))) << word;
    EXPECT_FALSE(html.contains(QStringLiteral("F is 0")));
    Report idle = reportOf(true);
    idle.units.front().tunings.front().report.proposed.rows.push_back({"slot0.f", 0, 0.0});
    EXPECT_TRUE(htmlOf(idle).contains(QStringLiteral("F is 0: with an integral")));
    Report unseen = reportOf(true);
    unseen.units.front().tunings.front().report.motor.emplace();
    unseen.units.front().tunings.front().report.gates.front().warns = true;
    const QString less = htmlOf(unseen);
    EXPECT_TRUE(less.contains(QStringLiteral("to be looked at")));
    EXPECT_FALSE(html.contains(QStringLiteral("to be looked at")));
    for (const char *word : {"Load one way", "Gain forwards", "Noise at rest", "Order to motion"})
        EXPECT_FALSE(less.contains(QString::fromUtf8(word))) << word;
}

TEST(Report, TellsTheBreakawayOfEachDirectionInVoltWhereTheSupplyIsTold)
{
    Report report = reportOf(true);
    tuning::MotorFound &motor = *report.units.front().tunings.front().report.motor;
    EXPECT_FALSE(htmlOf(report).contains(QStringLiteral("Breakaway"))) << "nobody has measured it";
    motor.ramp
        = tuning::RampFound{{0.031, 0.001, 0.02, 0.0, 105'000.0, 0.999}, {0.034, 0.001, 0.02, 0.0, 105'000.0, 0.999}};
    for (const char *word : {"Breakaway forwards", "3.10<", "Breakaway backwards", "3.40<"})
        EXPECT_TRUE(htmlOf(report).contains(QString::fromUtf8(word))) << word;
    motor.supply = 12.0;
    for (const char *word : {"0.372", "0.408", ">V<"})
        EXPECT_TRUE(htmlOf(report).contains(QString::fromUtf8(word))) << word;
}

TEST(Report, MarksASimulatedUnitInWordsInEveryPlotAndForPrograms)
{
    const QString simulated = htmlOf(reportOf(true));
    EXPECT_TRUE(simulated.contains(QStringLiteral("<meta name=\"simulated\"")));
    EXPECT_TRUE(simulated.contains(QStringLiteral("DEMO: this unit is simulated")));
    EXPECT_EQ(simulated.count(QStringLiteral(">DEMO</text>")), 5); // a pane each
    Report real = reportOf(false);
    real.units.front().tunings.clear();
    real.units.front().trials.front().trial.simulated = false;
    EXPECT_FALSE(htmlOf(real).contains(QStringLiteral("DEMO")));
}

TEST(Report, RefersToNothingOutsideItAndItsDrawingsAreWellFormed)
{
    const QString html = htmlOf(reportOf(true));
    EXPECT_FALSE(html.contains(QStringLiteral("src=")));
    EXPECT_FALSE(html.contains(QStringLiteral("href=")));
    int from = 0;
    for (int i = 0; i < 3; ++i) {
        const int begin = html.indexOf(QStringLiteral("<svg "), from);
        from = html.indexOf(QStringLiteral("</svg>"), begin) + 6;
        ASSERT_GT(from, begin);
        QXmlStreamReader xml(html.mid(begin, from - begin));
        while (!xml.atEnd())
            xml.readNext();
        EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
    }
}

TEST(Report, WhatIsNotKnownIsADashAndNeverNought)
{
    const QString html = htmlOf(reportOf(true));
    const int row = html.indexOf(QStringLiteral("slot0.i"));
    ASSERT_GT(row, 0);
    EXPECT_TRUE(html.mid(row, 120).contains(QStringLiteral("–"))) << html.mid(row, 120).toStdString();
}

TEST(Report, SaysThatTheDutyLimitStandsInWhereNoCurrentIsTold)
{
    Report report = reportOf(true);
    Envelope &envelope = report.units.front().trials.front().trial.envelope;
    envelope = {5000.0, {}, 12.5, 0.4};
    const QString words = QStringLiteral(", which stands in for a limit of current.</p>");
    EXPECT_FALSE(htmlOf(report).contains(words));
    envelope.current.reset();
    EXPECT_TRUE(htmlOf(report).contains(words));
}

TEST(Report, TellsFlagsAndWhatBoundedAnAimInTheWordsOfTheReader)
{
    Report report = reportOf(true);
    report.phrase = [](const Message &message) {
        return QLatin1Char('[') + QString::fromStdString(message.english()) + QLatin1Char(']');
    };
    report.units.front().trials.front().trial.flags = {"aborted", "did-not-move", "of a newer version"};
    TuneReport &tuning = report.units.front().tunings.front().report;
    tuning.proposals.emplace_back().gains.made = tuning.proposed.made;
    tuning.proposals.front().design.bounds = {"margin"};
    const QString html = htmlOf(report);
    for (const char *word : {"[did not move]", "[of a newer version]", "[margin]"})
        EXPECT_TRUE(html.contains(QString::fromUtf8(word))) << word;
    EXPECT_FALSE(html.contains(QStringLiteral("[stopped]"))) << "its ending says so";
}

TEST(Report, HasTheThreeProposalsAndTheBandOfTheOneThatWasChosen)
{
    Report report = reportOf(true);
    TuneReport &tuning = report.units.front().tunings.front().report;
    for (const Aim aim : {Aim::Calm, Aim::Normal, Aim::Brisk}) {
        Proposal &proposal = tuning.proposals.emplace_back();
        proposal.aim = aim;
        proposal.design.response = 0.4 - 0.1 * static_cast<double>(aim);
        proposal.margins.ms = 1.25;
        proposal.step = 30'000.0;
        proposal.gains.made = {(1.0 + static_cast<double>(aim)) * 5e-6, 6e-5, 0.0, 0.0};
    }
    tuning.proposals.back().gains.made = tuning.proposed.made; // rounded to the same integers as the normal ones
    tuning.design = tuning.proposals[1].design;
    tuning.step = 30'000.0;
    tuning.motor->pushes.tauError = 0.01;
    tuning.proposed.rows.push_back({"slot0.i", 41, 0.0006});
    const QString html = htmlOf(report);
    for (const char *word :
        {">calm<", ">400\u00a0ms<", ">normal</b>", ">300\u00a0ms</b>", ">brisk<", ">200\u00a0ms<", ">1.25<",
            "band: ± of the model", "slot0.i is 41 of its smallest steps, fewer than 50: one of them is 2.4 %"})
        EXPECT_TRUE(html.contains(QString::fromUtf8(word))) << word;
    tuning.motor.emplace(); // swung or tried: it has no ±
    EXPECT_FALSE(htmlOf(report).contains(QStringLiteral("band:")));
}

TEST(Report, ShowsWhatWasChosenBesideTheThreeProposalsBelowThem)
{
    Report report = reportOf(true);
    TuneReport &tuning = report.units.front().tunings.front().report;
    Proposal &normal = tuning.proposals.emplace_back();
    normal.gains.made = tuning.proposed.made;
    normal.design.response = 0.1;
    tuning.design.emplace().response = 0.3; // by numbers of one's own
    EXPECT_TRUE(htmlOf(report).contains(QStringLiteral(">chosen</b>")));
    EXPECT_TRUE(htmlOf(report).contains(QStringLiteral(">300\u00a0ms</b>")));
    tuning.design = normal.design;
    EXPECT_FALSE(htmlOf(report).contains(QStringLiteral(">chosen</b>")));
    EXPECT_TRUE(htmlOf(report).contains(QStringLiteral(">normal</b>")));
}

TEST(Report, DoesNotCallPutBackWhatIsStillInForce)
{
    Report report = reportOf(true);
    TuneReport &tuning = report.units.front().tunings.front().report;
    tuning.result = TuneResult::RolledBack;
    EXPECT_TRUE(htmlOf(report).contains(QStringLiteral(">Put back<")));
    tuning.notPutBack = say("slot0.p was not written");
    EXPECT_FALSE(htmlOf(report).contains(QStringLiteral(">Put back<")));
    EXPECT_TRUE(htmlOf(report).contains(QStringLiteral(">Not kept<")));
}

/// What a motor without friction answers to a sine of duty, 200 times a second.
KeptTrial sine(double hertz)
{
    constexpr double gain = 105'000.0;
    constexpr double tau = 0.168;
    KeptTrial kept;
    kept.time = 1.7e9;
    kept.trial.mode = Mode::Duty;
    kept.trial.reason = EndReason::Done;
    kept.trial.stimulus = *Stimulus::make(Profile::Sine, 0.15, 0.35, 6.0 / hertz, 0.001);
    Trace position;
    Trace duty;
    double speed = gain * 0.25;
    double place = 0.0;
    for (int i = -1000; i < static_cast<int>(6.0 / hertz / 0.0005); ++i) {
        const double push = i < 0 ? 0.25 : kept.trial.stimulus.at(0.0005 * i);
        if (i % 10 == 0) {
            position.add(0.0005 * i, std::floor(place));
            duty.add(0.0005 * i, push);
        }
        speed += 0.0005 / tau * (gain * push - speed);
        place += 0.0005 * speed;
    }
    kept.trial.signals = {{"position", "counts", position}, {"duty", "fraction", duty}};
    return kept;
}

TEST(Report, NamesTheGuardThatStoppedATrialInWordsNotByItsKey)
{
    Report report = reportOf(true);
    report.units.front().trials.front().trial.reason = EndReason::WrongDirection;
    EXPECT_TRUE(htmlOf(report).contains(QStringLiteral("stopped by the guard “direction”")));
    report.units.front().trials.front().trial.reason = EndReason::Unknown;
    EXPECT_TRUE(htmlOf(report).contains(QStringLiteral("stopped by the guard “unknown”")));
}

TEST(Report, TellsTheFrequencyResponseWithItsCoherenceBesideTheModel)
{
    Report report = reportOf(true);
    ReportUnit &unit = report.units.front();
    EXPECT_FALSE(htmlOf(report).contains(QStringLiteral("Frequency response"))) << "none was made";
    unit.sines = {sine(0.5), sine(2.0), sine(24.0)};
    const QString html = htmlOf(report);
    EXPECT_TRUE(html.contains(QStringLiteral("Frequency response of the motor")));
    EXPECT_TRUE(html.contains(QStringLiteral("2 of 3"))) << "24 Hz has fewer than ten samples a swing";
    EXPECT_EQ(html.count(QStringLiteral("<svg ")), 4); // the proof, the loop, the motor, the trial
    const int begin = html.indexOf(QStringLiteral("Coherence"));
    ASSERT_GT(begin, 0);
    const QString table = html.mid(begin, html.indexOf(QStringLiteral("</table>"), begin) - begin);
    EXPECT_EQ(table.count(QStringLiteral(">yes<")), 2) << table.toStdString();
    EXPECT_EQ(table.count(QStringLiteral(">no<")), 1) << table.toStdString();
    EXPECT_TRUE(table.contains(QStringLiteral("1.000"))) << table.toStdString();
    unit.tunings.clear(); // nobody knows its lag
    EXPECT_FALSE(htmlOf(report).contains(QStringLiteral("Frequency response")));
}

TEST(SvgPlot, ThinsACurveOutButKeepsASpikeOfOneSample)
{
    SvgPlot plot;
    Trace trace;
    for (int i = 0; i < 100'000; ++i)
        trace.add(i, i == 54'321 ? 1.0 : 0.0);
    plot.panes.push_back({QStringLiteral("A"), {{{}, QStringLiteral("#000000"), {}, trace}}, 100});
    const QString svg = svgOf(plot);
    EXPECT_LT(svg.size(), 60'000);
    const int points = svg.indexOf(QStringLiteral("points=\""));
    double least = 1e9;
    for (const QString &point :
        svg.mid(points + 8, svg.indexOf(QLatin1Char('"'), points + 8) - points - 8).split(QLatin1Char(' ')))
        least = std::min(least, point.section(QLatin1Char(','), 1, 1).toDouble());
    EXPECT_LT(least, 40.0) << "the top of the pane";
}

TEST(SvgPlot, IsEmptyWhereThereIsNothingToDraw)
{
    EXPECT_TRUE(svgOf({}).isEmpty());
    SvgPlot plot;
    plot.panes.push_back({QStringLiteral("A"), {{{}, {}, {}, {}}}, 100});
    EXPECT_TRUE(svgOf(plot).isEmpty());
}

} // namespace
} // namespace mb
