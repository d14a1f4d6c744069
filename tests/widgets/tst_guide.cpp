// SPDX-License-Identifier: GPL-3.0-or-later
// A guide through a story that goes while it waits for an answer.
#include "parameterbench.h"
#include "support/windowtests.h"
#include "widgets/control/arming.h"
#include "widgets/start/guide.h"

#include <QTest>

#include <optional>

using namespace mb;
using namespace mb::test;

class GuideTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aListOfTrialsThatComesAfterTheGuideIsGoneIsNoOnes();
};

/// The window is made anew while the notebook is asked.
void GuideTest::aListOfTrialsThatComesAfterTheGuideIsGoneIsNoOnes()
{
    FakeWorkbench workbench;
    Selection selection;
    Arming arming(workbench);
    workbench.shot.devices = {readDrive(1, 7)};
    workbench.shot.devices.front().link = "sim:can";
    std::optional<Guide> guide(std::in_place, workbench, selection, arming, nullptr);
    const auto bytes = [&guide] { // of the place where it is, or was
        return QByteArray(reinterpret_cast<const char *>(&guide), sizeof guide);
    };
    guide->begin(stories().front());
    workbench.publish();
    guide.reset();
    const QByteArray left = bytes();
    QTest::qWait(0);
    QCOMPARE(bytes(), left);
}

MB_WINDOW_TEST(GuideTest);
#include "tst_guide.moc"
