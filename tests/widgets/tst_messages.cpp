// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/windowtests.h"
#include "widgets/common/devicetext.h"

#include <QTest>
#include <QTranslator>

#include <map>

Q_DECLARE_METATYPE(mb::Message);

namespace mb {
namespace {

/// Knows a few sentences and nothing else.
class FewWords : public QTranslator {
public:
    bool isEmpty() const override { return false; }
    QString translate(const char *context, const char *source, const char *, int) const override
    {
        static const std::map<std::string, const char *> words{
            {"page %1: %2, sent again", "Seite %1: %2, erneut gesendet"},
            {"no status within 2 s", "kein Status in 2 s"},
            {"%1: %2 is above %3", "%3 ist erlaubt, %1 ist mit %2 mehr"}, {"legal is %1", "erlaubt ist %1"},
            {"%1 is gone", "%1 weg"}, {"Velocity", "Drehzahl"}};
        const auto found = words.find(source);
        const bool known = std::string(context) == "table" && found != words.end();
        return known ? QString::fromUtf8(found->second) : QString();
    }
};

} // namespace

class MessagesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() { QVERIFY(QCoreApplication::installTranslator(&m_words)); }
    void cleanup() { QCoreApplication::removeTranslator(&m_words); }
    void translates_data()
    {
        QTest::addColumn<Message>("message");
        QTest::addColumn<QString>("expected");
        const auto row = [](const char *name, const Message &message, const char *expected) {
            QTest::newRow(name) << message << QString::fromUtf8(expected);
        };
        row("a label", Message::label("Velocity"), "Drehzahl");
        row("a name stands as it is", say("%1 is gone", "can0"), "can0 weg");
        row("a name that is a word of a table stands as it is", say("%1 is gone", "Velocity"), "Velocity weg");
        row("a message inside one is translated with it",
            say("page %1: %2, sent again", 5, say("no status within 2 s")),
            "Seite 5: kein Status in 2 s, erneut gesendet");
        row("places in another order", say("%1: %2 is above %3", "slot0.p", 3.5, 2),
            "2 ist erlaubt, slot0.p ist mit 3.5 mehr");
        row("a value that looks like a place", say("%1 is gone", "100 %1"), "100 %1 weg");
        row("decimals and unit", say("legal is %1", MessageNumber{2.5, 2, "V"}), "erlaubt ist 2.50 V");
        row("one that nobody has translated", say("something new of %1", 7), "something new of 7");
        row("the words of somebody else", Message::verbatim("Velocity"), "Velocity");
        row("nothing", Message(), "");
    }
    void numbersAreShownInGroupsAndWrittenPlainInAFile()
    {
        const Message said = say("%1 counts, number %2", -1600000.5, 21033416);
        QCOMPARE(messageText(said),
            QStringLiteral("\u22121\u202F600\u202F000.5 counts, number 21033416")); // a number of a thing is a name
        QCOMPARE(messageText(said, QLatin1Char('.')), QStringLiteral("-1600000.5 counts, number 21033416"));
    }
    void translates()
    {
        QFETCH(Message, message);
        QTEST(messageText(message), "expected");
    }
    void anErrorIsItsCauseThenItsRemedy()
    {
        const Error error{Fault::OutOfRange, say("%1: %2 is above %3", "p", 3, 2), say("legal is %1", "0 … 2")};
        QCOMPARE(errorText(error), QStringLiteral("2 ist erlaubt, p ist mit 3 mehr; erlaubt ist 0 … 2"));
    }
    void saysTheSameInEnglish()
    {
        QCoreApplication::removeTranslator(&m_words);
        const Message message = say("page %1: %2, sent again", 5, say("no status within 2 s"));
        QCOMPARE(messageText(message), QString::fromStdString(message.english()));
    }

private:
    FewWords m_words;
};

} // namespace mb

MB_WINDOW_TEST(mb::MessagesTest);
#include "tst_messages.moc"
