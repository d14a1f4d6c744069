// SPDX-License-Identifier: GPL-3.0-or-later
// A board with four axes in the window: tree, pages and plots over the real engine and the simulated board.
#include "askengine.h"
#include "model/axis.h"
#include "model/registry.h"
#include "support/windowtests.h"
#include "widgets/common/applytheme.h"
#include "widgets/common/banner.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/connection/devicetree.h"
#include "widgets/connection/overviewpage.h"
#include "widgets/control/axespanel.h"
#include "widgets/control/gainspanel.h"
#include "widgets/control/modepanel.h"
#include "widgets/control/setpointpanel.h"
#include "widgets/control/tunecolumn.h"
#include "widgets/control/tunepage.h"
#include "widgets/control/tuneplot.h"
#include "widgets/parameters/parameterspage.h"
#include "widgets/plots/plotspage.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDropEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QSplitter>
#include <QTest>
#include <QToolButton>
#include <QTreeView>

#include <algorithm>
#include <set>

using namespace mb;

namespace {

constexpr int axisPatience = 60000;
constexpr int axes = 4;

const Family &boards()
{
    const auto all = families();
    return **std::find_if(
        all.begin(), all.end(), [](const Family *candidate) { return candidate->capabilities.axes == axes; });
}
const std::array<const Family *, 1> onlyBoards{&boards()};

} // namespace

class AxesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init();
    void cleanup();
    void theTreeHasTheAxesUnderTheirBoardAndPagesFollowTheSelectedOne();
    void whatCannotBeReadIsUnknownUntilWritten();
    void eachAxisKeepsItsModeAndSetPoint();
    void fourAxesStepAtOnceInOnePlot();
    void oneAxisIsStoppedWhileAnotherGoesOn();
    void stopEndsAllOfThem();
    void gainsAreCopiedFromAnotherAxis();
    void channelsOfTheTreeComeIntoThePlotByDragAndDoubleClick();
    void everyControlHasAName();

private:
    [[nodiscard]] bool isOutputOn()
    {
        return test::askEngine<bool>(*m_engine, [](EngineCore &core) {
            return core.session().bench(*core.session().links().front())->simulators().front()->isOutputOn();
        });
    }
    [[nodiscard]] const DeviceView &board() const { return m_engine->snapshot().devices.front(); }
    [[nodiscard]] std::optional<double> latest(int axis, std::string_view key) const
    {
        const auto last = board().telemetry->last(*board().telemetry->find(axisKey(axis, key)));
        return last && !last->isGap() ? std::optional(last->value) : std::nullopt;
    }
    [[nodiscard]] std::vector<Point> samples(int axis, std::string_view key, Instant from) const
    {
        std::vector<Point> all;
        board().telemetry->forEach(*board().telemetry->find(axisKey(axis, key)), from, m_engine->now(),
            [&all](const Point &point) { all.push_back(point); });
        return all;
    }
    [[nodiscard]] AxesPanel &panel() { return m_tune->column().axesPanel(); }
    void select(int axis) { m_selection->select(board().id, axis); }
    void chooseMode(const char *name);
    void typeTarget(const QString &text);
    void arm();
    void run() { QTest::mouseClick(m_tune->findChild<CommandButton *>(QStringLiteral("run")), Qt::LeftButton); }
    [[nodiscard]] QModelIndex treeRow(int axis);
    void picture(QWidget &widget, const char *name);

    ThemeSource m_theme{darkTheme()};
    BannerStack m_banners{m_theme};
    std::unique_ptr<Engine> m_engine;
    std::unique_ptr<Selection> m_selection;
    std::unique_ptr<Arming> m_arming;
    std::unique_ptr<QSplitter> m_desk;
    DeviceTree *m_tree = nullptr;
    TunePage *m_tune = nullptr;
    PlotsPage *m_plots = nullptr;
    std::unique_ptr<ParametersPage> m_parameters;
};

void AxesTest::init()
{
    applyTheme(*qApp, m_theme.theme());
    m_engine = std::make_unique<Engine>(onlyBoards, false);
    m_selection = std::make_unique<Selection>();
    m_arming = std::make_unique<Arming>(*m_engine);
    m_desk = std::make_unique<QSplitter>();
    m_tree = new DeviceTree(*m_engine, *m_selection, m_theme, m_desk.get());
    m_tune = new TunePage(*m_engine, *m_selection, *m_arming, m_theme, m_desk.get());
    m_tune->showLive(true);
    m_plots = new PlotsPage(*m_engine, *m_selection, m_theme, m_desk.get());
    m_parameters = std::make_unique<ParametersPage>(*m_engine, *m_selection, m_theme, m_banners, nullptr);
    m_parameters->resize(1000, 800);
    m_parameters->show();
    m_desk->setSizes({240, 980, 980});
    m_desk->resize(2200, 1100);
    m_desk->show();
    QApplication::setActiveWindow(m_desk.get());
    m_engine->send(orders::OpenLink{*LinkAddress::parse("sim:spi")});
    m_engine->send(orders::ScanLinks{});
    QTRY_VERIFY_WITH_TIMEOUT(!m_engine->snapshot().devices.empty() && board().liveness.heard, axisPatience);
    QTRY_VERIFY_WITH_TIMEOUT(latest(axes, "position").has_value(), axisPatience);
}

void AxesTest::cleanup()
{
    m_parameters.reset();
    m_desk.reset();
    m_arming.reset();
    m_selection.reset();
    m_engine.reset();
}

void AxesTest::picture(QWidget &widget, const char *name)
{
    const QString folder = qEnvironmentVariable("MOTORBENCH_PICTURES");
    if (!folder.isEmpty())
        widget.grab().save(QDir(folder).filePath(QString::fromLatin1(name)));
}

QModelIndex AxesTest::treeRow(int axis)
{
    return m_tree->model().indexOf(board().id, axis);
}

void AxesTest::chooseMode(const char *name)
{
    const auto buttons = m_tune->column().modePanel().findChildren<QToolButton *>();
    const auto found = std::find_if(buttons.begin(), buttons.end(),
        [name](const QToolButton *button) { return button->text() == QLatin1String(name); });
    QVERIFY(found != buttons.end());
    QTest::mouseClick(*found, Qt::LeftButton);
}

void AxesTest::typeTarget(const QString &text)
{
    for (QLineEdit *field : m_tune->column().setPointPanel().findChildren<QLineEdit *>()) {
        if (field->accessibleName() == QLatin1String("Set-point")) {
            field->setFocus();
            field->selectAll();
            QTest::keyClicks(field, text);
        }
    }
}

void AxesTest::arm()
{
    QTRY_VERIFY_WITH_TIMEOUT(board().mayNotMove.empty(), axisPatience);
    m_arming->arm(board().id);
    QVERIFY(m_arming->isArmed(board().id));
}

void AxesTest::theTreeHasTheAxesUnderTheirBoardAndPagesFollowTheSelectedOne()
{
    DeviceModel &model = m_tree->model();
    const QModelIndex device = treeRow(0);
    QCOMPARE(model.rowCount(device), axes);
    QCOMPARE(model.index(2, 0, device).data().toString(), QStringLiteral("Axis 3"));
    QVERIFY2(!model.index(2, 0, device).data(DeviceModel::LineRole).toString().isEmpty(), "what it is told");
    QTRY_COMPARE(model.index(2, 0, device).data(DeviceModel::DetailRole).toString(), QStringLiteral("0"));
    auto *view = m_tree->findChild<QTreeView *>();
    QVERIFY2(view->isExpanded(device), "the axes are in sight from the beginning");
    QVERIFY2(!view->isExpanded(treeRow(1)), "the channels are not");
    QCOMPARE(model.rowCount(treeRow(3)), 4); // position, velocity, status, set-point
    QCOMPARE(m_parameters->view().shownRows(), 72);
    view->setCurrentIndex(treeRow(3));
    QCOMPARE(m_selection->axis(), 3);
    QCOMPARE(panel().axis(), 3);
    QTRY_COMPARE(m_parameters->view().shownRows(), 17);
    QCOMPARE(m_plots->board().traces().size(), std::size_t{2});
    QCOMPARE(m_plots->board().traces().front().style.name, QStringLiteral("#0 ch3 position"));
    picture(*m_desk, "axes-tree.png");
    picture(*m_parameters, "axes-parameters.png");
    QTest::mouseClick(panel().findChildren<QToolButton *>().at(1), Qt::LeftButton);
    QCOMPARE(m_selection->axis(), 2);
    QCOMPARE(view->currentIndex(), treeRow(2));
    view->setCurrentIndex(device);
    QCOMPARE(m_selection->axis(), 0);
    QTRY_COMPARE(m_parameters->view().shownRows(), 72);
    QCOMPARE(panel().axis(), 2); // of the board, the page shows the axis that was shown last
    QCOMPARE(m_plots->board().traces().size(), std::size_t{axes});
    picture(*m_parameters, "axes-parameters-board.png");
}

void AxesTest::whatCannotBeReadIsUnknownUntilWritten()
{
    select(1);
    chooseMode("Position");
    GainRow *p = m_tune->column().gainsPanel().row(Role::Proportional);
    QVERIFY(p);
    QVERIFY(!p->number());
    QCOMPARE(p->findChild<QLineEdit *>()->text(), QString());
    QVERIFY(p->findChild<QLineEdit *>()->isEnabled());
    const auto labels = p->findChildren<QLabel *>();
    QVERIFY(std::any_of(labels.begin(), labels.end(),
        [](const QLabel *label) { return label->text() == QLatin1String("unknown until written"); }));
    const auto index = findParameter(board().family->parameters, "ch1.position.p");
    QCOMPARE(m_parameters->model().standing(*index).text, QStringLiteral("unknown until written"));
    QVERIFY(!m_parameters->model().standing(*index).raw);
    const auto notes = m_tune->findChildren<QLabel *>();
    QVERIFY2(std::any_of(notes.begin(), notes.end(),
                 [](const QLabel *label) {
                     return label->isVisible() && label->text().contains(QStringLiteral("power limit of axis 1"));
                 }),
        "the first motion says what it is limited to");
}

void AxesTest::eachAxisKeepsItsModeAndSetPoint()
{
    select(1);
    chooseMode("Velocity");
    typeTarget(QStringLiteral("700"));
    select(2);
    chooseMode("Position");
    QTRY_COMPARE(m_tune->column().setPointPanel().target(), latest(2, "position"));
    typeTarget(QStringLiteral("-250"));
    select(1);
    QVERIFY(m_tune->column().modePanel().mode() == Mode::Velocity);
    QCOMPARE(m_tune->column().setPointPanel().target(), std::optional(700.0));
    select(2);
    QVERIFY(m_tune->column().modePanel().mode() == Mode::Position);
    QCOMPARE(m_tune->column().setPointPanel().target(), std::optional(-250.0));
}

void AxesTest::fourAxesStepAtOnceInOnePlot()
{
    m_selection->select(board().id); // the plots show all four positions
    QCOMPARE(m_plots->board().traces().size(), std::size_t{axes});
    const int pane = m_plots->board().traces().front().style.strip;
    std::set<TraceRole> colours;
    for (const PlotBoard::Trace &trace : m_plots->board().traces()) {
        QCOMPARE(trace.style.strip, pane);
        colours.insert(trace.style.look().colourRole());
    }
    QCOMPARE(colours.size(), std::size_t{axes});
    chooseMode("Position");
    typeTarget(QStringLiteral("800"));
    for (QComboBox *box : m_tune->column().setPointPanel().findChildren<QComboBox *>()) {
        if (box->accessibleName() == QLatin1String("How fast the set-point moves"))
            box->setCurrentIndex(0); // at once, as a step
    }
    panel().setTogether({1, 2, 3, 4});
    const auto links = panel().findChildren<QPushButton *>();
    QTest::mouseClick(links.back(), Qt::LeftButton); // the same for all
    QCOMPARE(panel().together(), (std::vector{1, 2, 3, 4}));
    QCOMPARE(m_tune->findChild<CommandButton *>(QStringLiteral("run"))->text(), QStringLiteral("Run 4 axes"));
    arm();
    std::array<double, axes> before{};
    for (int axis = 1; axis <= axes; ++axis)
        before[static_cast<std::size_t>(axis - 1)] = latest(axis, "position").value_or(0.0);
    const Instant begin = m_engine->now();
    run();
    const auto moved
        = [&](int axis) { return latest(axis, "position").value_or(0.0) - before[static_cast<std::size_t>(axis - 1)]; };
    QTRY_VERIFY_WITH_TIMEOUT(
        moved(1) > 100.0 && moved(2) > 100.0 && moved(3) > 100.0 && moved(4) > 100.0, axisPatience);
    QTest::qWait(1500);
    picture(*m_desk, "axes-step.png");
    std::array<Instant, axes> stepped{};
    std::array<Instant, axes> underWay{};
    for (int axis = 1; axis <= axes; ++axis) {
        const auto place = static_cast<std::size_t>(axis - 1);
        const auto wished = samples(axis, "setpoint", begin);
        const auto step = std::find_if(
            wished.begin(), wished.end(), [&](const Point &point) { return point.value > before[place] + 400.0; });
        QVERIFY2(step != wished.end(), "the step is in the recording");
        stepped[place] = step->time;
        const auto positions = samples(axis, "position", begin);
        const auto left = std::find_if(
            positions.begin(), positions.end(), [&](const Point &point) { return point.value > before[place] + 20.0; });
        QVERIFY(left != positions.end());
        underWay[place] = left->time;
    }
    const auto spread = [](const std::array<Instant, axes> &times) {
        const auto [first, last] = std::minmax_element(times.begin(), times.end());
        return std::chrono::duration<double, std::milli>(*last - *first).count();
    };
    qInfo(
        "set-points of the four axes %.2f ms apart, first 20 counts %.1f ms apart", spread(stepped), spread(underWay));
    QVERIFY2(spread(stepped) < 20.0, "they are told at the same moment");
    QVERIFY2(spread(underWay) < 200.0, "and move at the same time");
    QVERIFY2(m_tune->plot().stack().strips().traceCount() >= 8,
        "four positions and their set-points in the plot of the page");
    m_arming->disarm();
    QTRY_VERIFY_WITH_TIMEOUT(!isOutputOn(), axisPatience);
}

void AxesTest::oneAxisIsStoppedWhileAnotherGoesOn()
{
    select(1);
    chooseMode("Duty");
    typeTarget(QStringLiteral("20"));
    arm();
    run();
    QTRY_VERIFY_WITH_TIMEOUT(board().motion.on(1) != nullptr, axisPatience);
    select(2);
    QVERIFY2(m_arming->isMoving(), "another axis of the same board does not end it");
    chooseMode("Duty");
    QVERIFY2(m_arming->isMoving(), "nor does the mode of one that rests");
    typeTarget(QStringLiteral("20"));
    run();
    QTRY_VERIFY_WITH_TIMEOUT(board().motion.on(2) != nullptr, axisPatience);
    QTRY_VERIFY(m_tune->status().remedy.contains(QStringLiteral("also moving: axis 1")));
    QTest::qWait(600);
    picture(*m_desk, "axes-two.png");
    QTRY_COMPARE(treeRow(1).data(DeviceModel::GlyphRole).toInt(), static_cast<int>(GlyphState::Moving));
    m_tune->halt();
    QTRY_VERIFY_WITH_TIMEOUT(board().motion.on(2) == nullptr, axisPatience);
    QVERIFY(board().motion.on(1) != nullptr);
    QVERIFY(isOutputOn());
    select(1);
    m_tune->halt();
    QTRY_VERIFY_WITH_TIMEOUT(!isOutputOn(), axisPatience);
    QCOMPARE(m_arming->state(), LampState::Armed);
}

void AxesTest::stopEndsAllOfThem()
{
    select(4);
    chooseMode("Duty");
    typeTarget(QStringLiteral("15"));
    panel().setTogether({1, 2, 3, 4});
    QTest::mouseClick(panel().findChildren<QPushButton *>().back(), Qt::LeftButton);
    arm();
    run();
    QTRY_COMPARE_WITH_TIMEOUT(board().motion.setPoints.size(), std::size_t{axes}, axisPatience);
    QTRY_VERIFY_WITH_TIMEOUT(isOutputOn(), axisPatience);
    m_arming->stopAll(QStringLiteral("test"));
    QTRY_VERIFY_WITH_TIMEOUT(!isOutputOn(), axisPatience);
    QTRY_VERIFY(board().motion.on(1) == nullptr && board().motion.on(4) == nullptr);
}

void AxesTest::gainsAreCopiedFromAnotherAxis()
{
    const auto p1 = *findParameter(board().family->parameters, "ch1.position.p");
    const auto written = [this, p1] {
        if ((*board().parameters)[p1.value].raw == 321)
            return true;
        m_engine->send(orders::WriteParameters{board().id, {{p1, 321}}}); // refused while the page still reads
        return false;
    };
    QTRY_VERIFY_WITH_TIMEOUT(written(), axisPatience);
    select(2);
    chooseMode("Position");
    Q_EMIT panel().copyGainsRequested(1);
    QCOMPARE(m_tune->column().gainsPanel().row(Role::Proportional)->number(), std::optional(321.0));
    QVERIFY(!m_tune->column().gainsPanel().toWrite().empty());
    const auto *write = m_tune->findChild<CommandButton *>(QStringLiteral("writeGains"));
    QTRY_VERIFY_WITH_TIMEOUT(write->isEnabled(), axisPatience); // the write before may still be under way
    m_tune->write();
    const auto p2 = *findParameter(board().family->parameters, "ch2.position.p");
    QTRY_VERIFY_WITH_TIMEOUT((*board().parameters)[p2.value].raw == 321, axisPatience);
    QVERIFY((*board().parameters)[p2.value].state == ParameterState::Assumed);
}

void AxesTest::channelsOfTheTreeComeIntoThePlotByDragAndDoubleClick()
{
    select(1);
    DeviceModel &model = m_tree->model();
    m_plots->board().setTraces({}, true);
    QTRY_VERIFY(m_plots->board().traces().empty());
    const std::unique_ptr<QMimeData> whole(model.mimeData({treeRow(2)}));
    QVERIFY(whole && (model.flags(treeRow(2)) & Qt::ItemIsDragEnabled) != 0);
    auto *empty = m_plots->stack().parentWidget(); // nothing is plotted: the area says so and takes it
    QDragEnterEvent entering(QPoint(300, 300), Qt::CopyAction, whole.get(), Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(empty, &entering);
    QVERIFY(entering.isAccepted());
    QDropEvent onNothing(QPointF(300, 300), Qt::CopyAction, whole.get(), Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(empty, &onNothing);
    QCOMPARE(m_plots->board().traces().size(), std::size_t{2});
    const QModelIndex velocity = model.index(1, 0, treeRow(4));
    const std::unique_ptr<QMimeData> one(model.mimeData({velocity}));
    QTest::qWait(100);
    const QPoint at(m_plots->stack().width() / 2, m_plots->stack().height() / 4); // the upper pane: positions
    QDragEnterEvent enter(at, Qt::CopyAction, one.get(), Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&m_plots->stack(), &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent onPane(at, Qt::CopyAction, one.get(), Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&m_plots->stack(), &onPane);
    QCOMPARE(m_plots->board().traces().size(), std::size_t{3});
    QCOMPARE(m_plots->board().traces().back().style.name, QStringLiteral("#0 ch4 velocity"));
    QCOMPARE(m_plots->board().traces().back().style.strip, m_plots->board().traces().front().style.strip);
    std::vector<Signal> wanted;
    connect(m_tree, &DeviceTree::plotRequested, this, [&](const std::vector<Signal> &all) { wanted = all; });
    auto *view = m_tree->findChild<QTreeView *>();
    view->expand(treeRow(4));
    view->scrollTo(velocity);
    const QPoint row = view->visualRect(velocity).center();
    QTest::mouseClick(view->viewport(), Qt::LeftButton, {}, row);
    QTest::mouseDClick(view->viewport(), Qt::LeftButton, {}, row);
    QCOMPARE(wanted.size(), std::size_t{1});
    QVERIFY(board().family->channels[wanted.front().channel.value].key == "ch4.velocity");
    QCOMPARE(m_selection->axis(), 4);
    QCOMPARE(view->currentIndex(), velocity);
}

void AxesTest::everyControlHasAName()
{
    select(1);
    for (QWidget *widget : panel().findChildren<QWidget *>()) {
        if (auto *button = qobject_cast<QAbstractButton *>(widget))
            QVERIFY(!button->accessibleName().isEmpty() || !button->text().isEmpty());
    }
    for (QLineEdit *field : m_tune->column().setPointPanel().findChildren<QLineEdit *>())
        QVERIFY(!field->accessibleName().isEmpty());
}

MB_WINDOW_TEST(AxesTest);
#include "tst_axes.moc"
