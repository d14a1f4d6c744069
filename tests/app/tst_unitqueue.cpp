// SPDX-License-Identifier: GPL-3.0-or-later
// The queue of the page Firmware over units with trouble, on the program's own engine.
#include "app/engine.h"
#include "app/servicedoor.h"
#include "model/registry.h"
#include "support/windowtests.h"
#include "widgets/common/selection.h"
#include "widgets/common/theme.h"
#include "widgets/firmware/firmwarepage.h"
#include "widgets/firmware/queueboard.h"
#include "widgets/firmware/queuemodel.h"

#include <QTest>

using namespace mb;
using service::RowState;

namespace {

constexpr int patience = 120000;

/// Units of one family on a bench of their own, behind the page.
struct UnitBench {
    UnitBench(const char *key, std::vector<std::string> units)
        : texts(std::move(units))
        , family(*findFamily(families(), key))
    {
        show({texts.begin(), texts.end()});
        engine = std::make_unique<Engine>(only, false);
        door = new ServiceDoor(*engine);
        page = std::make_unique<FirmwarePage>(*engine, selection, theme);
        page->setService(*door, only);
        page->showQueue(true);
        page->resize(1280, 720);
        page->show();
    }
    ~UnitBench()
    {
        page.reset();
        engine.reset();
    }
    UnitBench(const UnitBench &) = delete;
    UnitBench &operator=(const UnitBench &) = delete;
    /// What a link that is opened next finds.
    void show(std::vector<std::string_view> bench)
    {
        views = std::move(bench);
        family.bench = views;
    }
    void open(const std::string &link) { engine->send(orders::OpenLink{*LinkAddress::parse(link)}); }
    [[nodiscard]] std::size_t found() const { return engine->snapshot().devices.size(); }
    [[nodiscard]] QueueBoard &board() const { return *page->queue(); }
    [[nodiscard]] std::vector<QueueLine> in(RowState state) const
    {
        std::vector<QueueLine> lines;
        for (const QueueLine &line : board().model().lines()) {
            if (line.row != 0 && line.state == state)
                lines.push_back(line);
        }
        return lines;
    }
    std::vector<std::string> texts;
    std::vector<std::string_view> views;
    Family family;
    std::array<const Family *, 1> only{&family};
    ThemeSource theme{darkTheme()};
    Selection selection;
    std::unique_ptr<Engine> engine;
    ServiceDoor *door = nullptr;
    std::unique_ptr<FirmwarePage> page;
};

} // namespace

class UnitQueueTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aDuplicateAndWrongHardwareAreRefusedInTheirRowsAndTheRestGoesOn();
};

void UnitQueueTest::aDuplicateAndWrongHardwareAreRefusedInTheirRowsAndTheRestGoesOn()
{
    UnitBench bench("dmc60c",
        {"dmc60c:5,serial=210334000001,firmware=1.23", "dmc60c:6,serial=210334000002,session=0x1111",
            "dmc60c:6,serial=210334000003,session=0x2222", "dmc60c:7,serial=210334000004,product=601",
            "dmc60c:8,serial=210334000005,firmware=1.23"});
    bench.open("sim:can");
    QTRY_COMPARE_WITH_TIMEOUT(bench.found(), std::size_t(5), patience);
    QVERIFY(bench.board().openImage(QStringLiteral(":/firmware/dmc60c-demo.hex")));
    bench.board().model().tickAll(true);
    QTRY_VERIFY_WITH_TIMEOUT(bench.board().canStart(), patience);
    bench.board().start();
    QTRY_COMPARE_WITH_TIMEOUT(bench.in(RowState::Passed).size(), std::size_t(2), patience);
    QTRY_VERIFY_WITH_TIMEOUT(!bench.door->view().running, patience);
    const auto refused = bench.in(RowState::Refused);
    QCOMPARE(refused.size(), std::size_t(3));
    for (const QueueLine &line : refused) {
        QCOMPARE(line.step, QStringLiteral("refused before start"));
        const bool isOther = line.serial == QLatin1String("210334000004");
        QVERIFY2(line.result.contains(QLatin1String(isOther ? "product 601" : "several units answer as number 6")),
            qPrintable(line.result));
    }
    QStringList served;
    for (const QueueLine &line : bench.in(RowState::Passed))
        served << line.serial;
    QCOMPARE(served, QStringList({QStringLiteral("210334000001"), QStringLiteral("210334000005")}));
}

MB_WINDOW_TEST(UnitQueueTest);
#include "tst_unitqueue.moc"
