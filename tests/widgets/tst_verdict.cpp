// SPDX-License-Identifier: GPL-3.0-or-later
// PASS and FAIL: told apart by word and by shape, also without colour, and large enough for 3 m.
#include "support/windowtests.h"
#include "widgets/common/theme.h"
#include "widgets/service/verdictview.h"

#include <QImage>
#include <QTest>

using namespace mb;

namespace {

using Kind = Verdict::Kind;

constexpr std::array kinds{Kind::Waiting, Kind::Working, Kind::Passed, Kind::Failed, Kind::Refused, Kind::LeftOut};
constexpr int wideShape = 170; ///< the shape stands in these columns, the words beside it
constexpr int farLetters = 57; ///< pixels at 96 dpi: 15 mm, a two hundredth of 3 m

Verdict verdictOf(Kind kind)
{
    Verdict verdict;
    verdict.kind = kind;
    verdict.unit = QStringLiteral("2103343A7B2E");
    verdict.number = QStringLiteral("#36");
    return verdict;
}

QImage grey(const Theme &theme, const Verdict &verdict)
{
    const ThemeSource source(theme);
    VerdictView view(source);
    view.setVerdict(verdict);
    view.resize(840, 360);
    return view.grab().toImage().convertToFormat(QImage::Format_Grayscale8);
}

int ink(const QImage &image, int x, int y, int ground)
{
    return std::abs(qGray(image.pixel(x, y)) - ground);
}

/// Of the strokes in a part of a picture, whatever the shades: where it is inked.
std::vector<bool> strokes(const QImage &image, const QRect &part)
{
    const int ground = qGray(image.pixel(part.right(), part.top()));
    std::vector<bool> inked;
    for (int y = part.top(); y < part.bottom(); ++y) {
        for (int x = part.left(); x < part.right(); ++x)
            inked.push_back(ink(image, x, y, ground) > 40);
    }
    return inked;
}

} // namespace

class TestVerdict : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everyVerdictHasAWordOfItsOwn();
    void everyVerdictHasAShapeOfItsOwnWithoutColour();
    void theWordIsReadAtThreeMetres();
    void theCauseIsReadInTheSmallestPictureAtTwiceTheFont();
    void strokesStandOutFromTheGround();
    void smallPrintIsReadInASmallPictureToo();
    void aScreenReaderHearsIt();
};

void TestVerdict::everyVerdictHasAWordOfItsOwn()
{
    QSet<QString> words;
    for (const Kind kind : kinds)
        words.insert(VerdictView::wordOf(kind));
    QCOMPARE(words.size(), int(kinds.size()));
}

void TestVerdict::everyVerdictHasAShapeOfItsOwnWithoutColour()
{
    for (const Theme &theme : {darkTheme(), lightTheme()}) {
        for (const Kind a : kinds) {
            for (const Kind b : kinds) {
                if (a >= b)
                    continue;
                const QRect part(20, 20, wideShape - 20, 160);
                const auto first = strokes(grey(theme, verdictOf(a)), part);
                const auto second = strokes(grey(theme, verdictOf(b)), part);
                int different = 0;
                for (std::size_t i = 0; i < first.size(); ++i)
                    different += first[i] != second[i] ? 1 : 0;
                QVERIFY2(different > 500, qPrintable(QString::number(different)));
            }
        }
    }
}

void TestVerdict::theWordIsReadAtThreeMetres()
{
    for (const Kind kind : {Kind::Passed, Kind::Failed}) {
        const QImage image = grey(darkTheme(), verdictOf(kind));
        const int ground = qGray(image.pixel(wideShape + 8, 20));
        int rows = 0;
        int tallest = 0;
        for (int y = 12; y < 200; ++y) {
            bool inked = false;
            for (int x = wideShape + 20; x < 560 && !inked; ++x)
                inked = ink(image, x, y, ground) > 60;
            rows = inked ? rows + 1 : 0;
            tallest = std::max(tallest, rows);
        }
        QVERIFY2(tallest >= farLetters, qPrintable(QString::number(tallest)));
    }
}

void TestVerdict::smallPrintIsReadInASmallPictureToo()
{
    const ThemeSource source(darkTheme());
    VerdictView view(source);
    Verdict verdict = verdictOf(Kind::Passed);
    verdict.facts = {{QStringLiteral("HHHH"), QStringLiteral("HHHH"), {}}};
    view.setVerdict(verdict);
    view.resize(504, 252); // 0.6 of what it likes to be
    const QImage image = view.grab().toImage().convertToFormat(QImage::Format_Grayscale8);
    const int ground = qGray(image.pixel(image.width() / 2, image.height() - 12));
    int rows = 0;
    std::vector<int> lines; // their heights, from the bottom up
    for (int y = image.height() - 12; y > 96; --y) {
        bool inked = false;
        for (int x = 34; x < 100 && !inked; ++x)
            inked = ink(image, x, y, ground) > 60;
        if (!inked && rows > 0)
            lines.push_back(rows);
        rows = inked ? rows + 1 : 0;
    }
    QVERIFY(lines.size() >= 2);
    const auto capital
        = [&](TextRole role) { return QFontMetrics(source.theme().font(role, view.font())).capHeight(); };
    QVERIFY2(lines[0] >= capital(TextRole::Large) - 2, qPrintable(QString::number(lines[0])));
    QVERIFY2(lines[1] >= capital(TextRole::Caption) - 1, qPrintable(QString::number(lines[1])));
}

void TestVerdict::theCauseIsReadInTheSmallestPictureAtTwiceTheFont()
{
    const ThemeSource source(darkTheme(20.0));
    VerdictView view(source);
    view.resize(view.minimumSizeHint().width() * 2, view.minimumSizeHint().height());
    Verdict failed = verdictOf(Kind::Failed);
    failed.next = QStringLiteral("F5 tests again");
    const auto draw = [&](const QString &cause, const QString &unit) {
        failed.cause = cause;
        failed.unit = unit;
        view.setVerdict(failed);
        return view.grab().toImage();
    };
    const auto rowsThatDiffer = [](const QImage &a, const QImage &b) {
        std::vector<int> rows;
        for (int y = 0; y < a.height(); ++y) {
            if (!std::equal(a.constScanLine(y), a.constScanLine(y) + a.bytesPerLine(), b.constScanLine(y)))
                rows.push_back(y);
        }
        return rows;
    };
    const QImage shown = draw(QStringLiteral("HHHH"), QStringLiteral("HHHH"));
    const std::vector<int> cause = rowsThatDiffer(shown, draw({}, QStringLiteral("HHHH")));
    const std::vector<int> unit = rowsThatDiffer(shown, draw(QStringLiteral("HHHH"), {}));
    const QImage same = draw(QStringLiteral("HHHH"), QStringLiteral("HHHH"));
    failed.next = QStringLiteral("FFFF");
    const std::vector<int> next = rowsThatDiffer(same, draw(QStringLiteral("HHHH"), QStringLiteral("HHHH")));
    QVERIFY(!cause.empty() && !unit.empty() && !next.empty());
    QVERIFY2(static_cast<int>(cause.size()) >= 12, qPrintable(QString::number(cause.size())));
    QVERIFY(unit.back() < cause.front());
    QVERIFY(cause.back() < next.front());
}

void TestVerdict::strokesStandOutFromTheGround()
{
    for (const Theme &theme : {darkTheme(), lightTheme()}) {
        QVERIFY(contrast(theme.ok, theme.bannerOk) >= 4.5);
        QVERIFY(contrast(theme.danger, theme.bannerDanger) >= 4.5);
        QVERIFY(contrast(theme.caution, theme.bannerCaution) >= 4.5);
    }
}

void TestVerdict::aScreenReaderHearsIt()
{
    const ThemeSource theme(darkTheme());
    VerdictView view(theme);
    Verdict failed = verdictOf(Kind::Failed);
    failed.cause = QStringLiteral("kS reads 0.61 V");
    failed.remedy = QStringLiteral("Free the shaft and test again");
    view.setVerdict(failed);
    QCOMPARE(view.accessibleName(), QStringLiteral("FAIL 2103343A7B2E"));
    QVERIFY(view.accessibleDescription().contains(failed.cause));
    QVERIFY(view.accessibleDescription().contains(failed.remedy));
}

MB_WINDOW_TEST(TestVerdict);
#include "tst_verdict.moc"
