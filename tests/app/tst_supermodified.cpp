// SPDX-License-Identifier: GPL-3.0-or-later
// A Supermodified in the window: the programmer of its update is chosen from lists, and every page can be looked at:
//   MOTORBENCH_PICTURES=DIR [PICTURE_SIZE=3840x2160] [PICTURE_SCALE=2] [PICTURE_LANGUAGE=de] test_app_supermodified pictures
#include "support/windowtests.h"
#include "widgets/control/tunepage.h"
#include "widgets/firmware/firmwarepage.h"
#include "widgets/parameters/parameterspage.h"
#include "widgets/plots/plotspage.h"
#include "windowbench.h"

#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QScrollArea>
#include <QTemporaryDir>
#include <QTest>

using namespace mb;
using namespace mb::test;

namespace {

constexpr const char *family = "supermodified";
constexpr int node = 4;

/// An `avrdude` of our own in PATH, which writes down what it is asked for, says that all went well, and leaves the node alone.
class StandIn {
public:
    StandIn()
        : m_before(qgetenv("PATH"))
    {
        QFile file(m_folder.filePath(QStringLiteral("avrdude")));
        if (!file.open(QIODevice::WriteOnly))
            qFatal("no stand-in");
        file.write("#!/bin/sh\necho \"$@\" >> " + m_folder.filePath(QStringLiteral("calls")).toUtf8()
            + "\necho 'avrdude: writing 6 bytes flash ...' >&2\necho 'Writing | ################' >&2\nsleep 0.2\n"
              "echo 'avrdude: 6 bytes of flash written' >&2\necho 'avrdude: 6 bytes of flash verified' >&2\n");
        file.close();
        file.setPermissions(QFile::ReadOwner | QFile::ExeOwner);
        qputenv("PATH", m_folder.path().toUtf8() + ':' + m_before);
        QFile image(imagePath());
        if (image.open(QIODevice::WriteOnly))
            image.write(":060000000C943400000026\n:00000001FF\n");
    }
    StandIn(const StandIn &) = delete;
    StandIn &operator=(const StandIn &) = delete;
    ~StandIn() { qputenv("PATH", m_before); }
    [[nodiscard]] QString imagePath() const { return m_folder.filePath(QStringLiteral("main.hex")); }
    [[nodiscard]] QByteArray calls() const
    {
        QFile file(m_folder.filePath(QStringLiteral("calls")));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

private:
    QTemporaryDir m_folder;
    QByteArray m_before;
};

bool isReady(WindowBench &bench)
{
    const DeviceView *device = bench.device(node, family);
    return device && device->liveness.heard && !device->identity->dialect.empty() && device->mayNotMove.empty();
}

} // namespace

class SupermodifiedTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theProgrammerIsChosenAndANodeThatAnsweredAllTheWhileIsNotCalledUpdated();
    void itsOutputHasNoOptionsAndItsPositionCanBeZeroed();
    void pictures();
};

void SupermodifiedTest::theProgrammerIsChosenAndANodeThatAnsweredAllTheWhileIsNotCalledUpdated()
{
    const StandIn avrdude;
    WindowBench bench;
    QTRY_VERIFY_WITH_TIMEOUT(isReady(bench), patience);
    bench.window().selection().select(bench.device(node, family)->id);
    auto &page = bench.page<FirmwarePage>(PageId::Firmware);
    page.loadImage(avrdude.imagePath());
    auto *programmer = page.findChild<QComboBox *>(QStringLiteral("programmer"));
    auto *port = page.findChild<QComboBox *>(QStringLiteral("programmerPort"));
    QVERIFY(programmer->isVisible() && programmer->count() > 3);
    for (const QComboBox *box : {programmer, port})
        QVERIFY(!box->accessibleName().isEmpty() && !box->toolTip().isEmpty());
    programmer->setCurrentIndex(programmer->findData(QStringLiteral("arduino")));
    QVERIFY(port->isVisible());
    port->setEditText({});
    QVERIFY2(!page.canStart(), "nobody knows where the bootloader is");
    port->setEditText(QStringLiteral("/dev/ttyUSB7"));
    QVERIFY(page.canStart());
    programmer->setCurrentIndex(programmer->findData(QStringLiteral("usbasp")));
    QVERIFY(!port->isVisible());
    QTRY_VERIFY_WITH_TIMEOUT(page.canStart(), patience);
    programmer->setCurrentIndex(programmer->findData(QStringLiteral("arduino"))); // the other one would halt the node
    page.startUpdate();
    const auto report = [&bench]() -> const UpdateReport * {
        for (const OperationView &operation : bench.engine().snapshot().operations) {
            if (operation.update)
                return &*operation.update;
        }
        return nullptr;
    };
    QTRY_VERIFY_WITH_TIMEOUT(report(), patience);
    QVERIFY2(report()->outcome == UpdateOutcome::Failed, report()->evidence.english().c_str());
    QVERIFY2(report()->evidence.english().find("wrote another unit") != std::string::npos,
        report()->evidence.english().c_str());
    QVERIFY(!report()->verified);
    QVERIFY2(avrdude.calls().startsWith("-p m328p -c arduino -P /dev/ttyUSB7 -b "), avrdude.calls().constData());
    QVERIFY(!avrdude.calls().contains("fuse") && !avrdude.calls().contains("lock"));
}

void SupermodifiedTest::itsOutputHasNoOptionsAndItsPositionCanBeZeroed()
{
    WindowBench bench;
    QTRY_VERIFY_WITH_TIMEOUT(isReady(bench) && bench.isFound(), patience);
    auto *page = bench.window().page(PageId::Tune);
    bench.window().showPage(PageId::Tune);
    bench.page<TunePage>(PageId::Tune).showLive(true);
    const auto shows = [page](const QString &start) {
        const auto buttons = page->findChildren<QAbstractButton *>();
        return std::any_of(buttons.begin(), buttons.end(),
            [&](const QAbstractButton *b) { return b->isVisible() && b->text().startsWith(start); });
    };
    bench.select(WindowBench::tuned);
    QTRY_VERIFY(shows(QStringLiteral("Drive options")) && !shows(QStringLiteral("Stop and count")));
    bench.window().selection().select(bench.device(node, family)->id);
    QTRY_VERIFY(!shows(QStringLiteral("Drive options")) && shows(QStringLiteral("Stop and count")));
    QVERIFY(!shows(QStringLiteral("Limits of the loop")));
}

void SupermodifiedTest::pictures()
{
    const QDir folder(qEnvironmentVariable("MOTORBENCH_PICTURES"));
    if (qEnvironmentVariableIsEmpty("MOTORBENCH_PICTURES"))
        QSKIP("no folder for pictures is named");
    Options options;
    options.demo = true;
    options.size = qEnvironmentVariable("PICTURE_SIZE", QStringLiteral("1280x800"));
    options.language = qEnvironmentVariable("PICTURE_LANGUAGE", QStringLiteral("en"));
    options.fontScale = qEnvironmentVariable("PICTURE_SCALE", QStringLiteral("1")).toDouble();
    for (const QString &theme : {QStringLiteral("dark"), QStringLiteral("light")}) {
        options.theme = theme;
        Application application(*qApp, options);
        application.start();
        MainWindow &window = application.window();
        const auto device = [&]() -> const DeviceView * {
            for (const DeviceView &view : application.engine().snapshot().devices) {
                if (view.family->key == family && view.identity->address == node)
                    return &view;
            }
            return nullptr;
        };
        QTRY_VERIFY_WITH_TIMEOUT(device() && device()->mayNotMove.empty() && device()->liveness.heard, patience);
        window.selection().select(device()->id);
        const auto save = [&](const char *name) {
            QVERIFY(window.grab().save(
                folder.filePath(QStringLiteral("%1-%2-%3.png").arg(QLatin1String(name), options.size, theme))));
        };
        QTest::qWait(1200);
        save("overview");
        window.showPage(PageId::Parameters);
        QTest::qWait(2500);
        save("parameters");
        window.showPage(PageId::Tune);
        window.arming().arm(device()->id);
        SetPoint setPoint;
        setPoint.mode = Mode::Position;
        setPoint.target = 3000.0;
        window.arming().run(setPoint);
        QTest::qWait(2500);
        save("tune");
        auto *column = window.page(PageId::Tune)->findChild<QScrollArea *>();
        column->ensureWidgetVisible(window.findChild<QWidget *>(QStringLiteral("holdMoves")));
        QTest::qWait(100);
        save("moves");
        window.showPage(PageId::Plots);
        QTest::qWait(1500);
        save("plots");
        window.arming().disarm();
        window.showPage(PageId::Firmware);
        QTest::qWait(300);
        save("firmware");
    }
}

MB_WINDOW_TEST(SupermodifiedTest);
#include "tst_supermodified.moc"
