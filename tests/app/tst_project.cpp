// SPDX-License-Identifier: GPL-3.0-or-later
// A machine in a folder: written so that version control shows what changed, and put into force again.
#include "windowbench.h"

#include "app/project.h"
#include "app/projectdesk.h"
#include "support/fakeworkbench.h"
#include "support/windowtests.h"
#include "widgets/control/envelopebook.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>

#include <algorithm>

using namespace mb;
using namespace mb::test;

namespace {

QByteArray bytesOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

class ProjectTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aMachineIsWrittenAndReadAgain();
    void whatDidNotChangeIsNotWritten();
    void aFolderThatIsNoneIsRefusedInWords();
    void aFolderIsPutIntoForce();
    void noDialectOfAFolderIsSpokenUnlessTheScanFoundIt();
    void whatIsRefusedIsSaidAndNotToBeInForce();
};

void ProjectTest::aMachineIsWrittenAndReadAgain()
{
    WindowBench bench;
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound(), patience);
    bench.select(WindowBench::tuned);
    bench.window().showPage(PageId::Parameters);
    QTRY_VERIFY_WITH_TIMEOUT(bench.isRead(WindowBench::tuned), patience);
    EnvelopeBook limits;
    Project project = Project::of(bench.engine().snapshot(), limits);
    Envelope bounds;
    bounds.travel = 40000.0;
    bounds.duty = 0.5;
    limits.enter(project.unitOf(*bench.device(WindowBench::tuned))->unit, bounds);
    project = Project::of(bench.engine().snapshot(), limits);
    const QTemporaryDir folder;
    QVERIFY(project.save(folder.path()));
    const auto again = Project::load(folder.path());
    QVERIFY(again);
    QCOMPARE(again->links, project.links);
    QCOMPARE(again->units.size(), project.units.size());
    const ProjectUnit *unit = again->unitOf(*bench.device(WindowBench::tuned));
    QVERIFY(unit);
    QVERIFY(unit->limits == bounds);
    const QJsonObject values = unit->parameters.value(QStringLiteral("parameters")).toObject();
    QVERIFY(values.contains(QStringLiteral("slot0.p")));
    QVERIFY(!values.contains(QStringLiteral("encoder.position"))); // it is another number each time
    const QByteArray text = bytesOf(folder.filePath(QStringLiteral("project.json")));
    QVERIFY(text.count('\n') > 20); // a line for each thing
}

void ProjectTest::whatDidNotChangeIsNotWritten()
{
    Project project;
    project.links = QStringList{QStringLiteral("sim:can")};
    ProjectUnit unit;
    unit.selector = "sim:can/dmc60c:5";
    unit.serial = "210334";
    unit.parameters[QStringLiteral("family")] = QStringLiteral("dmc60c");
    project.units = {unit};
    const QTemporaryDir folder;
    QVERIFY(project.save(folder.path()));
    const QString file = folder.filePath(QStringLiteral("project.json"));
    QFile touched(file);
    QVERIFY(touched.open(QIODevice::ReadWrite));
    const QDateTime old = QDateTime::fromSecsSinceEpoch(1000);
    QVERIFY(touched.setFileTime(old, QFileDevice::FileModificationTime));
    touched.close();
    QVERIFY(project.save(folder.path()));
    QCOMPARE(QFileInfo(file).lastModified(), old);
    project.links += QStringLiteral("sim:spi");
    QVERIFY(project.save(folder.path()));
    QVERIFY(QFileInfo(file).lastModified() != old);
}

void ProjectTest::aFolderThatIsNoneIsRefusedInWords()
{
    const QTemporaryDir folder;
    QVERIFY(!Project::load(folder.path()));
    const auto write = [&folder](const QByteArray &bytes) {
        QFile file(folder.filePath(QStringLiteral("project.json")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(bytes);
    };
    for (const char *text : {"{", "{}", "{\"project\":2}", "{\"project\":1,\"links\":[\"nonsense\"]}"}) {
        write(text);
        const auto loaded = Project::load(folder.path());
        QVERIFY2(!loaded, text);
        QVERIFY2(loaded.error().text().find("project.json") != std::string::npos, text);
    }
    write("{\"project\":1,\"units\":[{\"serial\":\"x\",\"parameters\":\"../../etc/passwd\"}]}");
    const auto loaded = Project::load(folder.path());
    QVERIFY(loaded);
    QVERIFY(loaded->units[0].parameters.isEmpty());
}

void ProjectTest::aFolderIsPutIntoForce()
{
    const QTemporaryDir folder;
    Project project;
    project.links = QStringList{QStringLiteral("socketcan:can0")};
    ProjectUnit unit;
    unit.selector = "socketcan:can0/dmc60c:5";
    unit.unit = unit.serial = "210334";
    unit.calibration["counts_per_revolution"] = 2048.0;
    unit.limits.speed = 9000.0;
    project.units = {unit};
    QVERIFY(project.save(folder.path()));

    FakeWorkbench workbench;
    EnvelopeBook limits;
    QWidget window;
    ProjectDesk desk(workbench, limits, {}, window);
    desk.open(folder.path());
    QCOMPARE(workbench.given<orders::OpenLink>().size(), std::size_t(1));
    QVERIFY(workbench.given<orders::Calibrate>().empty());
    DeviceView device;
    device.id = DeviceId{1};
    device.family = families().front();
    device.identity.edit().family = "dmc60c";
    device.identity.edit().serial = "210334";
    device.unit = "dmc60c 210334"; // whatever the folder calls it
    workbench.shot.devices = {device};
    workbench.publish();
    workbench.publish(); // once is enough
    const auto calls = workbench.given<orders::Calibrate>();
    QCOMPARE(calls.size(), std::size_t(1));
    QVERIFY(calls[0].value == 2048.0);
    QVERIFY(limits.entered("dmc60c 210334").speed == 9000.0);
}

namespace {

/// A folder of one drive, and that drive, which has no serial number.
struct Folder {
    QTemporaryDir folder;
    FakeWorkbench workbench;
    EnvelopeBook limits;
    QWidget window;
    ProjectDesk desk{workbench, limits, {}, window};

    void open(const char *dialect, const std::map<std::string, double> &calibration)
    {
        Project project;
        ProjectUnit unit;
        unit.selector = "socketcan:can0/abstractdc:3";
        unit.dialect = dialect;
        unit.calibration = calibration;
        project.units = {unit};
        QVERIFY(project.save(folder.path()));
        DeviceView device;
        device.id = DeviceId{1};
        device.family = findFamily(families(), "abstractdc");
        device.selector = unit.selector;
        device.identity.edit().dialect = "F";
        workbench.shot.devices = {device};
        desk.open(folder.path());
    }
    [[nodiscard]] int said(Severity severity) const
    {
        return static_cast<int>(std::ranges::count(workbench.lines, severity, &Notice::severity));
    }
};

} // namespace

void ProjectTest::noDialectOfAFolderIsSpokenUnlessTheScanFoundIt()
{
    Folder other;
    other.open("D", {});
    QVERIFY2(other.workbench.given<orders::SetDialect>().empty(), "its code of a position is full power in another");
    QCOMPARE(other.said(Severity::Caution), 1);
    QVERIFY(other.workbench.lines.front().text.contains(QStringLiteral("dialect D")));
    Folder same;
    same.open("F", {});
    QCOMPARE(same.said(Severity::Caution), 0);
    QCOMPARE(same.said(Severity::Info), 1);
}

void ProjectTest::whatIsRefusedIsSaidAndNotToBeInForce()
{
    Folder refused;
    refused.open("", {{"counts_per_revolution", 2048.0}, {"current_scale", 0.5}});
    auto calls = refused.workbench.given<orders::Calibrate>();
    QCOMPARE(calls.size(), std::size_t(2));
    QCOMPARE(refused.said(Severity::Info), 0);
    calls[0].finished(fail(Fault::Unsafe, say("stop the motor before its calibration is changed")));
    calls[1].finished({});
    QCOMPARE(refused.said(Severity::Info), 0);
    QCOMPARE(refused.said(Severity::Caution), 1);
    Folder kept;
    kept.open("", {{"counts_per_revolution", 2048.0}, {"current_scale", 0.5}});
    calls = kept.workbench.given<orders::Calibrate>();
    calls[0].finished({});
    QCOMPARE(kept.said(Severity::Info), 0);
    calls[1].finished({});
    QCOMPARE(kept.said(Severity::Info), 1);
}

MB_WINDOW_TEST(ProjectTest);
#include "tst_project.moc"
