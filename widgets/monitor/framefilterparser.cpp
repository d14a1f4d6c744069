// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/framefilterparser.h"

#include <QRegularExpression>

namespace mb {
namespace {

/// Words and brackets; blanks around a comparison do not part it.
QStringList wordsOf(QString text)
{
    static const QRegularExpression loose(QStringLiteral("\\s*(>=|<=|!=|==|=|<|>)\\s*"));
    static const QRegularExpression bracket(QStringLiteral("([()])"));
    static const QRegularExpression blanks(QStringLiteral("\\s+"));
    text.replace(loose, QStringLiteral("\\1"));
    text.replace(bracket, QStringLiteral(" \\1 "));
    return text.split(blanks, Qt::SkipEmptyParts);
}

} // namespace

QString FrameFilterParser::parse(const QString &text)
{
    m_words = wordsOf(text);
    if (m_words.isEmpty())
        return {};
    m_filter.m_root = anyOf();
    if (m_problem.isEmpty() && !atEnd())
        fail(tr("')' has no '(' before it"));
    return m_problem;
}

void FrameFilterParser::fail(const QString &problem)
{
    if (m_problem.isEmpty())
        m_problem = problem;
    m_next = m_words.size();
}

bool FrameFilterParser::isNext(const char *word) const
{
    return !atEnd() && m_words[m_next].compare(QLatin1String(word), Qt::CaseInsensitive) == 0;
}

std::size_t FrameFilterParser::add(FrameFilter::Join join, std::size_t left, std::size_t right)
{
    m_filter.m_nodes.push_back({join, left, right, {}});
    return m_filter.m_nodes.size() - 1;
}

std::size_t FrameFilterParser::anyOf()
{
    std::size_t node = allOf();
    while (isNext("or")) {
        ++m_next;
        node = add(FrameFilter::Join::Or, node, allOf());
    }
    return node;
}

std::size_t FrameFilterParser::allOf()
{
    std::size_t node = one();
    while (!atEnd() && !isNext("or") && !isNext(")")) {
        if (isNext("and"))
            ++m_next;
        node = add(FrameFilter::Join::And, node, one());
    }
    return node;
}

std::size_t FrameFilterParser::one()
{
    if (atEnd() || isNext("or") || isNext("and") || isNext(")")) {
        const bool first = m_next == 0;
        fail(first ? tr("'%1' needs a term before it").arg(m_words.value(m_next))
                   : tr("a term is missing after '%1'").arg(m_words.value(m_next - 1)));
        return 0;
    }
    QString word = m_words[m_next++];
    if (word.compare(QLatin1String("not"), Qt::CaseInsensitive) == 0 || word == QLatin1String("-"))
        return add(FrameFilter::Join::Not, one(), 0);
    if (word.size() > 1 && (word[0] == QLatin1Char('-') || word[0] == QLatin1Char('!')))
        return add(FrameFilter::Join::Not, addTerm(word.mid(1)), 0);
    if (word != QLatin1String("("))
        return addTerm(word);
    const std::size_t node = anyOf();
    if (m_problem.isEmpty() && !isNext(")"))
        fail(tr("'(' is not closed: a ')' is missing"));
    ++m_next;
    return node;
}

std::size_t FrameFilterParser::addTerm(const QString &word)
{
    Term term;
    bool turned = false;
    const int colon = word.indexOf(QLatin1Char(':'));
    if (word.startsWith(QLatin1String("field."), Qt::CaseInsensitive)) {
        readField(word.mid(6), term);
    } else if (colon < 0 && word.contains(QRegularExpression(QStringLiteral("[<>=]")))) {
        fail(tr("'%1': a comparison begins with field., such as field.%1").arg(word));
    } else if (colon < 0) {
        term.patterns = {'*' + word.toLower().toStdString() + '*'};
    } else {
        const QString key = word.left(colon).toLower();
        const QString value = word.mid(colon + 1);
        if (value.isEmpty())
            fail(tr("'%1:' has nothing after the colon").arg(key));
        else if (key == QLatin1String("dir") || key == QLatin1String("is"))
            turned = readState(key, value.toLower(), term);
        else
            readKeyed(key, value, term);
    }
    m_filter.m_nodes.push_back({FrameFilter::Join::Term, 0, 0, std::move(term)});
    const std::size_t node = m_filter.m_nodes.size() - 1;
    return turned ? add(FrameFilter::Join::Not, node, 0) : node;
}

} // namespace mb
