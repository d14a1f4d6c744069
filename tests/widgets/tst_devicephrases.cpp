// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/windowtests.h"
#include "widgets/common/devicetext.h"

#include <QTest>
#include <QTranslator>

#include <map>

namespace mb {
namespace {

/// Knows a few sentences and nothing else.
class FewWords : public QTranslator {
public:
    bool isEmpty() const override { return false; }
    QString translate(const char *context, const char *source, const char *, int) const override
    {
        static const std::map<std::string, const char *> words{{"%1: %2", "%1: %2"},
            {"page %1: %2, sent again", "Seite %1: %2, erneut gesendet"},
            {"no status within 2 s", "kein Status in 2 s"},
            {"%1 is above %2; legal is %3", "%3 ist erlaubt, %1 ist mehr als %2"}, {"the device is gone", "Gerät weg"},
            {"%1 is gone", "%1 weg"}, {"Velocity", "Drehzahl"}};
        const auto found = words.find(source);
        const bool known = std::string(context) == "table" && found != words.end();
        return known ? QString::fromUtf8(found->second) : QString();
    }
};

} // namespace

class DevicePhrasesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() { QVERIFY(QCoreApplication::installTranslator(&m_words)); }
    void cleanup() { QCoreApplication::removeTranslator(&m_words); }
    void translates_data()
    {
        QTest::addColumn<QByteArray>("english");
        QTest::addColumn<QString>("expected");
        const auto row = [](const char *english, const char *expected) {
            QTest::newRow(english) << QByteArray(english) << QString::fromUtf8(expected);
        };
        row("Velocity", "Drehzahl");
        row("the device is gone", "Gerät weg"); // though "%1 is gone" fits too
        row("can0 is gone", "can0 weg");
        row("page 5: no status within 2 s, sent again", "Seite 5: kein Status in 2 s, erneut gesendet");
        row("slot0.p: 3 is above 2; legal is 0 … 2", "0 … 2 ist erlaubt, slot0.p: 3 ist mehr als 2");
        row("page 5: the moon is full, sent again", "Seite 5: the moon is full, erneut gesendet");
        row("%1 is gone", "%1 weg"); // a value that looks like a placeholder
        row("100 %2 is above 7; legal is 1", "1 ist erlaubt, 100 %2 ist mehr als 7");
        row(" is gone", " is gone");
        row("something new", "something new");
        row("", "");
    }
    void translates()
    {
        QFETCH(QByteArray, english);
        QTEST(tableText(std::string_view(english.constData(), static_cast<std::size_t>(english.size()))), "expected");
    }
    void saysTheSameInEnglish()
    {
        QCoreApplication::removeTranslator(&m_words);
        for (const char *text : {"page 5: no status within 2 s, sent again", "%1: %2: %3", "3 bytes", "P"})
            QCOMPARE(tableText(text), QString::fromUtf8(text));
    }

private:
    FewWords m_words;
};

} // namespace mb

MB_WINDOW_TEST(mb::DevicePhrasesTest);
#include "tst_devicephrases.moc"
