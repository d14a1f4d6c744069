// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/framefilter.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/numberformat.h"

#include <QCoreApplication>
#include <QRegularExpression>

namespace mb {
namespace {

struct FrameText {
    Q_DECLARE_TR_FUNCTIONS(FrameText)
};

bool wildcard(const QString &pattern, const QString &text)
{
    const QRegularExpression expression(
        QRegularExpression::wildcardToRegularExpression(pattern), QRegularExpression::CaseInsensitiveOption);
    return expression.match(text).hasMatch();
}

} // namespace

QString hexId(const CanFrame &frame)
{
    return QStringLiteral("%1").arg(frame.id, frame.extended || frame.error ? 8 : 3, 16, QLatin1Char('0')).toUpper();
}

QString hexBytes(const CanFrame &frame)
{
    if (frame.remote)
        return FrameText::tr("remote");
    QString text;
    for (const std::uint8_t byte : frame.bytes())
        text += (text.isEmpty() ? QString() : QStringLiteral(" "))
            + QStringLiteral("%1").arg(byte, 2, 16, QLatin1Char('0')).toUpper();
    return text;
}

QString fieldsLine(const DecodedFrame &frame)
{
    QStringList parts;
    for (const DecodedField &field : frame.fields) {
        // A flag that is off says nothing in a line; the detail panel has it.
        if (field.name.starts_with('f') && field.unit.empty() && field.value == 0.0)
            continue;
        const bool unitSpeaks = !field.unit.empty() && !field.unit.starts_with("1/");
        const QString unit = !unitSpeaks ? QString() : QLatin1Char(' ') + qt(field.unit);
        parts += qt(field.name) + QLatin1Char('=') + QString::fromStdString(numberText(field.value)) + unit;
    }
    return parts.join(QStringLiteral("  "));
}

FrameFilter::FrameFilter(const QString &text)
{
    const QStringList words = text.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    for (QString word : words) {
        Term term;
        term.negated = word.size() > 1 && word.startsWith(QLatin1Char('-'));
        if (term.negated)
            word.remove(0, 1);
        const int colon = word.indexOf(QLatin1Char(':'));
        const QString key = colon < 0 ? QString() : word.left(colon).toLower();
        term.pattern = word.mid(colon + 1);
        if (colon < 0)
            term.key = Key::Any;
        else if (key == QLatin1String("msg"))
            term.key = Key::Message;
        else if (key == QLatin1String("dev"))
            term.key = Key::Device;
        else if (key == QLatin1String("id"))
            term.key = Key::Id;
        else if (key == QLatin1String("fam"))
            term.key = Key::Family;
        else if (key == QLatin1String("dir"))
            term.key = Key::Direction;
        else {
            m_problem = FrameText::tr("'%1:' is not known; msg, dev, id, fam and dir are").arg(key);
            continue;
        }
        if (!term.pattern.isEmpty())
            m_terms.push_back(term);
    }
}

bool FrameFilter::passes(const FrameRow &row) const
{
    for (const Term &term : m_terms) {
        if (holds(term, row) == term.negated)
            return false;
    }
    return true;
}

bool FrameFilter::holds(const Term &term, const FrameRow &row)
{
    const QString message = row.decoded ? qt(row.decoded->message) : QString();
    switch (term.key) {
    case Key::Any: {
        const QString pattern = QLatin1Char('*') + term.pattern + QLatin1Char('*');
        return wildcard(pattern, message) || wildcard(pattern, hexId(row.record.frame));
    }
    case Key::Message: return wildcard(term.pattern, message);
    case Key::Device: return row.decoded && wildcard(term.pattern, QString::number(row.decoded->address));
    case Key::Id: return wildcard(term.pattern + QLatin1Char('*'), hexId(row.record.frame));
    case Key::Family: return row.family && wildcard(term.pattern, qt(row.family->key));
    case Key::Direction:
        return wildcard(
            term.pattern, row.record.direction == Direction::Sent ? QStringLiteral("tx") : QStringLiteral("rx"));
    }
    return false;
}

} // namespace mb
