// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/fakeworkbench.h"
#include "support/windowtests.h"
#include "widgets/connection/doctorcard.h"

#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QPushButton>
#include <QTest>

using namespace mb;

class DoctorTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aLinkThatIsDownHasACommandToCopy();
    void aLostLinkCanBeReconnected();
    void nothingIsShownWhileAllIsWell();
    void aLinkThatWasAskedForInVainCanBeTriedAgain();
    void theEmptyPageListsEveryLink();
    void aRowStaysWhileItSaysTheSame();
    void absentInterfacesAreNoNewsWhileALinkIsOpen();

private:
    [[nodiscard]] static LinkListing down()
    {
        const Diagnosis found{
            Ailment::Down, say("can0 is switched off"), say("bring it up"), "sudo ip link set can0 up"};
        return {{"socketcan", "can0", {}}, LinkKind::Can, ListingState::Down, found.message(), false, found, false};
    }
    [[nodiscard]] static LinkListing good()
    {
        return {{"socketcan", "can1", {}}, LinkKind::Can, ListingState::Up, Message::verbatim("gs_usb, 1 Mbit/s"), true,
            {}, false};
    }
    [[nodiscard]] static LinkView open(const char *address)
    {
        LinkView link;
        link.address = address;
        link.state = LinkState::Open;
        return link;
    }
    [[nodiscard]] static QStringList texts(const QWidget &card)
    {
        QStringList all;
        for (const QLabel *label : card.findChildren<QLabel *>())
            all += label->text();
        return all;
    }
    [[nodiscard]] static QPushButton *button(const QWidget &card, const QString &text)
    {
        for (QPushButton *one : card.findChildren<QPushButton *>()) {
            if (one->text() == text)
                return one;
        }
        return nullptr;
    }

    ThemeSource m_theme{darkTheme()};
};

void DoctorTest::aLinkThatIsDownHasACommandToCopy()
{
    test::FakeWorkbench bench;
    bench.links = {down()};
    bench.shot.links = {open("socketcan:can1")};
    DoctorCard card(bench, m_theme, false);
    card.follow();
    QVERIFY(card.isVisibleTo(nullptr));
    QVERIFY(texts(card).contains(QStringLiteral("can0 is switched off; bring it up")));
    QVERIFY(texts(card).contains(QStringLiteral("sudo ip link set can0 up")));
    QPushButton *copy = button(card, QStringLiteral("Copy command"));
    QVERIFY(copy);
    copy->click();
    QCOMPARE(QApplication::clipboard()->text(), QStringLiteral("sudo ip link set can0 up"));
    QCOMPARE(bench.lines.size(), std::size_t(1));
    QVERIFY(!button(card, QStringLiteral("Reconnect")));
}

void DoctorTest::aLostLinkCanBeReconnected()
{
    test::FakeWorkbench bench;
    LinkView lost = open("socketcan:can0");
    lost.state = LinkState::Lost;
    lost.diagnosis = {Ailment::Gone, say("can0 is gone"), say("plug the adapter in again"), ""};
    bench.shot.links = {lost};
    DoctorCard card(bench, m_theme, false);
    card.follow();
    QPushButton *again = button(card, QStringLiteral("Reconnect"));
    QVERIFY(again);
    again->click();
    QCOMPARE(bench.given<orders::OpenLink>().size(), std::size_t(1));
    QCOMPARE(bench.given<orders::OpenLink>().front().address.text(), std::string("socketcan:can0"));
    QVERIFY(!button(card, QStringLiteral("Copy command")));
}

void DoctorTest::nothingIsShownWhileAllIsWell()
{
    test::FakeWorkbench bench;
    bench.links = {good()};
    bench.shot.links = {open("socketcan:can1")};
    DoctorCard card(bench, m_theme, false);
    card.follow();
    QVERIFY(card.isHidden());
    bench.shot.links.front().diagnosis
        = {Ailment::NobodyAcknowledges, say("nobody acknowledges what can1 sends"), say("check the cable"), ""};
    card.follow();
    QVERIFY(!card.isHidden());
    bench.shot.links.front().diagnosis = {};
    card.follow();
    QVERIFY(card.isHidden());
}

void DoctorTest::aLinkThatWasAskedForInVainCanBeTriedAgain()
{
    test::FakeWorkbench bench;
    bench.shot.links = {open("sim:can")};
    bench.shot.failed
        = {{"serial:/dev/ttyUSB0", {Ailment::Busy, say("/dev/ttyUSB0 is busy"), say("close the other program"), ""}}};
    DoctorCard card(bench, m_theme, false);
    card.follow();
    QVERIFY(texts(card).contains(QStringLiteral("/dev/ttyUSB0 is busy; close the other program")));
    QPushButton *again = button(card, QStringLiteral("Reconnect"));
    QVERIFY(again);
    again->click();
    QCOMPARE(bench.given<orders::OpenLink>().front().address.text(), std::string("serial:/dev/ttyUSB0"));
}

void DoctorTest::theEmptyPageListsEveryLink()
{
    test::FakeWorkbench bench;
    bench.links = {down(), good()};
    DoctorCard card(bench, m_theme, true);
    card.follow();
    QVERIFY(texts(card).contains(QStringLiteral("socketcan:can0")));
    QVERIFY(texts(card).contains(QStringLiteral("socketcan:can1")));
    QVERIFY(texts(card).contains(QStringLiteral("gs_usb, 1 Mbit/s")));
    bench.links.clear();
    card.follow();
    QVERIFY2(!card.isHidden() && !texts(card).contains(QStringLiteral("socketcan:can0")), "what went is not shown");
}

void DoctorTest::aRowStaysWhileItSaysTheSame()
{
    test::FakeWorkbench bench;
    bench.links = {down()};
    DoctorCard card(bench, m_theme, true);
    card.follow();
    const QPushButton *before = button(card, QStringLiteral("Copy command"));
    card.follow();
    QCOMPARE(button(card, QStringLiteral("Copy command")), before);
}

void DoctorTest::absentInterfacesAreNoNewsWhileALinkIsOpen()
{
    test::FakeWorkbench bench;
    const Diagnosis none{
        Ailment::NoCan, say("this kernel has no CAN support"), say("load it"), "sudo modprobe can_raw"};
    bench.links = {{{"socketcan", "", {}}, LinkKind::Can, ListingState::Absent, none.message(), false, none, false}};
    bench.shot.links = {open("sim:can")};
    DoctorCard card(bench, m_theme, false);
    card.follow();
    QVERIFY(card.isHidden());
    bench.shot.links.clear();
    DoctorCard all(bench, m_theme, true);
    all.follow();
    QVERIFY(texts(all).contains(QStringLiteral("this kernel has no CAN support; load it")));
    QVERIFY2(!texts(all).contains(QStringLiteral("socketcan:")), "an address that names nothing");
}

MB_WINDOW_TEST(DoctorTest);
#include "tst_doctor.moc"
