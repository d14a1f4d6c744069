// SPDX-License-Identifier: GPL-3.0-or-later
// What the tree of devices selects, which is what somebody chose; and whose menu a row has.
#include "parameterbench.h"
#include "support/utf8.h"
#include "support/windowtests.h"
#include "widgets/common/searchfield.h"
#include "widgets/connection/devicetree.h"

#include <QMenu>
#include <QSignalSpy>
#include <QTreeView>

#include <algorithm>

using namespace mb;
using namespace mb::test;

class DeviceTreeTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void whatTheFilterHidesStaysSelected();
    void aUnitThatIsNumberedAnewStaysSelected();
    void whatIsGoneSelectsNoOther();
    void whatTheProgramHasChosenIsNoChoiceOfSomebody();
    void theMenuOfALinkIsOfThatLink();
    void aLinkOnWhichUnitsAreServedIsNotClosed();
};

namespace {

/// The tree over three units of one link, of which one is selected.
struct TreeBench {
    FakeWorkbench workbench;
    Selection selection;
    ThemeSource theme{lightTheme()};
    std::unique_ptr<DeviceTree> tree;
    std::unique_ptr<QSignalSpy> changes;

    explicit TreeBench(DeviceId selected)
    {
        addLink(workbench.shot, "can0");
        workbench.shot.devices = {driveAt(1, 5, "can0"), driveAt(2, 7, "can0"), driveAt(3, 63, "can0")};
        selection.select(selected);
        tree = std::make_unique<DeviceTree>(workbench, selection, theme);
        tree->resize(240, 600);
        tree->show();
        changes = std::make_unique<QSignalSpy>(&selection, &Selection::changed);
    }
    [[nodiscard]] QTreeView &view() const { return *tree->findChild<QTreeView *>(); }
    [[nodiscard]] DeviceId shown() const { return tree->model().deviceAt(view().currentIndex()); }
};

} // namespace

void DeviceTreeTest::whatTheFilterHidesStaysSelected()
{
    const TreeBench bench({1});
    auto *filter = bench.tree->findChild<SearchField *>();
    filter->setText(s("#7"));
    QVERIFY(!bench.tree->model().indexOf({1}).isValid());
    QCOMPARE(bench.selection.device(), DeviceId{1});
    QVERIFY(bench.view().selectionModel()->selectedRows().isEmpty());
    filter->clear();
    QCOMPARE(bench.shown(), DeviceId{1});
    QCOMPARE(bench.changes->size(), 0);
}

void DeviceTreeTest::aUnitThatIsNumberedAnewStaysSelected()
{
    TreeBench bench({3});
    QTreeView &view = bench.view();
    view.expand(bench.tree->model().indexOf({3}));
    std::vector<DeviceView> &devices = bench.workbench.shot.devices;
    devices[2].identity.edit().address = 3;
    std::rotate(devices.begin(), devices.begin() + 2, devices.end());
    bench.workbench.publish();
    QCOMPARE(bench.tree->model().indexOf({3}).row(), 0);
    QCOMPARE(bench.selection.device(), DeviceId{3});
    QCOMPARE(bench.shown(), DeviceId{3});
    QVERIFY(view.isExpanded(bench.tree->model().indexOf({3})));
    QCOMPARE(bench.changes->size(), 0);
}

void DeviceTreeTest::whatIsGoneSelectsNoOther()
{
    TreeBench bench({2});
    const DeviceView gone = bench.workbench.shot.devices[1];
    bench.workbench.shot.devices.erase(bench.workbench.shot.devices.begin() + 1);
    bench.workbench.publish();
    QCOMPARE(bench.selection.device(), DeviceId{2});
    QCOMPARE(bench.shown(), DeviceId{});
    bench.workbench.shot.devices.push_back(gone);
    bench.workbench.publish();
    QCOMPARE(bench.shown(), DeviceId{2});
    QCOMPARE(bench.changes->size(), 0);
    bench.view().setCurrentIndex(bench.tree->model().indexOf({1})); // somebody does
    QCOMPARE(bench.selection.device(), DeviceId{1});
}

void DeviceTreeTest::whatTheProgramHasChosenIsNoChoiceOfSomebody()
{
    TreeBench bench({});
    std::vector<DeviceView> found;
    std::swap(found, bench.workbench.shot.devices);
    Selection selection;
    DeviceTree tree(bench.workbench, selection, bench.theme);
    const QSignalSpy kept(&selection, &Selection::kept);
    bench.workbench.shot.devices = found;
    bench.workbench.publish();
    auto *view = tree.findChild<QTreeView *>();
    QCOMPARE(selection.device(), DeviceId{1});
    QCOMPARE(view->currentIndex(), tree.model().indexOf({1}));
    QCOMPARE(kept.size(), 0);
    view->setCurrentIndex(tree.model().indexOf({2})); // somebody does
    QCOMPARE(selection.device(), DeviceId{2});
    QCOMPARE(kept.size(), 1);
}

void DeviceTreeTest::theMenuOfALinkIsOfThatLink()
{
    TreeBench bench({1});
    addLink(bench.workbench.shot, "can1");
    bench.workbench.publish();
    std::swap(bench.workbench.shot.links[0], bench.workbench.shot.links[1]); // closed and opened anew
    bench.workbench.publish();
    const QModelIndex first = bench.tree->model().index(0, 0);
    QCOMPARE(first.data().toString(), s("can0"));
    const QSignalSpy closed(bench.tree.get(), &DeviceTree::closeLinkRequested);
    Q_EMIT bench.view().customContextMenuRequested(bench.view().visualRect(first).center());
    for (QAction *action : bench.tree->findChild<QMenu *>()->actions()) {
        if (action->text() == s("Close this link"))
            action->trigger();
    }
    QCOMPARE(closed.size(), 1);
    QCOMPARE(closed.at(0).at(0).toString(), s("can0"));
}

void DeviceTreeTest::aLinkOnWhichUnitsAreServedIsNotClosed()
{
    TreeBench bench({1});
    for (const bool served : {true, false}) {
        bench.workbench.serve({}, served);
        bench.workbench.served.links = {"can0"};
        Q_EMIT bench.view().customContextMenuRequested(
            bench.view().visualRect(bench.tree->model().index(0, 0)).center());
        const auto menus = bench.tree->findChildren<QMenu *>();
        const auto actions = menus.back()->actions();
        const auto close = std::find_if(actions.begin(), actions.end(),
            [](const QAction *action) { return action->text() == s("Close this link"); });
        QVERIFY(close != actions.end());
        QCOMPARE((*close)->isEnabled(), !served);
        menus.back()->close();
    }
}

MB_WINDOW_TEST(DeviceTreeTest);
#include "tst_devicetree.moc"
