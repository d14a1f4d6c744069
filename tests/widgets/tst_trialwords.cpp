// SPDX-License-Identifier: GPL-3.0-or-later
// What ended a trial has words in the window, whatever it was.
#include "experiment/verdict.h"
#include "support/windowtests.h"
#include "widgets/control/trialwords.h"

#include <QTest>
#include <QTranslator>

using namespace mb;

namespace {

/// Puts every text that is translated at all into brackets.
class Brackets : public QTranslator {
public:
    bool isEmpty() const override { return false; }
    QString translate(const char * /*context*/, const char *source, const char * /*comment*/, int /*n*/) const override
    {
        return QLatin1Char('[') + QString::fromUtf8(source) + QLatin1Char(']');
    }
};

QString wordsOf(const tuning::Ending &ending)
{
    tuning::Trial trial;
    tuning::nameEnding(trial, ending);
    return guardText(trial.reason);
}

} // namespace

class TestTrialWords : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { QCoreApplication::installTranslator(&m_brackets); }
    void cleanupTestCase() { QCoreApplication::removeTranslator(&m_brackets); }
    void everyReasonHasWords();
    void everyEndOfTheSetPointsHasWords();

private:
    Brackets m_brackets;
};

void TestTrialWords::everyReasonHasWords()
{
    for (int each = static_cast<int>(tuning::EndReason::Done); each <= static_cast<int>(tuning::EndReason::Unknown);
         ++each) {
        const QString words = guardText(static_cast<tuning::EndReason>(each));
        QVERIFY2(words.startsWith(QLatin1Char('[')), qPrintable(words));
    }
}

void TestTrialWords::everyEndOfTheSetPointsHasWords()
{
    using End = SetPointStream::End;
    int ends = 0;
    for (End end = End::None; !toString(end).empty(); end = End(++ends)) {
        tuning::Ending ending;
        ending.stream = end;
        const QString words = wordsOf(ending);
        QVERIFY2(words.startsWith(QLatin1Char('[')), qPrintable(words));
    }
    QVERIFY(ends > static_cast<int>(End::Refused));
}

MB_WINDOW_TEST(TestTrialWords);
#include "tst_trialwords.moc"
