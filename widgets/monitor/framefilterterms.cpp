// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/framefilterterms.h"

#include "model/registry.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/numberformat.h"

#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <map>

namespace mb {
namespace {

struct Key {
    const char *name;
    int key;
};
enum KeyKind { IdKey, FamilyKey, MessageKey, DeviceKey, DirectionKey, DataKey, IsKey };
constexpr std::array keys{
    Key{"id", IdKey},
    Key{"family", FamilyKey},
    Key{"fam", FamilyKey},
    Key{"message", MessageKey},
    Key{"msg", MessageKey},
    Key{"device", DeviceKey},
    Key{"dev", DeviceKey},
    Key{"dir", DirectionKey},
    Key{"data", DataKey},
    Key{"is", IsKey},
};

std::vector<std::string> patternsOf(const QString &value)
{
    std::vector<std::string> patterns;
    for (const QString &part : value.split(QLatin1Char(','), Qt::SkipEmptyParts))
        patterns.push_back(part.toLower().toStdString());
    return patterns;
}

/// How many letters must be changed, added or taken away.
int distance(const QString &a, const QString &b)
{
    std::vector<int> row(static_cast<std::size_t>(b.size()) + 1);
    for (std::size_t j = 0; j < row.size(); ++j)
        row[j] = static_cast<int>(j);
    for (int i = 0; i < a.size(); ++i) {
        int diagonal = row[0];
        row[0] = i + 1;
        for (int j = 0; j < b.size(); ++j) {
            const auto at = static_cast<std::size_t>(j) + 1;
            const int changed = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[at];
            row[at] = std::min({changed, row[at] + 1, row[at - 1] + 1});
        }
    }
    return row.back();
}

QString nearestKey(const QString &word)
{
    const auto *const best = std::ranges::min_element(keys, [&word](const Key &a, const Key &b) {
        return distance(word, QLatin1String(a.name)) < distance(word, QLatin1String(b.name));
    });
    return distance(word, QLatin1String(best->name)) <= 2 ? QLatin1String(best->name) : QString();
}

QString withoutPrefix(QString digits)
{
    return digits.startsWith(QLatin1String("0x"), Qt::CaseInsensitive) ? digits.mid(2) : digits;
}

} // namespace

FrameTermReader::FrameTermReader(const QString &word)
{
    static const QRegularExpression comparison(QStringLiteral("[<>=]"));
    const int colon = word.indexOf(QLatin1Char(':'));
    const QString key = word.left(colon).toLower();
    const QString value = word.mid(colon + 1);
    if (word.startsWith(QLatin1String("field."), Qt::CaseInsensitive))
        readField(word.mid(6));
    else if (colon < 0 && word.contains(comparison))
        fail(tr("'%1': a comparison begins with field., such as field.%1").arg(word));
    else if (colon < 0)
        m_term.patterns = {'*' + word.toLower().toStdString() + '*'};
    else if (value.isEmpty())
        fail(tr("'%1:' has nothing after the colon").arg(key));
    else if (key == QLatin1String("dir") || key == QLatin1String("is"))
        readState(key, value.toLower());
    else
        readKeyed(key, value);
}

void FrameTermReader::readKeyed(const QString &key, const QString &value)
{
    const auto *const known = std::ranges::find_if(keys, [&key](const Key &k) { return key == QLatin1String(k.name); });
    if (known == keys.end()) {
        const QString near = nearestKey(key);
        fail(near.isEmpty()
                ? tr("'%1:' is not known; id, family, message, device, dir, data, is and field. are").arg(key)
                : tr("'%1:' is not known; '%2:' is").arg(key, near));
        return;
    }
    switch (known->key) {
    case IdKey: return readIds(value);
    case FamilyKey: return readFamilies(value);
    case DeviceKey: return readDevices(value);
    case DataKey: return readData(value);
    default: m_term.test = Test::Message; m_term.patterns = patternsOf(value);
    }
}

void FrameTermReader::readIds(const QString &value)
{
    static const QRegularExpression shape(QStringLiteral("^[0-9A-Fa-f*?]{1,9}$"));
    m_term.test = Test::Id;
    for (const QString &part : value.split(QLatin1Char(','), Qt::SkipEmptyParts)) {
        const QStringList ends = part.split(QStringLiteral(".."));
        const QString from = withoutPrefix(ends.first());
        const QString to = withoutPrefix(ends.last());
        bool fromGood = false;
        bool toGood = false;
        const FilterTerm::Range range{from.toUInt(&fromGood, 16), to.toUInt(&toGood, 16)};
        if (ends.size() <= 2 && fromGood && toGood)
            m_term.ranges.push_back(range);
        else if (ends.size() == 1 && shape.match(from).hasMatch())
            m_term.patterns.push_back(from.toLower().toStdString());
        else
            return fail(tr("'%1' is no identifier: hexadecimal such as 0x2061405, 0x2061* or 100..1FF").arg(part));
    }
}

void FrameTermReader::readDevices(const QString &value)
{
    m_term.test = Test::Device;
    for (const QString &part : value.split(QLatin1Char(','), Qt::SkipEmptyParts)) {
        const QStringList ends = part.split(QStringLiteral(".."));
        bool fromGood = false;
        bool toGood = false;
        const FilterTerm::Range range{ends.first().toUInt(&fromGood), ends.last().toUInt(&toGood)};
        if (ends.size() > 2 || !fromGood || !toGood)
            return fail(tr("'%1' is no device number: such as 5, 5,7 or 1..9").arg(part));
        m_term.ranges.push_back(range);
    }
}

void FrameTermReader::readData(const QString &value)
{
    static const QRegularExpression shape(QStringLiteral("^[0-9A-Fa-f*?]+$"));
    m_term.test = Test::Data;
    for (const QString &part : value.split(QLatin1Char(','), Qt::SkipEmptyParts)) {
        if (!shape.match(part).hasMatch())
            return fail(tr("'%1' are no bytes: hexadecimal such as A125*, without blanks").arg(part));
        m_term.patterns.push_back(part.toLower().toStdString());
    }
}

void FrameTermReader::readFamilies(const QString &value)
{
    m_term.test = Test::Family;
    m_term.patterns = patternsOf(value);
    QStringList known;
    for (const Family *family : families())
        known += qt(family->key);
    for (const std::string &pattern : m_term.patterns) {
        if (std::ranges::none_of(
                families(), [&pattern](const Family *family) { return wildcardMatches(pattern, family->key); }))
            return fail(tr("no family is called '%1'; there is %2").arg(qt(pattern), known.join(QStringLiteral(", "))));
    }
}

void FrameTermReader::readState(const QString &key, const QString &value)
{
    struct State {
        const char *name;
        Test test;
        bool turned;
    };
    static constexpr std::array states{State{"tx", Test::Sent, false}, State{"rx", Test::Sent, true},
        State{"extended", Test::Extended, false}, State{"standard", Test::Extended, true},
        State{"remote", Test::Remote, false}, State{"error", Test::Error, false},
        State{"unknown", Test::Unknown, false}, State{"known", Test::Unknown, true},
        State{"control", Test::Control, false}};
    const bool direction = key == QLatin1String("dir");
    const auto end = direction ? states.begin() + 2 : states.end();
    const auto found = std::find_if(
        states.begin(), end, [&value](const State &state) { return value == QLatin1String(state.name); });
    if (found == end) {
        fail(direction ? tr("'dir:%1' is not known; dir:rx and dir:tx are").arg(value)
                       : tr("'is:%1' is not known; tx, rx, extended, standard, remote, error, unknown, known and "
                            "control are")
                             .arg(value));
        return;
    }
    m_term.test = found->test;
    m_turned = found->turned;
}

void FrameTermReader::readField(const QString &word)
{
    using Comparison = FilterTerm::Comparison;
    static const QRegularExpression shape(QStringLiteral("^([^<>=!:]*)(?:(>=|<=|!=|==|=|<|>|:)(.*))?$"));
    static const std::map<QString, Comparison> comparisons{{QStringLiteral(">="), Comparison::AtLeast},
        {QStringLiteral("<="), Comparison::AtMost}, {QStringLiteral("!="), Comparison::Differs},
        {QStringLiteral("=="), Comparison::Equal}, {QStringLiteral("="), Comparison::Equal},
        {QStringLiteral(":"), Comparison::Equal}, {QStringLiteral("<"), Comparison::Less},
        {QStringLiteral(">"), Comparison::More}};
    const auto match = shape.match(word);
    m_term.test = Test::Field;
    m_term.patterns = {match.captured(1).toLower().toStdString()};
    if (!match.hasMatch() || match.captured(1).isEmpty())
        return fail(tr("'field.' needs the name of a field, such as field.trgt>100"));
    const QString sign = match.captured(2);
    if (sign.isEmpty())
        return;
    m_term.comparison = comparisons.at(sign);
    QString value = match.captured(3);
    m_term.percent = value.endsWith(QLatin1Char('%'));
    if (m_term.percent)
        value.chop(1);
    const auto whole = parseInteger(value);
    const auto number = whole ? std::optional<double>(static_cast<double>(*whole)) : parseNumber(value);
    if (!number)
        return fail(value.isEmpty() ? tr("'field.%1%2' needs a number behind it").arg(match.captured(1), sign)
                                    : tr("'%1' is no number").arg(value));
    m_term.number = *number;
}

QString FrameTermReader::help()
{
    struct Line {
        const char *example;
        QString text;
    };
    const std::array lines{
        Line{"id:0x2061* &nbsp; id:100..1FF &nbsp; id:123,124", tr("identifier, hexadecimal")},
        Line{"family:dmc60c &nbsp; message:STS* &nbsp; device:5,7", tr("what the decoder says")},
        Line{"field.velcnt&gt;1000 &nbsp; field.dtcApplied&lt;=-50% &nbsp; field.perc",
            tr("a field by its name: its number, % of full scale, or that there is one")},
        Line{"data:A125* &nbsp; data:??00*", tr("bytes, hexadecimal")},
        Line{"dir:tx &nbsp; is:error &nbsp; is:unknown &nbsp; is:control",
            tr("direction; error, remote, extended, standard, unknown, known; makes a motor move")},
        Line{"gen", tr("a bare word: part of a message, family or identifier")},
        Line{"not … &nbsp; -… &nbsp; … or … &nbsp; ( … )", tr("terms beside each other must all hold")},
    };
    QString text = QStringLiteral("<table cellspacing='4'>");
    for (const Line &line : lines)
        text += QStringLiteral("<tr><td><code>%1</code></td><td>%2</td></tr>")
                    .arg(QString::fromUtf8(line.example), line.text);
    return text + QStringLiteral("</table>") + tr("* stands for any characters, ? for one, a comma for or.");
}

} // namespace mb
