// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/framefilterparser.h"

#include "widgets/monitor/framefilterterms.h"

#include <QRegularExpression>

namespace mb {
namespace {

using Join = FilterTree::Join;

constexpr int deepest = 100;

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

FilterTree FrameFilterParser::parse(const QString &text)
{
    m_words = wordsOf(text);
    if (m_words.isEmpty())
        return {};
    m_tree.root = anyOf();
    if (m_problem.isEmpty() && !atEnd())
        fail(tr("')' has no '(' before it"));
    return std::move(m_tree);
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

std::size_t FrameFilterParser::add(FilterTree::Node node)
{
    m_tree.nodes.push_back(std::move(node));
    return m_tree.nodes.size() - 1;
}

std::size_t FrameFilterParser::anyOf()
{
    std::size_t node = allOf();
    while (isNext("or")) {
        ++m_next;
        node = add({Join::Or, node, allOf(), {}});
    }
    return node;
}

std::size_t FrameFilterParser::allOf()
{
    std::size_t node = one();
    while (!atEnd() && !isNext("or") && !isNext(")")) {
        if (isNext("and"))
            ++m_next;
        node = add({Join::And, node, one(), {}});
    }
    return node;
}

std::size_t FrameFilterParser::one()
{
    if (m_depth == deepest) {
        fail(tr("more than %1 brackets and negations inside each other").arg(deepest));
        return 0;
    }
    ++m_depth;
    const std::size_t node = inner();
    --m_depth;
    return node;
}

std::size_t FrameFilterParser::inner()
{
    if (atEnd() || isNext("or") || isNext("and") || isNext(")")) {
        const bool first = m_next == 0;
        fail(first ? tr("'%1' needs a term before it").arg(m_words.value(m_next))
                   : tr("a term is missing after '%1'").arg(m_words.value(m_next - 1)));
        return 0;
    }
    QString word = m_words[m_next++];
    if (word.compare(QLatin1String("not"), Qt::CaseInsensitive) == 0 || word == QLatin1String("-"))
        return add({Join::Not, one(), 0, {}});
    if (word.size() > 1 && (word[0] == QLatin1Char('-') || word[0] == QLatin1Char('!')))
        return add({Join::Not, addTerm(word.mid(1)), 0, {}});
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
    const FrameTermReader read(word);
    if (!read.problem().isEmpty())
        fail(read.problem());
    const std::size_t node = add({Join::Term, 0, 0, read.term()});
    return read.isTurned() ? add({Join::Not, node, 0, {}}) : node;
}

} // namespace mb
