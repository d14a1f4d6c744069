// SPDX-License-Identifier: GPL-3.0-or-later
#include "gallery.h"
#include "tests/tuning/tuningbench.h"
#include "tests/widgets/designbench.h"

#include "experiment/battery.h"
#include "report/report.h"
#include "tuning/frequencyresponse.h"
#include "widgets/common/devicetext.h"
#include "widgets/control/batterydialog.h"
#include "widgets/design/sweeppanel.h"
#include "widgets/report/reportdrawings.h"

#include <QAbstractTextDocumentLayout>
#include <QPainter>
#include <QTextDocument>

using namespace mb;
using namespace mb::test;

namespace {

constexpr int lively = 7;
constexpr double made = 1.76e9;           // Unix time
constexpr double largestStep = 200'000.0; // counts/s
const QSize sheet(760, 1075);             // of A4, px

/// What a unit that overshoots came to: tuned, then its frequency response and its battery.
struct Measured {
    tuning::TuneReport report;
    tuning::FrequencyResponse response;
    std::vector<KeptTrial> sines;
    tuning::Battery battery;
    std::vector<tuning::Trial> steps;
    Identity identity;
};

tuning::SweepPlan sweepOf(const Device &device, const tuning::TuneReport &report)
{
    const Family &family = device.family();
    const double beat = std::chrono::duration<double>(family.capabilities.commandPeriod).count();
    return tuning::planSweep(report.plant, family.trials->bench, beat).value();
}

Measured measure()
{
    ExperimentBench bench("sim:can", "dmc60c", lively);
    Measured found;
    found.report = tune(bench, planOf(Mode::Velocity)).value();
    const std::size_t tuned = bench.journal.completed.size();
    found.response = run(bench.bench.clock,
        measureFrequencyResponse(*bench.device, bench.bench.session.stream(*bench.device),
            sweepOf(*bench.device, found.report), found.report.plant, bench.surroundings))
                         .value();
    for (std::size_t i = tuned; i < bench.journal.completed.size(); ++i)
        found.sines.push_back({static_cast<std::int64_t>(i + 1), 0.0, bench.journal.completed[i], false, {}});
    found.battery = tuning::batteryOf(stepTo(Mode::Velocity, largestStep), 0.0, false);
    for (const tuning::ExperimentPlan &step : found.battery.steps)
        found.steps.push_back(bench.run(step).value());
    found.identity = bench.device->identity();
    return found;
}

const Measured &measured()
{
    static const Measured once = measure();
    return once;
}

void armOn(FakeWorkbench &workbench, Arming &arming)
{
    workbench.shot.devices[0].selector = measured().report.device;
    arming.arm({1});
}

} // namespace

QWidget *responsePage(const ThemeSource &theme)
{
    auto *bench = new DesignBench(theme.theme());
    armOn(bench->workbench, bench->arming);
    bench->page->identify();
    bench->finish(measured().report);
    bench->page->findChild<SweepPanel *>()->measure();
    bench->workbench.given<orders::RunSweep>().back().finished(measured().response);
    QWidget *const page = bench->page.release();
    QObject::connect(page, &QObject::destroyed, page, [bench] { delete bench; });
    return page;
}

QWidget *batteryPage(const ThemeSource &theme)
{
    auto *bench = new TuneBench(theme.theme());
    armOn(bench->workbench, bench->arming);
    const auto offer = [] { return BatteryOffer{{1}, measured().battery, QStringLiteral("counts/s"), {}}; };
    auto *dialog = new BatteryDialog(bench->arming, offer, theme, nullptr);
    dialog->showOffer();
    dialog->show();
    dialog->run();
    for (const tuning::Trial &step : measured().steps)
        bench->workbench.given<orders::RunTrial>().back().finished(step);
    QObject::connect(dialog, &QObject::destroyed, dialog, [bench] { delete bench; });
    return dialog;
}

QImage reportPicture()
{
    Report report;
    report.time = made;
    report.program = QStringLiteral("MotorBench").toStdString();
    ReportUnit unit;
    unit.family = &dmc60c();
    unit.identity = measured().identity;
    unit.selector = measured().report.device;
    unit.simulated = true;
    unit.tunings = {{1, made, measured().report}};
    unit.sines = measured().sines;
    report.units = {unit};
    ReportDrawings drawings;
    QTextDocument document;
    document.documentLayout()->registerHandler(QTextFormat::ImageObject, &drawings);
    document.setHtml(drawings.takeFrom(htmlOf(report)));
    document.setTextWidth(sheet.width());
    QImage picture(sheet, QImage::Format_RGB32);
    picture.fill(Qt::white);
    QPainter painter(&picture);
    document.drawContents(&painter, QRectF(QPointF(), sheet));
    return picture;
}
