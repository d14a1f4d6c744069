// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/windowtests.h"
#include "widgets/common/theme.h"
#include "widgets/common/turningrow.h"

#include <QTest>

using namespace mb;

namespace {

constexpr int besideFrom = 300; ///< units

/// A part that keeps its area, as text that wraps does.
class Wrapping : public QWidget {
public:
    Wrapping() { setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Minimum); }
    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override { return 12000 / std::max(width, 1); }
    [[nodiscard]] QSize sizeHint() const override { return {150, heightForWidth(150)}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {100, 20}; }
};

class Row : public TurningRow {
public:
    explicit Row(const ThemeSource &theme)
        : TurningRow(theme, besideFrom, nullptr)
    {
        parts().setSpacing(8);
        parts().setContentsMargins(3, 4, 5, 6);
        parts().addWidget(new Wrapping, 2);
        parts().addWidget(new Wrapping, 1);
    }
    int requests = 0;

protected:
    bool event(QEvent *event) override
    {
        requests += event->type() == QEvent::LayoutRequest ? 1 : 0;
        return TurningRow::event(event);
    }
};

} // namespace

class TurningTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void askingForAHeightTurnsNothingAndLaysNothingOut();
    void theHeightThatItNamesIsTheHeightThatItTakes_data();
    void theHeightThatItNamesIsTheHeightThatItTakes();
};

void TurningTest::askingForAHeightTurnsNothingAndLaysNothingOut()
{
    const ThemeSource theme(darkTheme());
    Row row(theme);
    row.resize(theme.theme().u(2 * besideFrom), 200);
    row.show();
    QCoreApplication::processEvents();
    QVERIFY(!row.isTurned());
    row.requests = 0;
    QVERIFY(row.parts().heightForWidth(theme.theme().u(besideFrom) - 1) > row.parts().heightForWidth(row.width()));
    QCoreApplication::processEvents();
    QVERIFY(!row.isTurned());
    QCOMPARE(row.requests, 0);
}

void TurningTest::theHeightThatItNamesIsTheHeightThatItTakes_data()
{
    QTest::addColumn<int>("units");
    QTest::newRow("beside each other") << besideFrom;
    QTest::newRow("one below the other") << besideFrom - 1;
}

void TurningTest::theHeightThatItNamesIsTheHeightThatItTakes()
{
    QFETCH(int, units);
    const ThemeSource theme(darkTheme());
    Row row(theme);
    const int width = theme.theme().u(units);
    row.resize(width, 600);
    row.show();
    QCoreApplication::processEvents();
    QCOMPARE(row.isTurned(), units < besideFrom);
    int end = 0;
    for (int i = 0; i < row.parts().count(); ++i) {
        const QRect place = row.parts().itemAt(i)->geometry();
        const int needed = row.parts().itemAt(i)->heightForWidth(place.width());
        end = row.isTurned() ? end + needed + (i > 0 ? 8 : 0) : std::max(end, needed);
    }
    QCOMPARE(row.parts().heightForWidth(width), end + 4 + 6);
}

MB_WINDOW_TEST(TurningTest);
#include "tst_turning.moc"
