// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/framefilter.h"

#include "widgets/monitor/framefilterparser.h"
#include "widgets/monitor/framefilterterms.h"

namespace mb {

FrameFilter::FrameFilter(const QString &text)
{
    FrameFilterParser parser;
    m_tree = parser.parse(text);
    m_problem = parser.problem();
    if (!m_problem.isEmpty())
        m_tree.nodes.clear();
}

QString FrameFilter::help()
{
    return FrameTermReader::help();
}

FrameFilter FrameFilter::both(FrameFilter a, const FrameFilter &b)
{
    if (a.isEmpty())
        return b;
    if (b.isEmpty())
        return a;
    std::vector<FilterTree::Node> &nodes = a.m_tree.nodes;
    const std::size_t shift = nodes.size();
    for (FilterTree::Node node : b.m_tree.nodes) {
        node.left += shift;
        node.right += shift;
        nodes.push_back(std::move(node));
    }
    nodes.push_back({FilterTree::Join::And, a.m_tree.root, b.m_tree.root + shift, {}});
    a.m_tree.root = nodes.size() - 1;
    return a;
}

bool FrameFilter::holds(std::size_t node, const FrameFacts &facts) const
{
    using Join = FilterTree::Join;
    const FilterTree::Node &at = m_tree.nodes[node];
    switch (at.join) {
    case Join::Term: return mb::holds(at.term, facts);
    case Join::Not: return !holds(at.left, facts);
    case Join::And: return holds(at.left, facts) && holds(at.right, facts);
    case Join::Or: return holds(at.left, facts) || holds(at.right, facts);
    }
    return false;
}

} // namespace mb
